#include <gtest/gtest.h>

#include "drive/drives.hpp"

namespace strandline {
namespace {

using namespace drive_tests;
using drive::Above;
using drive::Below;

Stroke random_stroke(std::mt19937_64& random, bool closed) {
    std::vector<Point> points{{uniform(random, -5, 5), uniform(random, -5, 5)}};
    double ahead = uniform(random, -pi, pi);
    for (int i = 0; i < 7; ++i) {
        ahead += uniform(random, -3, 3);
        points.push_back(points.back() + uniform(random, 0.1, 2) * unit(ahead));
    }
    return polyline(points, closed);
}
std::vector<Robot> robots() {
    Robot pivoting = beachbot(), axle = beachbot();
    pivoting.can_pivot = true;
    axle.rake_offset = 0;
    return {beachbot(), pivoting, axle, *builtin_robot("plotter"), *builtin_robot("turf")};
}

TEST(DriveLaws, WhateverTheCornersLegsMeetAndRollAndTheWholeStrokeIsDrawn) {
    std::mt19937_64 random(5);
    for (int round = 0; round < 8; ++round) {
        const bool closed = round % 2 == 0;
        const Stroke stroke = random_stroke(random, closed);
        for (const Robot& robot : robots())
            for (const Above above : {Above::loop, Above::pivot})
                for (const bool reverse : {false, true}) {
                    const auto result =
                        drive::drive(stroke, 0, closed ? round % 7 : 0, reverse, robot, {.above = above});
                    EXPECT_TRUE(result.undrivable.empty());
                    EXPECT_NEAR(expect_drivable(result, robot), length(stroke.rake_path), 1e-3) << robot.name;
                    EXPECT_LT(worst_rake_error(result, robot, stroke), 1e-6) << robot.name;
                    // a corner is one of these, at the seam of a closed stroke none
                    EXPECT_EQ(result.exact + result.loops + result.pivots + result.rounded, closed ? 7 : 6);
                    if (HasFailure()) return;
                }
    }
}

/// The largest distance of the middle of the lowered pins, pin by pin, from straight edges.
double worst_pins_error(const drive::Drive& drive, const Robot& robot, const Stroke& stroke) {
    const unsigned mask = pin_mask(robot, stroke.pins);
    double worst = 0;
    for (const Leg& leg : drive.legs) {
        if (leg.motion != Motion::draw) continue;
        for (const RobotState& state : leg.path) {
            Point middle{};
            for (int pin = 0; pin < robot.pins; ++pin)
                if (mask >> (robot.pins - 1 - pin) & 1U)
                    middle = middle + 1.0 / stroke.pins *
                                          (rake_at(robot, state.pose) +
                                           ((robot.pins - 1) / 2.0 - pin) * robot.pin_pitch *
                                               left_normal(unit(state.pose.heading)));
            double nearest = 1e9;
            for (const Curve& edge : stroke.rake_path)
                nearest = std::min(nearest, distance_to_segment(middle, edge.start.at, end_pose(edge).at));
            worst = std::max(worst, nearest);
        }
    }
    return worst;
}

TEST(DriveLaws, TheMiddleOfThePinsRunsAlongTheStrokeHoweverManyThereAre) {
    std::mt19937_64 random(12);
    Robot turf = *builtin_robot("turf"), even = beachbot();
    turf.pins = 4;
    even.pins = 8;
    for (int round = 0; round < 6; ++round) {
        Stroke stroke = random_stroke(random, round % 2 == 0);
        for (const Robot& robot : {beachbot(), even, turf})
            for (stroke.pins = 1; stroke.pins <= 4; ++stroke.pins) {
                const auto result = drive::drive(stroke, 0, 0, round % 3 == 0, robot, {});
                EXPECT_NEAR(expect_drivable(result, steered(stroke, robot)), length(stroke.rake_path), 1e-3);
                EXPECT_LT(worst_pins_error(result, robot, stroke), 1e-6) << robot.name << stroke.pins;
                if (HasFailure()) return;
            }
    }
}

TEST(DriveLaws, RoundedStrokesRollToo) {
    std::mt19937_64 random(6);
    for (int round = 0; round < 8; ++round) {
        Stroke stroke = random_stroke(random, false);
        stroke.fill = round % 2 == 0;
        for (const Robot& robot : robots()) {
            const auto result =
                drive::drive(stroke, 0, 0, false, robot, {.below = Below::round, .above = Above::round});
            EXPECT_TRUE(result.undrivable.empty());
            EXPECT_LE(expect_drivable(result, robot), length(stroke.rake_path) + 1e-3);
            EXPECT_EQ(result.exact + result.loops + result.pivots + result.rounded, 6);
            if (HasFailure()) return;
        }
    }
}

TEST(DriveLaws, EvenTooTightCurvesAndCornersBetweenThemAreRolledAlong) {
    std::mt19937_64 random(9);
    int undrivable = 0;
    for (int round = 0; round < 8; ++round) {
        Stroke stroke = random_stroke(random, false);
        stroke.fill = round % 3 == 0;
        for (Curve& curve : stroke.rake_path)
            curve.pieces = {{0.3, uniform(random, -15, 15), 0},
                            {uniform(random, 0.01, 0.5), uniform(random, -5, 5), 0}};
        for (std::size_t i = 1; i < stroke.rake_path.size(); ++i)
            stroke.rake_path[i].start.at = end_pose(stroke.rake_path[i - 1]).at;
        for (const Robot& robot : robots()) {
            const auto result = drive::drive(stroke, 0, 0, false, robot,
                                             {.below = round % 2 == 0 ? Below::exact : Below::round});
            undrivable += static_cast<int>(result.undrivable.size());
            expect_drivable(result, robot);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(undrivable, 0);  // the case was met
}

TEST(DriveLaws, TurnedAndMirroredStrokesAreDrivenTurnedAndMirrored) {
    std::mt19937_64 random(8);
    for (int round = 0; round < 10; ++round) {
        const Stroke stroke = random_stroke(random, false);
        const auto plain = drive::drive(stroke, 0, 0, false, beachbot(), {});
        for (const bool mirror : {false, true}) {
            const auto other =
                drive::drive(mapped(stroke, 1.3, mirror, {4, -2}), 0, 0, false, beachbot(), {});
            ASSERT_EQ(plain.legs.size(), other.legs.size());
            for (std::size_t l = 0; l < plain.legs.size(); ++l) {
                EXPECT_EQ(plain.legs[l].motion, other.legs[l].motion);
                EXPECT_NEAR(length(plain.legs[l].path), length(other.legs[l].path), 1e-6);
            }
        }
    }
}

}  // namespace
}  // namespace strandline
