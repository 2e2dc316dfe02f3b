// What a machine's profile asks for holds in the plan and is proved: tools that cannot be lifted, setbacks.
#include <gtest/gtest.h>

#include <algorithm>

#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"
#include "result/fidelity/fidelity.hpp"
#include "result/tracking/tracking.hpp"

namespace strandline {
namespace {

constexpr const char* three_lines =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="14000mm" height="14000mm" viewBox="0 0 14 14">
  <path d="M2 4 V10" stroke="black" stroke-width="0.3" fill="none"/>
  <path d="M7 2 H9" stroke="black" stroke-width="0.3" fill="none"/>
  <path d="M12 4 V10" stroke="black" stroke-width="0.3" fill="none"/></svg>)";

Plan planned(const Robot& robot, const std::vector<std::pair<std::string, std::string>>& wishes = {}) {
    Options options;
    EXPECT_TRUE(set(options, "place.mode", "actual"));
    for (const auto& [key, value] : wishes) EXPECT_TRUE(set(options, key, value)) << key;
    const auto plan = make_plan({three_lines, "lines.svg"}, robot, options, {});
    EXPECT_TRUE(plan) << (plan ? "" : sentence(plan.error()));
    return *plan;
}

TEST(Machines, AToolThatCannotBeLiftedIsDownAllTheWayAndTheMarksAreTold) {
    Plan plan = planned(*builtin_robot("sandtable"));
    EXPECT_TRUE(check::prove(plan).sound());
    ASSERT_GT(plan.samples.size(), 10u);
    for (std::size_t i = 0; i + 1 < plan.samples.size(); ++i) EXPECT_EQ(plan.samples[i].mask, 1u);
    EXPECT_EQ(plan.samples.back().mask, 0u);
    EXPECT_TRUE(
        std::ranges::any_of(plan.warnings, [](const Warning& w) { return w.place == "robot.lifts"; }));
    plan.robot.lifts = true;
    EXPECT_FALSE(check::prove(plan).sound()) << "for another robot these would be marks between strokes";
    Plan lifted = planned(*builtin_robot("plotter"));
    EXPECT_TRUE(check::prove(lifted).sound());
    lifted.robot.lifts = false;
    EXPECT_FALSE(check::prove(lifted).sound());
}

TEST(Machines, ARobotThatBacksUpComesSoonerAndIsNotMistakenForOneThatDoesNot) {
    constexpr const char* zigzag =
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="14000mm" height="14000mm" viewBox="0 0 14 14">
  <path d="M4 4 L9 4 L4 6 L9 8" stroke="black" stroke-width="0.1" fill="none"/></svg>)";
    Robot robot = *builtin_robot("beachbot");
    Options options;
    ASSERT_TRUE(set(options, "place.mode", "actual"));
    const auto forward = make_plan({zigzag, "lines.svg"}, robot, options, {});
    robot.can_back_up = true;
    const auto plan = make_plan({zigzag, "lines.svg"}, robot, options, {});
    ASSERT_TRUE(forward && plan);
    EXPECT_LT(plan->samples.back().t, forward->samples.back().t);
    int backing = 0;
    for (std::size_t i = 0; i + 1 < plan->samples.size(); ++i) {
        const Sample &a = plan->samples[i], &b = plan->samples[i + 1];
        if (!backs(a, b)) continue;
        ++backing;
        EXPECT_EQ(a.mask, 0u) << i;
        EXPECT_LT(dot(b.pose.at - a.pose.at, unit(a.pose.heading)), 0) << i;
        EXPECT_NEAR(a.turn_rate, a.speed * a.curvature, 1e-9) << i;
    }
    EXPECT_GT(backing, 10);
    EXPECT_TRUE(check::prove(*plan).sound());
    const tracking::Options exact{
        .localisation = {.noise = 0, .heading_noise = 0, .wander = 0, .slip = 0, .delay = 0}};
    const auto driven = tracking::driven(robot, plan->samples, exact);
    EXPECT_FALSE(driven.lost);
    EXPECT_LT(driven.most, 0.003);
    EXPECT_NEAR(driven.time, plan->samples.back().t, 0.02 * driven.time);
    Plan mistaken = *plan;
    mistaken.robot.can_back_up = false;
    EXPECT_FALSE(check::prove(mistaken).sound());
    EXPECT_TRUE(tracking::driven(mistaken.robot, plan->samples, exact).lost) << "it waits for ever";
    mistaken = *plan;
    mistaken.robot.lifts = false;
    for (Sample& sample : mistaken.samples) sample.mask = pin_mask(robot, robot.pins);
    const auto pushed = check::prove(mistaken).faults;
    EXPECT_TRUE(std::ranges::any_of(pushed, [](const check::Fault& fault) {
        return fault.what.find("none with the rake down") != std::string::npos;
    }));
    robot.lifts = false;
    const auto dragged = make_plan({zigzag, "lines.svg"}, robot, options, {});
    ASSERT_TRUE(dragged);
    EXPECT_TRUE(std::ranges::none_of(dragged->samples, [](const Sample& s) { return s.speed < 0; }));
}

