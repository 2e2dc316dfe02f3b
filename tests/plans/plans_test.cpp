#include <gtest/gtest.h>

#include <algorithm>

#include "check/mutations.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"

namespace strandline {
namespace {

const char* const nested = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <circle id="outer" cx="50" cy="50" r="45" fill="none" stroke="black" stroke-width="3"/>
  <rect id="inner" x="35" y="35" width="30" height="30" fill="black"/>
  <path id="left" d="M20 40 L20 60" stroke="black" fill="none"/>
  <path id="right" d="M80 40 L80 60" stroke="black" fill="none"/>
  <path id="start" d="M50 99 L51 99" stroke="#00ff00"/>
</svg>)";

Outcome<Plan> planned(const std::string& robot, const Options& options = {},
                      const std::vector<Edit>& edits = {}) {
    return make_plan({nested, "nested.svg"}, *builtin_robot(robot), options, edits);
}

std::vector<std::string> drawn_order(const Plan& plan) {
    std::vector<std::string> ids;
    for (const Stroke& stroke : plan.strokes) {
        const std::string& id = plan.drawing.elements[static_cast<std::size_t>(stroke.element)].id;
        if (ids.empty() || ids.back() != id) ids.push_back(id);
    }
    return ids;
}

TEST(Pipeline, WhatLiesInsideIsDrawnBeforeTheOutline) {
    const auto plan = planned("beachbot");
    ASSERT_TRUE(plan) << sentence(plan.error());
    EXPECT_EQ(drawn_order(*plan).back(), "outer");
    EXPECT_EQ(plan->drawing.elements.size(), 4u);
    EXPECT_TRUE(plan->drawing.start);
}

TEST(Pipeline, APlanOfRealShapesIsSound) {
    for (const char* robot : {"beachbot", "turf", "plotter"}) {
        const auto plan = planned(robot);
        ASSERT_TRUE(plan) << robot << ": " << sentence(plan.error());
        const check::Report report = check::prove(*plan);
        for (const check::Fault& fault : report.faults)
            ADD_FAILURE() << robot << ": " << check::name_of(fault.law) << " " << fault.what;
    }
}

TEST(Pipeline, PinsLiftOverRakedSandUnlessToldNotTo) {
    const auto twice = [](const Plan& plan) { return check::prove(plan).overdraw; };
    const auto down = [](const Plan& plan) {
        return std::ranges::all_of(plan.samples, [&](const Sample& s) {
            return s.motion != Motion::draw || !plan.strokes[static_cast<std::size_t>(s.stroke)].fill ||
                   s.mask == pin_mask(plan.robot, plan.robot.pins);
        });
    };
    Options together;
    ASSERT_TRUE(set(together, "fill.lift_pins", "off"));
    const auto lifted = planned("beachbot"), solid = planned("beachbot", together);
    ASSERT_TRUE(lifted && solid);
    EXPECT_FALSE(down(*lifted));
    EXPECT_TRUE(down(*solid));
    EXPECT_LT(twice(*lifted), twice(*solid) / 2);
}

TEST(Pipeline, AnAreaTooLargeForSinglePinsIsRakedWithAllAndSaysSo) {
    Robot robot = *builtin_robot("beachbot");
    robot.pin_pitch = 0.002;
    robot.rake_offset = 0;
    robot.min_radius = 0;
    Options options;
    options.drawing.tolerance = 0.002;
    const auto plan = make_plan({R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
        <rect id="wide" width="100" height="60"/></svg>)",
                                 "wide.svg"},
                                robot, options, {});
    ASSERT_TRUE(plan) << sentence(plan.error());
    EXPECT_GE(plan->figures.fallbacks, 1);
    EXPECT_TRUE(std::ranges::any_of(plan->warnings, [](const Warning& warning) {
        return warning.place == "wide" && warning.reason.find("too large to lift pins") != std::string::npos;
    }));
    for (const Sample& sample : plan->samples)
        ASSERT_TRUE(sample.mask == 0 || sample.mask == pin_mask(plan->robot, plan->robot.pins));
}

TEST(Pipeline, EveryMutationOfARealPlanIsNamed) {
    const auto plan = planned("beachbot");
    ASSERT_TRUE(plan);
    const auto count = [](const Plan& of, check::Law law) {
        const auto faults = check::prove(of).faults;
        return std::count_if(faults.begin(), faults.end(),
                             [&](const check::Fault& f) { return f.law == law; });
    };
    for (const auto& mutation : mutations::twelve()) {
        const Plan mutant = mutation.apply(*plan);
        ASSERT_FALSE(mutant == *plan) << mutation.name << " changed nothing";
        if (mutation.listed)
            continue;  // a crossing needs two neighbouring lines: tests/check has the plan for it
        EXPECT_GT(count(mutant, mutation.law), count(*plan, mutation.law)) << mutation.name;
    }
}

