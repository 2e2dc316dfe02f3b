// Curves with parts that are driven backwards: what is read off them, and the ones found between poses.
#include <gtest/gtest.h>

#include "curve/random_poses.hpp"
#include "math/curve/curve.hpp"

namespace strandline {
namespace {

using testing::Dice;

/// Forward 2 m on a bend to the left, back 1 m on one to the right, forward 1 m.
Curve three_parts() { return {{{1, 2}, 0.3}, {{2, 0.2, 0.1}, {-1, -0.5, 0.2}, {1, 0, 0}}}; }

TEST(Backing, ArcLengthsCountWhatIsDrivenEitherWay) {
    const Curve curve = three_parts();
    EXPECT_DOUBLE_EQ(length(curve), 4);
    EXPECT_EQ(stands(curve), 2);
    const Pose cusp = point_at(curve, 2).pose, second = point_at(curve, 3).pose;
    EXPECT_LT(dot(second.at - cusp.at, unit(cusp.heading)), -0.9);
    EXPECT_NEAR(point_at(curve, 3).curvature, -0.5 - 0.2, 1e-12);
    const auto points = sampled(curve, 0.01);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LT(distance(points[i - 1].pose.at, points[i].pose.at), 0.01 + 1e-9);
        EXPECT_LT(distance(points[i].pose.at, point_at(curve, points[i].s).pose.at), 1e-9);
    }
}

TEST(Backing, TheSenseOfAnEndThatIsBackedFromOrToCountsAsAStand) {
    EXPECT_EQ(stands({{}, {{1, 0, 0}}}), 0);
    EXPECT_EQ(stands({{}, {{-1, 0, 0}}}), 2);
    EXPECT_EQ(stands({{}, {{1, 0, 0}, {-1, 0, 0}}}), 2);
    EXPECT_EQ(stands({{}, {{-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}}}), 4);
}

TEST(Backing, TurnedAboutItGoesThroughTheSamePlaces) {
    const Curve curve = three_parts(), back = reversed(curve);
    for (double s = 0; s <= 4; s += 0.1) {
        const CurvePoint here = point_at(curve, s), there = point_at(back, 4 - s);
        EXPECT_LT(distance(here.pose.at, there.pose.at), 1e-9) << s;
        EXPECT_NEAR(wrap_angle(here.pose.heading + pi - there.pose.heading), 0, 1e-9) << s;
    }
}

TEST(Backing, SectionsAndSlicesAreParts) {
    const Curve curve = three_parts();
    const auto parts = sections(curve);
    ASSERT_EQ(parts.size(), 3u);
    double s = 0;
    for (const Curve& part : parts) {
        EXPECT_LT(distance(part.start.at, point_at(curve, s).pose.at), 1e-9);
        s += length(part);
    }
    const Curve part = slice(curve, 1.5, 2.7);
    EXPECT_NEAR(length(part), 1.2, 1e-12);
    for (double along = 0; along <= 1.2; along += 0.1)
        EXPECT_LT(distance(point_at(part, along).pose.at, point_at(curve, 1.5 + along).pose.at), 1e-9);
}

TEST(Backing, WhatIsBehindIsBackedTo) {
    const auto curve = backing_curve({{{0, 0}, 0}, 0}, {{{-1, 0}, 0}, 0}, {0.5, 10}, 0.2, 100);
    ASSERT_TRUE(curve);
    EXPECT_NEAR(length(*curve), 1, 1e-6);
    for (const Clothoid& piece : curve->pieces)
        EXPECT_TRUE(backs(piece)) << piece.length << " " << piece.curvature;
}

TEST(Backing, ATurnAboutIsAThreePointTurn) {
    // By arcs alone Reeds and Shepp's shortest is pi radii long.
    const auto curve = backing_curve({{{0, 0}, 0}, 0}, {{{0, 0}, pi}, 0}, {1, 1e6}, 0.05, 100);
    ASSERT_TRUE(curve);
    EXPECT_GT(length(*curve), pi - 1e-6);
    EXPECT_LT(length(*curve), 1.1 * pi);
    EXPECT_EQ(stands(*curve), 2);
}

TEST(Backing, JoinsAnyStatesWithinAnyLimitsOrSaysThatNothingIsCheaper) {
    Dice dice(31);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const CurveLimits limits{dice.uniform(0.3, 2), std::pow(10, dice.uniform(-0.5, 2)),
                                 dice.uniform(0.3, 2)};
        const double left = 1 / limits.radius, right = 1 / limits.right_radius;
        const Pose start = dice.pose(10);
        const CurvatureState from{start, dice.uniform(-right, left)},
            to{dice.pose_near(start, limits.radius), dice.uniform(-right, left)};
        const double forward = length(refined_continuous_curvature(from, to, limits)), stand = 0.3;
        const auto curve = backing_curve(from, to, limits, stand, forward);
        if (!curve) continue;
        ++found;
        const std::string what = "pair " + std::to_string(i);
        EXPECT_LT(length(*curve) + stand * stands(*curve), forward) << what;
        EXPECT_GE(stands(*curve), 2) << what;
        EXPECT_LE(sections(*curve).size(), 3u) << what;
        EXPECT_EQ(curve->start, from.pose) << what;
        const Pose end = end_pose(*curve);
        EXPECT_LT(distance(end.at, to.pose.at), 1e-8) << what;
        EXPECT_NEAR(wrap_angle(end.heading - to.pose.heading), 0, 1e-8) << what;
        EXPECT_LE(max_sharpness(*curve), limits.sharpness * (1 + 1e-12)) << what;
        EXPECT_LT(max_curvature_jump(*curve), 1e-9) << what;
        for (const Clothoid& piece : curve->pieces)
            for (const double curvature : {piece.curvature, piece.end_curvature()}) {
                EXPECT_LE(curvature, left * (1 + 1e-12)) << what;
                EXPECT_GE(curvature, -right * (1 + 1e-12)) << what;
            }
        // Only from a stand may the wheels be turned.
        if (!backs(curve->pieces.front())) {
            EXPECT_NEAR(curve->pieces.front().curvature, from.curvature, 1e-9) << what;
        }
        if (!backs(curve->pieces.back())) {
            EXPECT_NEAR(curve->pieces.back().end_curvature(), to.curvature, 1e-9) << what;
        }
    }
    EXPECT_GT(found, 100);
}

TEST(Backing, AGuessJoinsThePosesByArcsAndLines) {
    Dice dice(32);
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        const Pose from = dice.pose(10), to = dice.pose_near(from, 0.5);
        const double forward = dubins_length(from, to, 0.5);
        const auto curve = backing_guess(from, to, 0.5, 0.2, forward);
        if (!curve) continue;
        ++found;
        EXPECT_LT(length(*curve) + 0.2 * stands(*curve), forward);
        EXPECT_LT(distance(end_pose(*curve).at, to.at), 1e-6);
        EXPECT_LE(max_curvature(*curve), 2 + 1e-9);
    }
    EXPECT_GT(found, 300);
}

}  // namespace
}  // namespace strandline