TEST(Machines, LinesOfAnEvenNumberOfPinsLieInTheMiddleOfTheirPins) {
    Robot robot = *builtin_robot("beachbot");
    robot.rake_rules = {{8, 4}};
    Plan plan = planned(robot);
    const auto report = fidelity::judged(plan.drawing, fidelity::drive_of(plan)).report;
    EXPECT_LT(report.lateral_max, 0.001);
    EXPECT_LT(report.width_error, 0.01);
    EXPECT_EQ(report.undrawn, 0);
    EXPECT_TRUE(check::prove(plan).sound());
    for (Sample& sample : plan.samples)  // one more pin on the right: the middle is half a pitch off
        if (sample.mask != 0) sample.mask |= sample.mask >> 1;
    EXPECT_FALSE(check::prove(plan, {.tolerance = 0.02}).sound());
    const auto says = [](const Plan& of) {
        return std::ranges::any_of(of.warnings,
                                   [](const Warning& w) { return w.place == "robot.rake_offset"; });
    };
    EXPECT_FALSE(says(plan));
    robot.rake_offset = 0;
    robot.can_pivot = true;
    EXPECT_TRUE(says(planned(robot))) << "it cannot be driven beside its path";
}

TEST(Machines, AFillThatTurnsOnTheSpotAfterATightBendIsSound) {
    constexpr const char* blob =
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <path d="M10 30 C30 0 40 60 60 20 S95 30 90 60 S60 70 50 95 S20 80 25 60 S5 50 10 30Z"/></svg>)";
    Options options;
    ASSERT_TRUE(set(options, "canvas.width", "0.4m") && set(options, "canvas.height", "0.4m"));
    ASSERT_TRUE(set(options, "canvas.margin", "0.014285714285714287"));
    auto plan = make_plan({blob, "blob.svg"}, *builtin_robot("diffdrive"), options, {});
    ASSERT_TRUE(plan) << sentence(plan.error());
    const auto report = check::prove(*plan);
    EXPECT_TRUE(report.sound()) << (report.sound() ? "" : report.faults.front().what);
    // A heading that is wrong there is named all the same.
    const auto pivot = std::ranges::adjacent_find(plan->samples, [](const Sample& a, const Sample& b) {
        return a.motion == Motion::draw && b.motion == Motion::pivot;
    });
    ASSERT_NE(pivot, plan->samples.end());
    Sample& stands = *(pivot + 1);
    stands.pose.heading += 0.2;
    EXPECT_FALSE(check::prove(*plan).sound());
}

TEST(Machines, TheSetbackIsKeptFromABorderThatWasAskedFor) {
    Robot robot = *builtin_robot("beachbot");
    const std::vector<std::pair<std::string, std::string>> border{{"field.border", "0,0 14,0 14,14 0,14"}};
    EXPECT_NEAR(area(drive_area_of(planned(robot, border)).border), 14 * 14, 1e-6);
    const double free = area(drive_area_of(planned(robot)).border);
    robot.setback = 0.75;
    const Plan plan = planned(robot, border);
    EXPECT_NEAR(area(drive_area_of(plan).border), 12.5 * 12.5, 1e-6);
    EXPECT_NEAR(area(drive_area_of(planned(robot)).border), free, 1e-6) << "none was asked for";
    EXPECT_TRUE(check::prove(plan).sound());
    for (const Sample& s : plan.samples) {
        EXPECT_GT(std::min(s.pose.at.x, s.pose.at.y), 0.75 + robot.half_width - 0.01);
        EXPECT_LT(std::max(s.pose.at.x, s.pose.at.y), 13.25 - robot.half_width + 0.01);
    }
    robot.setback = 3;  // the outer lines lie nearer than that
    EXPECT_FALSE(check::prove(planned(robot, border)).sound());
    robot.setback = 8;  // nothing is left of the field
    EXPECT_FALSE(check::prove(planned(robot, border)).sound());
}

}  // namespace
}  // namespace strandline
