#include <gtest/gtest.h>

#include "follow/paths.hpp"

namespace strandline {
namespace {

using namespace follow_tests;

TEST(States, BetweenStatesThePoseIsInterpolatedToTheFourthOrder) {
    const Curve curve{{{1, 2}, 0.5}, {{3, 1.5, -0.7}}};
    double coarse = 0, fine = 0;
    for (double s = 0; s <= 3; s += 0.0137) {
        const Pose truth = point_at(curve, s).pose;
        coarse = std::max(coarse, distance(state_at(states_along(curve, 0.2), s).pose.at, truth.at));
        fine = std::max(fine, distance(state_at(states_along(curve, 0.1), s).pose.at, truth.at));
        EXPECT_NEAR(state_at(states_along(curve, 0.1), s).pose.heading, truth.heading, 1e-5);
    }
    EXPECT_LT(fine, 1e-5);
    EXPECT_GT(coarse / fine, 10);
    EXPECT_LT(coarse / fine, 22);
}

TEST(States, OutsideThePathItsEndsAreMeant) {
    const RobotPath path = states_along(straight({}, 1), 0.1);
    EXPECT_EQ(state_at(path, -1), path.front());
    EXPECT_EQ(state_at(path, 2), path.back());
    EXPECT_EQ(state_at({}, 2), RobotState{});
}

TEST(States, AJumpOfCurvatureIsTwoStatesAtOnePlace) {
    const Curve curve{{}, {{1, 0, 0}, {1, 2, 0}, {1, 2, -2}}};
    const RobotPath path = states_along(curve, 0.25);
    EXPECT_EQ(path.size(), 5u + 5u + 4u);
    EXPECT_EQ(path[4].s, path[5].s);
    EXPECT_EQ(path[4].curvature, 0);
    EXPECT_EQ(path[5].curvature, 2);
    EXPECT_EQ(state_at(path, 1).curvature, 2);
    EXPECT_DOUBLE_EQ(length(path), 3);
}

TEST(States, TheRakeTrailsTheTurningPoint) {
    const Robot robot = beachbot();
    const Pose pose{{3, 4}, 1.1};
    const Point rake = rake_at(robot, pose);
    EXPECT_NEAR(distance(rake, pose.at), 0.2, 1e-15);
    EXPECT_LT(dot(rake - pose.at, unit(pose.heading)), 0);
    EXPECT_NEAR(distance(robot_at(robot, rake, pose.heading).at, pose.at), 0, 1e-15);
}

}  // namespace
}  // namespace strandline
