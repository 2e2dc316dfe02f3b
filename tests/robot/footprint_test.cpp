#include <gtest/gtest.h>

#include "machine/robot/robot.hpp"

namespace strandline {
namespace {

// Beachbot: 0.45 m ahead, 0.25 m behind, 0.25 m to each side.
Region box(Point low, Point high) { return {{low, {high.x, low.y}, high, {low.x, high.y}}, {}}; }

TEST(Footprint, KeepsOffWhatItDoesNotReach) {
    const Robot robot = *builtin_robot("beachbot");
    const Region ahead = box({0.46, -1}, {1, 1});
    EXPECT_TRUE(keeps_off(robot, {0, 0}, 0, ahead));
    EXPECT_FALSE(keeps_off(robot, {0.02, 0}, 0, ahead)) << "1 cm into it";
    EXPECT_TRUE(keeps_off(robot, {0.2, 0}, pi / 2, ahead)) << "its side reaches less far";
    EXPECT_FALSE(keeps_off(robot, {0.2, 0}, pi / 4, ahead)) << "its corner reaches farther";
}

TEST(Footprint, SeesWhatLiesUnderItAndAPoleBetweenItsCorners) {
    const Robot robot = *builtin_robot("beachbot");
    EXPECT_FALSE(keeps_off(robot, {0, 0}, 1, box({0.1, 0.05}, {0.12, 0.07}))) << "a pole under it";
    EXPECT_FALSE(keeps_off(robot, {0, 0}, 1, box({-9, -9}, {9, 9}))) << "wholly within";
    EXPECT_FALSE(keeps_off(robot, {0, 0}, 0, box({-9, 0}, {9, 0.01}))) << "a rope across it";
    Region ring = box({-9, -9}, {9, 9});
    ring.holes = {{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}};
    EXPECT_TRUE(keeps_off(robot, {0, 0}, 1, ring)) << "in its hole";
    EXPECT_FALSE(stays_within(robot, {0, 0}, 1, ring));
}

TEST(Footprint, StaysWithinAFieldUpToItsBorder) {
    const Robot robot = *builtin_robot("beachbot");
    const Region field = box({-1, -1}, {1, 1});
    EXPECT_TRUE(stays_within(robot, {0.54, 0}, 0, field));
    EXPECT_FALSE(stays_within(robot, {0.56, 0}, 0, field));
    EXPECT_TRUE(stays_within(robot, {0.74, 0}, pi, field)) << "its back is shorter";
    EXPECT_FALSE(stays_within(robot, {5, 0}, 0, field));
    EXPECT_NEAR(footprint_reach(robot), std::hypot(0.45, 0.25), 1e-12);
}

}  // namespace
}  // namespace strandline
