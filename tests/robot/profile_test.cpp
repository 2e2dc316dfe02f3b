#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

#include "machine/robot/robot.hpp"

namespace strandline {
namespace {

std::string refusal(const std::string& toml) {
    const auto robot = read_robot(toml, "my.toml");
    return robot ? "accepted" : sentence(robot.error());
}
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Profile, WhatIsWrittenReadsBackEqual) {
    for (const std::string& name : builtin_robots()) {
        Robot robot = *builtin_robot(name);
        EXPECT_EQ(read_robot(write_robot(robot), name).value_or(Robot{.name = "none"}), robot);
        robot.name = "a \"quoted\" \\ name\nwith\tall";
        robot.rake_offset = 0.1 + 0.2;
        robot.sharpness = 1e-4;
        robot.wheels.clear();
        robot.rake_rules.clear();
        const auto back = read_robot(write_robot(robot), name);
        ASSERT_TRUE(back) << sentence(back.error());
        EXPECT_EQ(*back, robot);
    }
}

TEST(Profile, AnEmptyTextIsTheBeachbot) { EXPECT_EQ(*read_robot("", "my.toml"), *builtin_robot("beachbot")); }

TEST(Profile, FieldsAreLaidOverTheBase) {
    const auto robot = read_robot(
        "base = \"plotter\"\nname = \"big pen\"\npin_pitch = \"5mm\"\nspeed = 1\n"
        "[[wheels]]\nx = \"1ft\"\ny = 0\n[[rake_rules]]\nup_to = 2\npins = 1\n",
        "my.toml");
    ASSERT_TRUE(robot) << sentence(robot.error());
    Robot expected = *builtin_robot("plotter");
    expected.name = "big pen";
    expected.pin_pitch = 0.005;
    expected.speed = 1;
    expected.wheels = {{{0.3048, 0}, 0.05}};
    expected.rake_rules = {{2, 1}};
    EXPECT_EQ(*robot, expected);
}

TEST(Profile, AWrongFieldIsNamedWithItsLineUnitAndRange) {
    const std::string text = refusal("speed = 0.1\npin_pitch = \"16 furlongs\"\n");
    EXPECT_TRUE(holds(text, "my.toml, line 2, pin_pitch")) << text;
    EXPECT_TRUE(holds(text, "furlongs")) << text;
    EXPECT_TRUE(holds(refusal("min_radius = -1"), "min_radius is 0 to 100 m"));
    EXPECT_TRUE(holds(refusal("pins = 2.5"), "pins is a whole number from 1 to 31"));
    EXPECT_TRUE(holds(refusal("pins = true"), "pins is a whole number"));
    EXPECT_TRUE(holds(refusal("can_pivot = 1"), "can_pivot is true or false"));
    EXPECT_TRUE(holds(refusal("speed = nan"), "speed is "));
    EXPECT_TRUE(holds(refusal("speed = inf"), "speed is "));
    EXPECT_TRUE(holds(refusal("speed = [1]"), "speed is "));
    EXPECT_TRUE(holds(refusal("name = 3"), "name"));
}

TEST(Profile, AnUnknownFieldIsRefusedWithTheFieldsThereAre) {
    const std::string text = refusal("\nmin_radus = 1");
    EXPECT_TRUE(holds(text, "line 2, min_radus")) << text;
    EXPECT_TRUE(holds(text, "min_radius")) << text;
    EXPECT_TRUE(holds(refusal("[[wheels]]\nx = 0\ny = 0\nz = 1"), "wheels.z"));
}

TEST(Profile, ListsAreCheckedEntryByEntry) {
    EXPECT_TRUE(holds(refusal("wheels = 3"), "wheels"));
    EXPECT_TRUE(holds(refusal("wheels = [3]"), "x, y, width"));
    EXPECT_TRUE(holds(refusal("[[wheels]]\nx = 0"), "y is missing"));
    EXPECT_TRUE(holds(refusal("[[wheels]]\nx = 99\ny = 0"), "wheels[0]"));
    EXPECT_TRUE(holds(refusal("[[rake_rules]]\nup_to = 1\npins = 9"), "0 to 7"));
    EXPECT_TRUE(holds(refusal("[[rake_rules]]\nup_to = 1\npins = -1"), "0 to 7"));
    EXPECT_TRUE(holds(refusal("[[rake_rules]]\nup_to = 3\npins = 1\n[[rake_rules]]\nup_to = 3\npins = 2"),
                      "thin to wide"));
    EXPECT_TRUE(holds(refusal("[[rake_rules]]\nup_to = 3\npins = 1.5"), "whole number"));
}

TEST(Profile, FewerPinsLimitTheBasesRulesButNotThoseOfTheProfileItself) {
    const auto robot = read_robot("pins = 5", "my.toml");
    ASSERT_TRUE(robot) << sentence(robot.error());
    EXPECT_EQ(robot->rake_rules, (std::vector<RakeRule>{{0, 0}, {1, 1}, {3, 3}, {5, 5}, {8, 5}}));
    // a profile as `strandline robots beachbot` prints it, with another number of pins
    std::string whole = write_robot(*builtin_robot("beachbot"));
    whole.replace(whole.find("pins = 7"), 8, "pins = 5");
    const auto line = std::count(whole.begin(), whole.end(), '\n');  // the widest rule is the last line
    const std::string text = refusal(whole);
    EXPECT_TRUE(holds(text, "line " + std::to_string(line) + ", rake_rules.pins")) << text;
    EXPECT_TRUE(holds(text, "7 pins where the robot has 5")) << text;
    EXPECT_TRUE(holds(text, "remove every [[rake_rules]]")) << text;
}

TEST(Profile, ASyntaxErrorNamesItsLine) {
    EXPECT_TRUE(holds(refusal("speed = 1\npins = = 3"), "my.toml, line 2"));
    EXPECT_TRUE(holds(refusal("base = \"rover\""), "line 1, base"));
    EXPECT_TRUE(holds(refusal("base = 3"), "base"));
    EXPECT_NE(refusal(std::string("\xff\xfe\x00", 3)), "accepted");
}

TEST(Profile, AnyBytesGiveAValidRobotOrOneError) {
    std::mt19937_64 random(1);
    const std::string whole = write_robot(*builtin_robot("beachbot"));
    int accepted = 0;
    for (int i = 0; i < 500; ++i) {
        std::string text = whole;
        for (int change = 0; change < 1 + i % 3; ++change)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        if (i % 5 == 0) text.resize(random() % text.size());
        const auto robot = read_robot(text, "my.toml");
        if (robot) {
            EXPECT_TRUE(valid(*robot, ""));
            ++accepted;
        } else {
            EXPECT_TRUE(holds(robot.error().place, "my.toml")) << sentence(robot.error());
        }
    }
    EXPECT_GT(accepted, 0);
    EXPECT_LT(accepted, 500);
}

TEST(Profile, TheDocsPageListsEveryField) {
    std::ifstream file(STRANDLINE_SOURCE "/docs/robot.md");
    const std::string page(std::istreambuf_iterator<char>(file), {});
    for (const RobotField& field : robot_fields())
        EXPECT_TRUE(holds(page, "`" + field.name + "`")) << field.name;
}

}  // namespace
}  // namespace strandline
