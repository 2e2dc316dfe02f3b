#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

std::string refusal(const std::string& text, const std::string& robot = "beachbot") {
    const auto rows = read_rake_csv(text, "rake.csv", *builtin_robot(robot));
    return rows ? "accepted" : sentence(rows.error());
}
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ConvertCsv, AnEmptyLineStartsANewStroke) {
    const auto rows = read_rake_csv("x,y,pins\n0,0,7\n1,0,7\n\n\n2,2,3\r\n2.5,2e0,3\n", "rake.csv",
                                    *builtin_robot("beachbot"));
    ASSERT_TRUE(rows) << sentence(rows.error());
    ASSERT_EQ(rows->strokes.size(), 2u);
    EXPECT_EQ(rows->strokes[0].size(), 2u);
    EXPECT_EQ(rows->strokes[1][1].at, (Point{2.5, 2}));
    EXPECT_EQ(rows->strokes[1][1].pins, 3u);
}

TEST(ConvertCsv, BadInputIsRefusedWithItsLine) {
    EXPECT_TRUE(holds(refusal(""), "is empty"));
    EXPECT_TRUE(holds(refusal("a,b\n1,2,3\n"), "line 1: is not the header"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n"), "holds no points"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,0,7\n1,two,7\n"), "line 3"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,nan,7\n"), "line 2"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,inf,7\n"), "line 2"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,1e308,7\n"), "too far"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,1\n"), "three columns"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,1,7,8\n"), "line 2"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,1,-7\n"), "whole number"));
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,1,1.5\n"), "whole number"));
}

TEST(ConvertCsv, NoMorePinsThanTheRobotHas) {
    EXPECT_EQ(refusal("x,y,pins\n0,0,127\n1,0,0\n"), "accepted");
    const std::string text = refusal("x,y,pins\n0,0,7\n1,0,128\n");
    EXPECT_TRUE(holds(text, "rake.csv, line 3")) << text;
    EXPECT_TRUE(holds(text, "0 to 127")) << text;
    EXPECT_EQ(refusal("x,y,pins\n0,0,1\n", "plotter"), "accepted");
    EXPECT_TRUE(holds(refusal("x,y,pins\n0,0,2\n", "plotter"), "0 to 1"));
}

TEST(ConvertCsv, AnyPointsAreConvertedOrRefused) {
    std::mt19937_64 random(2);
    const auto coordinate = [&] {
        const int kind = static_cast<int>(random() % 4);
        return kind == 0 ? 0.0
                         : static_cast<double>(random() % 2000) * (kind == 1   ? 1e-7
                                                                   : kind == 2 ? 1e-3
                                                                               : 1e-1);
    };
    for (int i = 0; i < 15; ++i) {
        RakeRows rows{{{}}};
        for (int k = 0; k < 12; ++k) rows.strokes[0].push_back({{coordinate(), coordinate()}, 1});
        const Conversion conversion =
            converted(rows, *builtin_robot(builtin_robots()[static_cast<std::size_t>(i % 3)]));
        ASSERT_EQ(conversion.strokes.at(0).size(), 12u);
        for (const RobotRow& row : conversion.strokes[0]) {
            EXPECT_TRUE(is_finite(row.pose.at) && is_finite(row.rake));
            EXPECT_TRUE(std::isfinite(row.pose.heading) && std::isfinite(row.curvature));
        }
    }
}

TEST(ConvertCsv, APathAcrossACountryIsConvertedAtOnce) {
    const RakeRows rows{{{{{-1e6, 0}, 1}, {{1e6, 0}, 1}, {{1e6, 1e6}, 1}}}};
    const Conversion conversion = converted(rows, *builtin_robot("beachbot"));
    EXPECT_NEAR(distance(conversion.strokes.at(0)[1].rake, {1e6, 0}), 0, 1e-3);
}

TEST(ConvertCsv, OneRowARowAndAnEmptyLineBetweenStrokes) {
    const auto rows = read_rake_csv("x, y, pins\n0,0,8\n1,0,8\n\n0,1,127\n1,1,127\n2,1,127\n", "rake.csv",
                                    *builtin_robot("beachbot"));
    ASSERT_TRUE(rows);
    const std::string text = write_robot_csv(converted(*rows, *builtin_robot("beachbot")));
    EXPECT_EQ(text.substr(0, text.find('\n')), "x,y,theta,kappa,pins,x_rake,y_rake");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2 + 1 + 3);
    EXPECT_TRUE(holds(text, "\n0.200000000,0.000000000,0.000000000,0.000000000,8,0.000000000,0.000000000\n"));
    EXPECT_TRUE(holds(text, "\n\n0.200000000,1.000000000"));
}

}  // namespace
}  // namespace strandline::stages