TEST(Pipeline, EditsAreKeptAndIdleOnesListed) {
    const std::vector<Edit> edits{LinkEdit{{"left", 1}, {"right", 0}}, DirectionEdit{"outer", "cw"},
                                  EntryEdit{{"gone", 0}}};
    const auto plan = planned("beachbot", {}, edits);
    ASSERT_TRUE(plan) << sentence(plan.error());
    EXPECT_EQ(plan->edits, edits);
    ASSERT_EQ(plan->idle_edits.size(), 1u);
    EXPECT_NE(plan->idle_edits[0].find("gone"), std::string::npos);
    const auto order = drawn_order(*plan);
    const auto left = std::find(order.begin(), order.end(), "left"),
               right = std::find(order.begin(), order.end(), "right");
    EXPECT_EQ(std::abs(left - right), 1);
}

TEST(Pipeline, ToolsAndOrderDecideBatchesAndStopsAreListed) {
    Options options;
    ASSERT_TRUE(
        set(options, "drawing.rules", "id=outer: tool=2; id=right: order=-1; id=left: pause=by hand"));
    const auto plan = planned("beachbot", options);
    ASSERT_TRUE(plan) << sentence(plan.error());
    // by pause (the elements before left, left, those after it), then tool, then order
    EXPECT_EQ(drawn_order(*plan), (std::vector<std::string>{"inner", "outer", "left", "right"}));
    ASSERT_EQ(plan->stops.size(), 2u);
    EXPECT_EQ(plan->stops[0].why, "tool 2");
    EXPECT_EQ(plan->stops[1].why, "pause by hand, tool 1");
    for (const Stop& stop : plan->stops) {
        const auto first = std::ranges::find(plan->samples, stop.stroke, &Sample::stroke);
        EXPECT_LT(stop.time, first->t);
        const auto before = std::ranges::find(plan->samples, stop.stroke - 1, &Sample::stroke);
        EXPECT_GT(stop.time, before->t);
    }
    EXPECT_TRUE(check::prove(*plan).sound());
}

TEST(Pipeline, HintsThatCannotBeObeyedAreWarnedOfOnceAndTheRestAreKept) {
    const char* const hinted = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <g data-strandline-glitter="yes" data-strandline-fill-style="zigzag"><rect id="a" x="0" y="0" width="40" height="40"/>
  <rect id="b" x="60" y="60" width="40" height="40" data-strandline-fill-style="spiral"/></g></svg>)";
    const auto plan = make_plan({hinted, "hinted.svg"}, *builtin_robot("beachbot"), {}, {});
    ASSERT_TRUE(plan) << sentence(plan.error());
    EXPECT_EQ(
        std::ranges::count_if(plan->warnings,
                              [](const Warning& w) { return w.reason.find("glitter") != std::string::npos; }),
        1);
    const auto other = make_plan({hinted, "hinted.svg"}, *builtin_robot("beachbot"),
                                 [] {
                                     Options o;
                                     o.fill.style = "zigzag";
                                     return o;
                                 }(),
                                 {});
    EXPECT_EQ(other->drawing.elements[1].hints[0].value, "spiral");
    EXPECT_NEAR(plan->figures.drawn, other->figures.drawn, 1e-6)
        << "both have their own style, whatever the setting";
}

TEST(Pipeline, ContradictoryEditsAreRefusedByName) {
    const auto plan = planned("beachbot", {},
                              {LinkEdit{{"outer", 0}, {"inner", 0}}, LinkEdit{{"outer", 0}, {"left", 0}},
                               LinkEdit{{"outer", 0}, {"right", 0}}});
    ASSERT_FALSE(plan);
    EXPECT_NE(sentence(plan.error()).find("outer"), std::string::npos) << sentence(plan.error());
}

TEST(Pipeline, AStoppedUserStillGetsAWholePlan) {
    Progress impatient;
    impatient.stopped = [] { return true; };
    const auto plan = make_plan({nested, "nested.svg"}, *builtin_robot("beachbot"), {}, {}, impatient);
    ASSERT_TRUE(plan) << sentence(plan.error());
    EXPECT_EQ(plan->drawing.elements.size(), 4u);
    EXPECT_TRUE(check::prove(*plan).sound());
}

}  // namespace
}  // namespace strandline
