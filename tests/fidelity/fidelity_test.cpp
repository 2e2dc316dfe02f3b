#include "result/fidelity/fidelity.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"

namespace strandline::fidelity {
namespace {

using by_hand::line_element;
using by_hand::raking_robot;

Robot without_wheels() {
    Robot robot = raking_robot();
    robot.wheels.clear();
    return robot;
}
/// A band of `pins` wide, drawn straight along x at height y, beside where it should be by `off`.
Plan one_line(double off, int drawn_pins, const Robot& robot) {
    by_hand::Drive drive(robot, {{5, 5}, 0});
    const Point from = drive.rake() - Point{0, off};
    const int line = drive.element(line_element("line", path_through({from, from + Point{4, 0}}, false), 3));
    return drive.draw_ahead(line, drawn_pins, 4).finished();
}
/// A square of 4 x 0.42 m raked in one stroke, from `begin` metres behind its start.
Plan one_area(double begin, double length, const Robot& robot) {
    by_hand::Drive drive(robot, {{5, 5}, 0});
    const Point low = drive.rake() + Point{begin, -0.21}, high = low + Point{4, 0.42};
    const int area =
        drive.element({"area", "", RegionElement{{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}}, -1});
    return drive.draw_ahead(area, 7, length, true).finished();
}
Report report_of(const Plan& plan) { return judged(plan.drawing, drive_of(plan)).report; }

TEST(Fidelity, ALineDrawnWhereItBelongsIsAllThere) {
    const Report r = report_of(one_line(0, 3, without_wheels()));
    EXPECT_GT(r.intersection_over_union, 0.97);
    EXPECT_NEAR(r.lateral_mean, 0, 1e-9);
    EXPECT_LT(r.width_error, 0.01);
    EXPECT_EQ(r.undrawn, 0);
    EXPECT_NEAR(r.line_length, 4, 1e-9);
    EXPECT_EQ(r.blemish(), r.stray);
    EXPECT_LT(r.stray, 0.02);
}

TEST(Fidelity, ALineBesideItsPlaceIsOffByThat) {
    const Report r = report_of(one_line(0.03, 3, without_wheels()));
    EXPECT_NEAR(r.lateral_mean, 0.03, 1e-9);
    EXPECT_NEAR(r.lateral_max, 0.03, 1e-9);
    // 15 of 21 cm are both raked and wanted.
    EXPECT_NEAR(r.intersection_over_union, 15.0 / 21, 0.02);
    EXPECT_NEAR(r.stray, 4 * 0.03, 0.01);
    EXPECT_NEAR(r.missing, 4 * 0.03, 0.01);
}

TEST(Fidelity, TwoPinsOfSevenDrawBesideTheRakesMiddle) {
    EXPECT_NEAR(report_of(one_line(0.03, 2, without_wheels())).lateral_max, 0, 1e-9);
    EXPECT_NEAR(report_of(one_line(0, 2, without_wheels())).lateral_max, 0.03, 1e-9);
}

TEST(Fidelity, AWiderGrooveIsWiderByItsPins) {
    const Report r = report_of(one_line(0, 5, without_wheels()));
    EXPECT_NEAR(r.width_bias, 0.12, 0.01);
    EXPECT_NEAR(report_of(one_line(0, 1, without_wheels())).width_bias, -0.12, 0.01);
}

TEST(Fidelity, LinesSideBySideSayNothingOfTheirWidths) {
    Plan plan = one_line(0, 3, without_wheels());
    Element beside = plan.drawing.elements[0];
    auto& path = std::get<LineElement>(beside.what).path;
    path = transformed(path, {1, 0, 0, 1, 0, 0.18});
    plan.drawing.elements.push_back(beside);
    EXPECT_EQ(report_of(plan).width_error, 0);
    EXPECT_GT(report_of(plan).undrawn, 3.5);
}

TEST(Fidelity, AnAreaRakedTooFarIsSpiltAndOneTooShortIsMissing) {
    const Report whole = report_of(one_area(0, 4, without_wheels()));
    EXPECT_GT(whole.fill_union, 0.99);
    EXPECT_NEAR(whole.fill_area, 4 * 0.42, 0.02);
    EXPECT_NEAR(whole.fill_perimeter, 8.84, 1e-9);
    const Report far = report_of(one_area(0, 4.1, without_wheels()));
    EXPECT_NEAR(far.spill, 0.1 / 4, 0.002);
    EXPECT_NEAR(far.border_over, 100 * 0.1 * 0.42 / 8.84, 0.05);
    EXPECT_NEAR(far.fill_union, 4 / 4.1, 0.005);
    const Report few = report_of(one_area(0, 3.9, without_wheels()));
    EXPECT_NEAR(few.coverage, 3.9 / 4, 0.002);
    EXPECT_NEAR(few.border_missing, 100 * 0.1 * 0.42 / 8.84, 0.05);
    ASSERT_FALSE(few.places.empty());
    EXPECT_EQ(few.places.front().flaw, Flaw::missing);
    EXPECT_NEAR(few.places.front().area, 0.1 * 0.42, 0.005);
}

TEST(Fidelity, ATrackOnAFinishedAreaIsAPlace) {
    Robot robot = without_wheels();
    robot.wheels = {{{0, 0}, 0.1}};
    Plan plan = one_area(0, 4, robot);
    // Back to the beginning by a jump, and over it once more, rake up.
    const std::vector<Sample> first = plan.samples;
    for (Sample sample : first) {
        sample.t += 1000;
        sample.mask = 0;
        sample.stroke = -1;
        plan.samples.push_back(sample);
    }
    const Report r = report_of(plan);
    EXPECT_NEAR(r.track_on_fill, 0.1 * 3.8, 0.02);
    ASSERT_FALSE(r.places.empty());
    EXPECT_EQ(r.places.front().flaw, Flaw::track_on_fill);
    EXPECT_GT(r.blemish(), r.track_on_fill);
}

TEST(Fidelity, WhatADriveOfUnknownOriginDrawsIsFoundByItsPlace) {
    const Plan plan = by_hand::raked_plan();
    const surface::Drive known = drive_of(plan);
    const std::vector<int> found = elements_drawn(plan.drawing, plan.robot, plan.samples);
    ASSERT_EQ(found.size(), known.elements.size());
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
        EXPECT_EQ(found[i], plan.samples[i].mask == 0 ? -1 : known.elements[i]) << i;
}

TEST(Fidelity, TurnedAndMirroredTheFiguresStay) {
    const Report as_is = report_of(one_line(0.02, 3, without_wheels()));
    Plan turned = one_line(0.02, 3, without_wheels());
    const Point about{6, 5};
    const auto turn = [&](Point p) { return about + left_normal(p - about); };
    for (Sample& sample : turned.samples) {
        sample.pose = {turn(sample.pose.at), sample.pose.heading + pi / 2};
        sample.rake = turn(sample.rake);
    }
    auto& line = std::get<LineElement>(turned.drawing.elements[0].what);
    line.path = transformed(line.path, {0, 1, -1, 0, about.x + about.y, about.y - about.x});
    const Report r = report_of(turned);
    EXPECT_NEAR(r.lateral_mean, as_is.lateral_mean, 1e-9);
    EXPECT_NEAR(r.intersection_over_union, as_is.intersection_over_union, 0.01);
}

}  // namespace
}  // namespace strandline::fidelity
