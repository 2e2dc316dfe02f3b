#include "path/connect/connect.hpp"

#include <gtest/gtest.h>

#include <random>

namespace strandline::connect {
namespace {

const CurvatureState here{{{1, 2}, 0.5}, 0};

void expect_arrives(const Connection& c, Pose from, Pose to) {
    EXPECT_NEAR(distance(c.curve.start.at, from.at), 0, 1e-12);
    EXPECT_NEAR(wrap_angle(from.heading + c.turn_before - c.curve.start.heading), 0, 1e-12);
    const Pose end = end_pose(c.curve);
    EXPECT_NEAR(distance(end.at, to.at), 0, 1e-8);
    EXPECT_NEAR(wrap_angle(end.heading + c.turn_after - to.heading), 0, 1e-9);
}

TEST(Connect, StraightTurnsTowardsTheEndDrivesAndTurnsAgain) {
    const CurvatureState there{{{1, 5}, 0}, 0};
    const Connection c = connection(here, there, {.style = Style::straight});
    EXPECT_NEAR(c.turn_before, pi / 2 - 0.5, 1e-12);
    EXPECT_NEAR(c.turn_after, -pi / 2, 1e-12);
    EXPECT_NEAR(length(c.curve), 3, 1e-12);
    expect_arrives(c, here.pose, there.pose);
}

TEST(Connect, PosesAtOnePointNeedATurnOnly) {
    const CurvatureState there{{{1, 2}, -3}, 0};
    const Connection c = connection(here, there, {.style = Style::straight});
    EXPECT_EQ(length(c.curve), 0);
    EXPECT_NEAR(c.turn_before, 2 * pi - 3.5, 1e-12);
    expect_arrives(c, here.pose, there.pose);
}

TEST(Connect, ARobotWithoutATurningRadiusTurnsOnTheSpot) {
    const CurvatureState there{{{4, 6}, 1}, 0};
    const Connection c = connection(here, there, {.limits = {.radius = 0}});
    EXPECT_NEAR(length(c.curve), 5, 1e-12);
    expect_arrives(c, here.pose, there.pose);
}

TEST(Connect, BoundedNeverTurnsOnTheSpotAndKeepsTheLimits) {
    std::mt19937_64 engine(5);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
    };
    const CurveLimits limits{0.5, 10};
    for (int i = 0; i < 500; ++i) {
        const auto state = [&] {
            return CurvatureState{{{uniform(-2, 2), uniform(-2, 2)}, uniform(-pi, pi)}, uniform(-2, 2)};
        };
        const CurvatureState from = state(), to = state();
        const Connection c = connection(from, to, {.limits = limits});
        EXPECT_EQ(c.turn_before, 0);
        EXPECT_EQ(c.turn_after, 0);
        expect_arrives(c, from.pose, to.pose);
        EXPECT_LE(max_curvature(c.curve), 2 + 1e-12);
        EXPECT_LE(max_sharpness(c.curve), 10 + 1e-11);
        EXPECT_LT(max_curvature_jump(c.curve), 1e-11);
        EXPECT_NEAR(c.curve.pieces.front().curvature, from.curvature, 1e-12);
        EXPECT_NEAR(c.curve.pieces.back().end_curvature(), to.curvature, 1e-11);
    }
}

TEST(Connect, ARobotThatCanTurnOnTheSpotDoesSoWhereAnEndIsTooTight) {
    const CurvatureState tight{{{4, 6}, 1}, 3};
    const Connection c = connection(here, tight, {.limits = {0.5, 10}, .pivot = true});
    EXPECT_NEAR(length(c.curve), 5, 1e-12);
    expect_arrives(c, here.pose, tight.pose);
}

TEST(Connect, ItTurnsOnTheSpotWhereThatIsShorterThanTheCurve) {
    const CurvatureState from{{{0, 0}, 0}, 0}, ahead{{{10, 0.2}, 0}, 0}, beside{{{0, 1}, 0}, 0};
    const Options options{.limits = {0.5, 10}, .pivot = true, .turn_cost = 0.5};
    EXPECT_EQ(connection(from, ahead, options).turn_before, 0);
    // A metre and half a turn in all, 2.6 m; no curve of radius 0.5 gets there in less than 3.
    const Connection turning = connection(from, beside, options);
    EXPECT_NEAR(turning.turn_before, pi / 2, 1e-12);
    EXPECT_NEAR(turning.turn_after, -pi / 2, 1e-12);
    EXPECT_NEAR(length(turning.curve), 1, 1e-12);
    Options dear = options;
    dear.turn_cost = 3;
    EXPECT_EQ(connection(from, beside, dear).turn_before, 0);
}

TEST(Connect, LimitsComeFromTheRobot) {
    Robot robot;
    robot.min_radius = 0.7;
    robot.sharpness = 3;
    EXPECT_EQ(limits_of(robot).radius, 0.7);
    EXPECT_EQ(limits_of(robot).sharpness, 3);
}

}  // namespace
}  // namespace strandline::connect
