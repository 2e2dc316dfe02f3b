// A rake whose centre lies beside the robot's axis.
#include <gtest/gtest.h>

#include "follow/paths.hpp"

namespace strandline {
namespace {

using namespace follow_tests;

constexpr double rake_tolerance = 0.00015;  // as for a rake on the axis

Robot with_side(double offset, double side) {
    Robot robot = beachbot();
    robot.rake_offset = offset;
    robot.rake_side = side;
    return robot;
}

TEST(Side, RakeAndRobotPlacesAreEachOthersInverse) {
    const Robot robot = with_side(0.3, 0.5);
    EXPECT_EQ(rake_at(robot, {{1, 2}, 0}), (Point{0.7, 2.5})) << "behind, and to the left";
    const Pose pose{{1, 2}, 0.7};
    EXPECT_NEAR(distance(robot_at(robot, rake_at(robot, pose), 0.7).at, pose.at), 0, 1e-12);
}

TEST(Side, OnAnEndlessArcTheRobotRunsOnACircleBesideTheInnerOne) {
    const double radius = 2;
    for (const double side : {0.4, -0.4})
        for (const double turn : {4 * pi, -4 * pi}) {
            const Robot robot = with_side(0.3, side);
            const Followed followed = robot_path_for({arc(radius, turn)}, robot);
            const Point centre{0, turn > 0 ? radius : -radius};
            // a rake on the left of a turn to the left runs on a smaller circle than the robot
            const double own = std::sqrt(radius * radius - 0.09) + (turn > 0 ? side : -side);
            const RobotState start = followed.path.front();
            EXPECT_NEAR(distance(start.pose.at, centre), own, 1e-6);
            EXPECT_NEAR(start.curvature, (turn > 0 ? 1 : -1) / own, 1e-5);
            EXPECT_NEAR(length(followed.path) / (4 * pi), own, 2e-3);
        }
}

TEST(Side, ReSimulatedTheRakeLiesOnAnyRakePathThatIsCurvedLessThanTheRobotCanFollow) {
    std::mt19937_64 random(17);
    for (int i = 0; i < 60; ++i) {
        const Robot robot = with_side(uniform(random, 0.1, 0.5), uniform(random, -0.6, 0.6));
        const double tightest = std::hypot(robot.rake_offset, robot.rake_side);
        const std::vector<Curve> path{wavy(random, 0.7 / tightest, i % 2 == 0)};
        const Followed followed = robot_path_for(path, robot);
        EXPECT_TRUE(followed.undrivable.empty()) << i;
        EXPECT_LT(resimulated_error(robot, path, followed), rake_tolerance) << i;
        for (std::size_t k = 1; k < followed.path.size(); ++k)
            EXPECT_GE(followed.path[k].s, followed.path[k - 1].s) << "it never backs up";
    }
}

TEST(Side, CornersTowardsTheRakeAreDrawnExactlyAndSharpOnesAwayFromItAreNamed) {
    const Robot robot = with_side(0.3, 0.3);  // stands at 45 degrees
    const auto towards = zigzag({1.2}, 2), slightly_away = zigzag({-0.7}, 2), away = zigzag({-1.2}, 2);
    for (const auto& path : {towards, slightly_away}) {
        const Followed followed = robot_path_for(path, robot);
        EXPECT_TRUE(followed.undrivable.empty());
        EXPECT_LT(resimulated_error(robot, path, followed), rake_tolerance);
    }
    const Followed lost = robot_path_for(away, robot);
    ASSERT_EQ(lost.undrivable.size(), 1u);
    EXPECT_NEAR(lost.undrivable.front().to, 2, 0.01);
    for (std::size_t k = 1; k < lost.path.size(); ++k) EXPECT_GE(lost.path[k].s, lost.path[k - 1].s);
}

TEST(Side, MirroredWithItsPathItDrivesTheMirroredPath) {
    std::mt19937_64 random(23);
    const Curve path = wavy(random, 1.2, true);
    Curve mirrored = path;
    mirrored.start = {{path.start.at.x, -path.start.at.y}, -path.start.heading};
    for (Clothoid& piece : mirrored.pieces) piece = {piece.length, -piece.curvature, -piece.sharpness};
    const Followed a = robot_path_for({path}, with_side(0.3, 0.4)),
                   b = robot_path_for({mirrored}, with_side(0.3, -0.4));
    ASSERT_EQ(a.path.size(), b.path.size());
    for (std::size_t i = 0; i < a.path.size(); ++i) {
        EXPECT_NEAR(a.path[i].pose.at.x, b.path[i].pose.at.x, 1e-9);
        EXPECT_NEAR(a.path[i].pose.at.y, -b.path[i].pose.at.y, 1e-9);
        EXPECT_NEAR(a.path[i].curvature, -b.path[i].curvature, 1e-6);
    }
}

TEST(Side, ConnectionsTakeUpJustTheLeastRadius) {
    for (const double side : {0.0, 0.3, -0.3}) {
        const Robot robot = with_side(0.3, side);
        for (const double turn : {1.0, -1.0}) {
            const double delta = turn * connectable_delta(robot, turn);
            EXPECT_NEAR(robot_curvature(robot, delta), turn / least_radius(robot, turn), 1e-9);
            EXPECT_NEAR(delta_for(robot, robot_curvature(robot, delta)), delta, 1e-12);
        }
    }
    EXPECT_EQ(connectable_delta(with_side(0.3, 0.6), 1), pi / 2)
        << "the rake is the middle of no turn so tight";
}

}  // namespace
}  // namespace strandline
