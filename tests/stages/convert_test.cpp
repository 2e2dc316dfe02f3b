#include <gtest/gtest.h>

#include <algorithm>

#include "result/stages/points_curve.hpp"
#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

constexpr double allowed = 0.0005;  // 0.05 cm

Robot beachbot() { return *builtin_robot("beachbot"); }

/// Samples at equal steps of at most `step`, as a CSV would hold them: rounded to a tenth of a millimetre
/// when asked.
std::vector<RakeRows::Row> samples(const Curve& curve, double step, bool rest_at_end = false) {
    std::vector<RakeRows::Row> rows;
    const double whole = length(curve);
    const double stride = rest_at_end ? step : whole / std::ceil(whole / step);
    for (double s = 0; s < whole - 1e-6; s += stride) rows.push_back({point_at(curve, s).pose.at, 28});
    rows.push_back({end_pose(curve).at, 28});
    return rows;
}
/// The rake between the rows: poses interpolated by cubic Hermite over the robot's way, compared with the
/// true curve by rake arc length.
double rake_error(const Curve& truth, const std::vector<RobotRow>& rows, const std::vector<double>& s,
                  const Robot& robot) {
    double worst = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double chord = distance(rows[i - 1].pose.at, rows[i].pose.at);
        const double turn = rows[i].pose.heading - rows[i - 1].pose.heading;
        const double way = std::abs(turn) < 1e-9 ? chord : chord * (turn / 2) / std::sin(turn / 2);
        const RobotPath path{{0, rows[i - 1].pose, rows[i - 1].curvature},
                             {way, rows[i].pose, rows[i].curvature}};
        for (double t = 0; t <= 1; t += 0.125)
            worst = std::max(worst, distance(rake_at(robot, state_at(path, t * way).pose),
                                             point_at(truth, s[i - 1] + t * (s[i] - s[i - 1])).pose.at));
    }
    return worst;
}
double converted_error(const Curve& truth, double step, bool rest_at_end, const Robot& robot) {
    const auto rows = samples(truth, step, rest_at_end);
    const Conversion conversion = converted({{rows}}, robot);
    EXPECT_TRUE(conversion.undrivable.empty());
    std::vector<double> s;
    const double whole = length(truth), stride = rest_at_end ? step : whole / std::ceil(whole / step);
    for (std::size_t i = 0; i < rows.size(); ++i)
        s.push_back(std::min(whole, static_cast<double>(i) * stride));
    return rake_error(truth, conversion.strokes.at(0), s, robot);
}

TEST(Convert, OnArcsOfAQuarterMetreAndMoreTheRakeErrorIsBelowHalfAMillimetre) {
    for (const double radius : {0.25, 0.3, 0.5, 1.0, 5.0})
        for (const double side : {1.0, -1.0})
            for (const bool rest : {false, true})
                for (const double turn : {1.0, 3.0, 6.2}) {
                    const Curve arc{{{1, 2}, 0.4}, {{radius * turn, side / radius, 0}}};
                    EXPECT_LT(converted_error(arc, 0.05, rest, beachbot()), allowed)
                        << radius << ' ' << turn << ' ' << rest;
                }
}

TEST(Convert, WhereLinesAndArcsMeetBetweenTwoSamplesTheRakeErrorIsBelowOneAndAHalfMillimetres) {
    for (const double radius : {0.25, 0.5, 1.0}) {
        const Curve path{
            {{0, 0}, 0.3},
            {{1, 0, 0}, {radius * pi, 1 / radius, 0}, {1, 0, 0}, {radius * 1.5, -1 / radius, 0}}};
        EXPECT_LT(converted_error(path, 0.05, false, beachbot()), 0.0015) << radius;
    }
    const Curve wave{{{0, 0}, 0}, {{1, 0, 3}, {2, 3, -3}, {1, -3, 3}}};
    EXPECT_LT(converted_error(wave, 0.05, false, beachbot()), allowed);
}

