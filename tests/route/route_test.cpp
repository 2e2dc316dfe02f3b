#include "path/route/route.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "route/worlds.hpp"

namespace strandline::route {
namespace {

const CurveLimits limits{0.5, 40};

void expect_drivable(const Way& way, const CurvatureState& from, const CurvatureState& to,
                     const CurveLimits& most) {
    const Curve& curve = way.curve;
    const Pose end = end_pose(curve);
    EXPECT_NEAR(distance(curve.start.at, from.pose.at), 0, 1e-12);
    EXPECT_NEAR(wrap_angle(curve.start.heading - from.pose.heading), 0, 1e-12);
    EXPECT_NEAR(distance(end.at, to.pose.at), 0, 1e-7);
    EXPECT_NEAR(wrap_angle(end.heading - to.pose.heading), 0, 1e-7);
    ASSERT_FALSE(curve.pieces.empty());
    EXPECT_NEAR(curve.pieces.front().curvature, from.curvature, 1e-9);
    EXPECT_NEAR(curve.pieces.back().end_curvature(), to.curvature, 1e-9);
    const double right = most.right_radius > 0 ? most.right_radius : most.radius;
    for (const Clothoid& piece : curve.pieces)
        for (const double k : {piece.curvature, piece.end_curvature()}) {
            EXPECT_LE(k * most.radius, 1 + 1e-9);
            EXPECT_GE(k * right, -1 - 1e-9);
        }
    EXPECT_LE(max_sharpness(curve), most.sharpness * (1 + 1e-9));
    EXPECT_LT(max_curvature_jump(curve), 1e-8);
}

/// By the outlines themselves, not by the ground's cells.
double least_distance(const Regions& obstacles, const Curve& curve) {
    double least = 1e9;
    for (const CurvePoint& p : sampled(curve, 0.005))
        for (const Region& region : obstacles)
            least = std::min(
                least, contains(region.outer, p.pose.at) ? 0 : distance_to_outline(region.outer, p.pose.at));
    return least;
}

Region square(Point low, double side) {
    return {{low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}}, {}};
}

TEST(Route, WithoutObstaclesItIsTheShortestCurve) {
    const Ground ground({.clearance = 0.3});
    const CurvatureState from{{{0, 0}, 1}, 0.5}, to{{{4, 1}, -1}, -1};
    const Way way = route::way(ground, from, to, {.limits = limits});
    EXPECT_EQ(way.curve, continuous_curvature(from, to, limits));
    EXPECT_EQ(way.blemish, 0);
}

TEST(Route, ASquareInTheWayIsPassedOnItsNearSideJustAtTheClearance) {
    Ground ground({.clearance = 0.3});
    ground.add(square({4, -0.5}, 2));
    const CurvatureState from{{{0, 0}, 0}, 0}, to{{{10, 0}, 0}, 0};
    const Way way = route::way(ground, from, to, {.limits = limits});
    expect_drivable(way, from, to, limits);
    EXPECT_EQ(way.blemish, 0);
    const double least = least_distance({square({4, -0.5}, 2)}, way.curve);
    EXPECT_GE(least, 0.3);
    EXPECT_LE(least, 0.36);
    for (const CurvePoint& p : sampled(way.curve, 0.1))
        EXPECT_LT(p.pose.at.y, 0.1) << "the lower side is nearer";
    EXPECT_LT(length(way.curve), 1.02 * taut_length(ground, from.pose.at, to.pose.at));
    EXPECT_EQ(way.through.size(), 1U) << "between the two corners";
}

TEST(Route, TheFieldIsNotLeft) {
    Ground ground({.clearance = 0.2});
    const Polygon field{{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 2}, {2, 2}, {2, 6}, {0, 6}};  // a U
    ground.add_field({field, {}});
    const CurvatureState from{{{1, 5}, -pi / 2}, 0}, to{{{5, 5}, pi / 2}, 0};
    const Way way = route::way(ground, from, to, {.limits = limits});
    expect_drivable(way, from, to, limits);
    EXPECT_EQ(way.blemish, 0);
    for (const CurvePoint& p : sampled(way.curve, 0.02)) {
        EXPECT_TRUE(contains(field, p.pose.at));
        EXPECT_GE(distance_to_outline(field, p.pose.at), 0.2);
    }
}

TEST(Route, WhereNoWayIsTheLeastBadOneIsTakenAndSaid) {
    Ground ground({.clearance = 0.2});
    Region ring = square({-5, -5}, 10);
    ring.holes = {{{-3, -3}, {-3, 3}, {3, 3}, {3, -3}}};
    ground.add(ring);
    const CurvatureState from{{{0, 0}, 0}, 0}, to{{{10, 0}, 0}, 0};
    const Way way = route::way(ground, from, to, {.limits = limits});
    expect_drivable(way, from, to, limits);
    EXPECT_NEAR(way.blemish, 2.4, 0.05) << "straight over the ring, 2 m thick";
    EXPECT_TRUE(std::isinf(taut_length(ground, from.pose.at, to.pose.at)));
}

TEST(Route, AStartOnFinishedGroundLeavesItTheShortWay) {
    Ground ground({.clearance = 0.3});
    ground.add(square({0, 0}, 6));
    const CurvatureState from{{{5.9, 3}, 0}, 0}, to{{{5.9, 9}, pi / 2}, 0};
    const Way way = route::way(ground, from, to, {.limits = limits});
    expect_drivable(way, from, to, limits);
    EXPECT_GT(way.blemish, 0.35);
    EXPECT_LT(way.blemish, 0.6);
}

TEST(Route, WhatIsAddedLaterIsSeen) {
    Ground ground({.clearance = 0.3}), whole({.clearance = 0.3});
    const CurvatureState from{{{0, 0}, 0}, 0}, to{{{12, 0}, 0}, 0};
    for (const Region& region : {square({3, -1}, 2), square({7, -1}, 2), square({5, 0.5}, 1.5)}) {
        ground.add(region);
        route::way(ground, from, to, {.limits = limits});  // its links are known before the next is added
    }
    whole.add(Regions{square({3, -1}, 2), square({7, -1}, 2), square({5, 0.5}, 1.5)});
    EXPECT_NEAR(length(route::way(ground, from, to, {.limits = limits}).curve),
                length(route::way(whole, from, to, {.limits = limits}).curve), 1e-9);
}

TEST(Route, RandomAreasAreNeverComeNearToAndWaysAreShort) {
    testing::Worlds worlds(1);
    std::vector<double> ratios;
    for (int w = 0; w < 8; ++w) {
        const Regions areas = worlds.areas();
        Ground ground({.clearance = 0.25});
        ground.add(areas);
        const CurveLimits own{0.5, w % 2 ? 40.0 : 10.0, w % 3 ? 0 : 0.7};
        for (int i = 0; i < 12; ++i) {
            const CurvatureState from = worlds.state(ground, i % 2), to = worlds.state(ground, i % 2);
            const Way way = route::way(ground, from, to, {.limits = own});
            expect_drivable(way, from, to, own);
            if (way.blemish > 0) continue;
            EXPECT_GE(least_distance(areas, way.curve), 0.25 - 1e-9);
            ratios.push_back(length(way.curve) / std::max(taut_length(ground, from.pose.at, to.pose.at),
                                                          dubins_length(from.pose, to.pose, own.radius)));
        }
    }
    std::ranges::sort(ratios);
    EXPECT_LT(ratios[ratios.size() / 2], 1.06);
}

TEST(Route, AWayIsFoundWhereAnExhaustiveSearchFindsOne) {
    testing::Worlds worlds(2);
    int missed = 0, found = 0;
    for (int w = 0; w < 6; ++w) {
        Ground ground({.clearance = 0.25});
        ground.add(worlds.areas());
        for (int i = 0; i < 12; ++i) {
            const CurvatureState from = worlds.state(ground, false), to = worlds.state(ground, false);
            if (route::way(ground, from, to, {.limits = limits}).blemish == 0)
                ++found;
            else if (testing::exhaustive(ground, from, to, limits))
                ++missed;
        }
    }
    EXPECT_GT(found, 50);
    EXPECT_EQ(missed, 0);
}

TEST(Route, TurnedAndMirroredGroundTurnsAndMirrorsTheLength) {
    testing::Worlds worlds(3);
    const Regions areas = worlds.areas();
    Ground ground({.clearance = 0.25}), mirrored({.clearance = 0.25});
    ground.add(areas);
    for (Region area : areas) {
        for (Point& p : area.outer) p = {-p.x, p.y};
        mirrored.add(area);
    }
    const auto mirror = [](CurvatureState s) {
        return CurvatureState{{{-s.pose.at.x, s.pose.at.y}, pi - s.pose.heading}, -s.curvature};
    };
    int alike = 0;
    for (int i = 0; i < 20; ++i) {
        const CurvatureState from = worlds.state(ground, false), to = worlds.state(ground, false);
        const double a = length(route::way(ground, from, to, {.limits = limits}).curve),
                     b = length(route::way(mirrored, mirror(from), mirror(to), {.limits = limits}).curve);
        if (std::abs(a - b) < 0.02 * a) ++alike;
    }
    EXPECT_GE(alike, 18) << "detours are tried in one order of sides: a few may differ";
}

}  // namespace
}  // namespace strandline::route
