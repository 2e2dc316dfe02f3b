#include "machine/robot/robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace strandline {
namespace {

Robot beachbot() { return *builtin_robot("beachbot"); }

TEST(Robot, EveryBuiltInIsValidAndBearsItsName) {
    for (const std::string& name : builtin_robots()) {
        const auto robot = builtin_robot(name);
        ASSERT_TRUE(robot) << name;
        EXPECT_EQ(robot->name, name);
        EXPECT_TRUE(valid(*robot, name)) << sentence(valid(*robot, name).error());
    }
}

TEST(Robot, AnUnknownNameIsRefusedWithTheNamesThereAre) {
    const auto robot = builtin_robot("bechbot");
    ASSERT_FALSE(robot);
    EXPECT_NE(sentence(robot.error()).find("beachbot, plotter, turf, diffdrive or sandtable"),
              std::string::npos);
}

TEST(Robot, SharpnessOfTheBeachbotFollowsFromItsTurnAcceleration) {
    const Robot robot = beachbot();
    EXPECT_DOUBLE_EQ(robot.sharpness, robot.turn_acceleration / (robot.speed * robot.speed));
    EXPECT_DOUBLE_EQ(robot.min_radius, robot.speed / robot.turn_rate);
    EXPECT_DOUBLE_EQ(robot.rake_width(), 0.42);
}

TEST(Robot, MasksOf2014AreTheMiddlePins) {
    const Robot robot = beachbot();
    EXPECT_EQ(pin_mask(robot, 0), 0u);
    EXPECT_EQ(pin_mask(robot, 1), 8u);
    EXPECT_EQ(pin_mask(robot, 3), 28u);
    EXPECT_EQ(pin_mask(robot, 5), 62u);
    EXPECT_EQ(pin_mask(robot, 7), 127u);
    EXPECT_EQ(pin_mask(robot, 9), 127u);
    for (int count = 0; count <= robot.pins; ++count) EXPECT_EQ(pins_down(pin_mask(robot, count)), count);
}

TEST(Robot, AnEvenNumberOfPinsOutOfAnOddOneLiesHalfAPitchBeside) {
    Robot robot = beachbot();
    EXPECT_EQ(pin_mask(robot, 2), 12u);
    EXPECT_DOUBLE_EQ(middle_of(robot, pin_mask(robot, 2)), -0.03);
    EXPECT_DOUBLE_EQ(middle_of(robot, 64u), 0.18);
    EXPECT_EQ(middle_of(robot, 0), 0);
    for (int count = 1; count <= robot.pins; count += 2)
        EXPECT_NEAR(middle_of(robot, pin_mask(robot, count)), 0, 1e-15) << count;
    robot.pins = 6;
    EXPECT_NEAR(middle_of(robot, pin_mask(robot, 3)), -0.03, 1e-15);
    robot.rake_side = -0.5;  // beside the body on its right: towards the axis
    EXPECT_NEAR(middle_of(robot, pin_mask(robot, 3)), 0.03, 1e-15);
    EXPECT_NEAR(middle_of(robot, pin_mask(robot, 6)), 0, 1e-15);
}

TEST(Robot, TheOnlyPinOfAPlotterIsBitZero) { EXPECT_EQ(pin_mask(*builtin_robot("plotter"), 1), 1u); }

TEST(Robot, StrokeWidthsChooseTheRakeAsIn2014) {
    const Robot robot = beachbot();
    EXPECT_EQ(pins_for_width(robot, 0), 0);
    EXPECT_EQ(pins_for_width(robot, 0.01), 1);
    EXPECT_EQ(pins_for_width(robot, 1), 1);
    EXPECT_EQ(pins_for_width(robot, 1.01), 3);
    EXPECT_EQ(pins_for_width(robot, 3), 3);
    EXPECT_EQ(pins_for_width(robot, 3.0000001), 3);
    EXPECT_EQ(pins_for_width(robot, 5), 5);
    EXPECT_EQ(pins_for_width(robot, 6), 7);
    EXPECT_EQ(pins_for_width(robot, 800), 7);
}

TEST(Robot, TheFootprintIsCounterClockwiseAndHoldsTheTurningPoint) {
    for (const std::string& name : builtin_robots()) {
        const Robot robot = *builtin_robot(name);
        EXPECT_GT(signed_area(footprint(robot)), 0);
        EXPECT_TRUE(contains(footprint(robot), {0, 0}));
    }
}

TEST(Robot, AFieldIsSetByNameWithAUnit) {
    EXPECT_DOUBLE_EQ(with_field(beachbot(), "min_radius", "30cm")->min_radius, 0.3);
    EXPECT_DOUBLE_EQ(with_field(beachbot(), "lift_delay", "0.5s")->lift_delay, 0.5);
    EXPECT_TRUE(with_field(beachbot(), "can_pivot", "true")->can_pivot);
    EXPECT_FALSE(with_field(*builtin_robot("turf"), "fill_wide_strokes", "off")->fill_wide_strokes);
}

TEST(Robot, FewerPinsLimitTheRakeRules) {
    const auto robot = with_field(beachbot(), "pins", "3");
    ASSERT_TRUE(robot) << sentence(robot.error());
    EXPECT_EQ(pins_for_width(*robot, 8), 3);
    EXPECT_EQ(pin_mask(*robot, 1), 2u);
}

TEST(Robot, AWrongFieldIsRefusedByNameAndRange) {
    for (const RobotField& field : robot_fields()) {
        const auto low = with_field(beachbot(), field.name, std::to_string(field.low - 1));
        const auto high = with_field(beachbot(), field.name, std::to_string(2 * field.high + 1));
        const auto words = with_field(beachbot(), field.name, "quick");
        for (const auto& result : {low, high, words}) {
            ASSERT_FALSE(result) << field.name;
            EXPECT_NE(sentence(result.error()).find(field.name + " is "), std::string::npos)
                << sentence(result.error());
        }
    }
    ASSERT_FALSE(with_field(beachbot(), "min_radus", "1"));
    EXPECT_NE(sentence(with_field(beachbot(), "wheels", "1").error()).find("profile"), std::string::npos);
}

TEST(Robot, ARadiusOfZeroNeedsARobotThatPivots) {
    EXPECT_FALSE(with_field(beachbot(), "min_radius", "0"));
    EXPECT_TRUE(with_field(*with_field(beachbot(), "can_pivot", "true"), "min_radius", "0"));
}

}  // namespace
}  // namespace strandline