TEST(Convert, TheRakeOfEachRowIsThePointGiven) {
    const Curve arc{{{1, 2}, 0.4}, {{2, 2, 0.5}}};
    const auto rows = samples(arc, 0.05);
    const Conversion conversion = converted({{rows}}, beachbot());
    ASSERT_EQ(conversion.strokes.at(0).size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RobotRow& row = conversion.strokes[0][i];
        EXPECT_NEAR(distance(row.rake, rows[i].at), 0, 1e-8);
        EXPECT_NEAR(distance(rake_at(beachbot(), row.pose), rows[i].at), 0, 1e-8);
        EXPECT_EQ(row.pins, rows[i].pins);
    }
}

TEST(Convert, ARealCornerStaysOne) {
    std::vector<Point> square;
    for (int i = 0; i <= 20; ++i) square.push_back({0.05 * i, 0});
    for (int i = 1; i <= 20; ++i) square.push_back({1 + 0.05 * i * std::cos(1.2), 0.05 * i * std::sin(1.2)});
    EXPECT_EQ(curve_through(square).curves.size(), 2u);
    EXPECT_NEAR(curve_through(square).s.back(), 2, 1e-6);
    // the corners of a polygon are not samples of a circle
    EXPECT_EQ(curve_through({{0, 0}, {2, 0}, {3, 1}, {3, 3}}).curves.size(), 3u);
    // an arc is no corner, not even where it leaves a line
    std::vector<Point> arc;
    for (const auto& row : samples({{}, {{1, 0, 0}, {1, 4, 0}}}, 0.05)) arc.push_back(row.at);
    EXPECT_EQ(curve_through(arc).curves.size(), 1u);
}

TEST(Convert, RepeatedPointsGetTheSamePose) {
    const RakeRows rows{{{{{0, 0}, 8}, {{0, 0}, 8}, {{1, 0}, 8}, {{1, 0}, 0}}}};
    const Conversion conversion = converted(rows, beachbot());
    ASSERT_EQ(conversion.strokes.at(0).size(), 4u);
    EXPECT_EQ(conversion.strokes[0][0].pose, conversion.strokes[0][1].pose);
    EXPECT_EQ(conversion.strokes[0][2].pose, conversion.strokes[0][3].pose);
    EXPECT_NEAR(conversion.strokes[0][3].pose.at.x, 1.2, 1e-9);
}

TEST(Convert, ASinglePlaceHasNoDirectionAndIsNamed) {
    const Conversion conversion = converted({{{{{3, 4}, 8}}}}, beachbot());
    EXPECT_EQ(conversion.strokes.at(0).size(), 1u);
    EXPECT_EQ(conversion.undrivable.size(), 1u);
}

TEST(Convert, WhatCannotBeFollowedIsNamedByItsRows) {
    std::vector<RakeRows::Row> rows;
    for (int i = 0; i <= 10; ++i) rows.push_back({{0.1 * i, 0}, 8});
    for (int i = 9; i >= 0; --i)
        rows.push_back({{0.1 * i, 0.02}, 8});  // back at once: a turn of nearly 180 degrees
    const Conversion conversion = converted({{{{{0, 0}, 0}, {{1, 0}, 0}}, rows}}, beachbot());
    ASSERT_FALSE(conversion.undrivable.empty());
    EXPECT_NE(conversion.undrivable[0].place.find("to 13"), std::string::npos)
        << conversion.undrivable[0].place;
}

TEST(Convert, APlotterIsWhereItsPenIs) {
    const Conversion conversion = converted({{samples({{}, {{2, 3, 0}}}, 0.05)}}, *builtin_robot("plotter"));
    for (const RobotRow& row : conversion.strokes.at(0)) {
        EXPECT_EQ(row.pose.at, row.rake);
        EXPECT_NEAR(row.curvature, 3, 1e-6);
    }
}

}  // namespace
}  // namespace strandline::stages
