// The field's border, keep-outs, a parked robot and exits, from settings and drawings to check.
#include <gtest/gtest.h>

#include <algorithm>

#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"

namespace strandline {
namespace {

/// Two upright lines, 10 m apart on a canvas of 14, and whatever else.
std::string two_lines(const std::string& more = "") {
    return R"(<svg xmlns="http://www.w3.org/2000/svg"
                   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" width="14000mm" height="14000mm" viewBox="0 0 14 14">
  <path id="a" d="M2 4 V10" stroke="black" stroke-width="0.3" fill="none"/>
  <path id="b" d="M12 4 V10" stroke="black" stroke-width="0.3" fill="none"/>)" +
           more + "</svg>";
}
constexpr const char* rock = "6,5 8,5 8,9 6,9";

Plan planned(const std::string& svg, const std::vector<std::pair<std::string, std::string>>& wishes,
             const std::vector<Edit>& edits = {}, const std::string& robot = "beachbot") {
    Options options;
    for (const auto& [key, value] : wishes) EXPECT_TRUE(set(options, key, value)) << key;
    EXPECT_TRUE(set(options, "place.mode", "actual"));
    EXPECT_TRUE(set(options, "tour.start_x", "2"));
    EXPECT_TRUE(set(options, "tour.start_y", "4"));
    const auto plan = make_plan({svg, "lines.svg"}, *builtin_robot(robot), options, edits);
    EXPECT_TRUE(plan) << (plan ? "" : sentence(plan.error()));
    return *plan;
}
void expect_sound(const Plan& plan) {
    for (const check::Fault& fault : check::prove(plan).faults)
        ADD_FAILURE() << check::name_of(fault.law) << ": " << fault.what;
}
bool warns(const Plan& plan, const std::string& place, const std::string& words) {
    return std::ranges::any_of(plan.warnings, [&](const Warning& w) {
        return w.place == place && w.reason.find(words) != std::string::npos;
    });
}
/// The drive straight from a to b passes through the rock.
bool through_the_rock(const Plan& plan) {
    return std::ranges::any_of(plan.samples, [](const Sample& s) {
        return contains(Box{{6, 5}, {8, 9}}, s.pose.at);
    });
}

TEST(Field, KeepOutsOfTheSettingsAreGoneRoundWhateverElseIsAvoided) {
    // from the upper end of one line to the middle of nowhere: the row a, b is fixed by edits
    const std::vector<Edit> row{DirectionEdit{"a", "forward"}, DirectionEdit{"b", "forward"}};
    EXPECT_TRUE(through_the_rock(planned(two_lines(), {{"avoid.finished", "off"}}, row)))
        << "or the test shows nothing";
    for (const char* avoid : {"on", "off"})
        for (const char* cost : {"driven", "straight"}) {
            const Plan plan = planned(
                two_lines(), {{"avoid.finished", avoid}, {"tour.cost", cost}, {"field.keep_out", rock}}, row);
            EXPECT_FALSE(through_the_rock(plan)) << avoid << " " << cost;
            expect_sound(plan);
            EXPECT_TRUE(plan.warnings.empty());
        }
}

TEST(Field, KeepOutsOfTheDrawingAreNotDrawnAndHold) {
    const std::vector<Edit> row{DirectionEdit{"a", "forward"}, DirectionEdit{"b", "forward"}};
    for (
        const std::string shape :
        {R"(<rect x="6" y="5" width="2" height="4" data-strandline-field="keep-out"/>)",
         R"(<g inkscape:groupmode="layer" inkscape:label="keep-out"><rect x="6" y="5" width="2" height="4"/></g>)",
         R"(<g id="keep-out"><rect x="6" y="5" width="2" height="4" fill="none" stroke="red" stroke-width="0.01"/></g>)"}) {
        const Plan plan = planned(two_lines(shape), {}, row);
        EXPECT_EQ(plan.drawing.elements.size(), 2u) << shape;
        ASSERT_EQ(plan.drawing.keep_out.size(), 1u) << shape;
        EXPECT_NEAR(area(plan.drawing.keep_out[0]), 8, 0.2);
        EXPECT_FALSE(through_the_rock(plan)) << shape;
        expect_sound(plan);
    }
    const std::string rect = R"(<rect id="rock" x="6" y="5" width="2" height="4"/>)";
    EXPECT_EQ(
        planned(two_lines(rect), {{"drawing.rules", "id=rock: field=keep-out"}}).drawing.keep_out.size(), 1u);
    const Plan edited = planned(two_lines(rect), {}, {HintEdit{"rock", "field", "keep-out"}});
    EXPECT_EQ(edited.drawing.keep_out.size(), 1u);
    EXPECT_EQ(edited.drawing.elements.size(), 2u);
    EXPECT_TRUE(edited.idle_edits.empty());
}

TEST(Field, ABorderOfTheDrawingOrTheSettingsIsNotLeft) {
    // a U: the way from leg to leg is round by the foot
    const std::string corners = "0,0 14,0 14,14 10,14 10,3 4,3 4,14 0,14";
    const std::string shape =
        R"(<path data-strandline-field="border" d="M0 14 H14 V0 H10 V11 H4 V0 H0 Z" fill="grey"/>)";
    for (const Plan& plan :
         {planned(two_lines(), {{"field.border", corners}}), planned(two_lines(shape), {})}) {
        expect_sound(plan);
        EXPECT_TRUE(plan.warnings.empty());
        EXPECT_NEAR(area(drive_area_of(plan).border), 14 * 14 - 6 * 11, 1e-6);
        for (const Sample& s : plan.samples)
            EXPECT_TRUE(s.pose.at.x <= 4 || s.pose.at.x >= 10 || s.pose.at.y < 2.75);
    }
}

TEST(Field, AStrokeThatTakesTheRobotIntoAKeepOutIsNamedWithItsPlaceAndCheckSaysItToo) {
    const Plan plan = planned(two_lines(), {{"field.keep_out", "1,8 1.9,8 1.9,9 1,9"}});
    EXPECT_TRUE(warns(plan, "field.keep_out", "drawing \"a\" takes the robot into a keep-out from (2."));
    const check::Report report = check::prove(plan);
    ASSERT_FALSE(report.sound());
    for (const check::Fault& fault : report.faults) {
        EXPECT_EQ(fault.law, check::Law::field);
        EXPECT_NEAR(fault.at.y, 8.5, 1.1);
    }
    const auto spot = std::ranges::find_if(
        plan.blemishes, [](const Spot& s) { return s.what.find("keep-out") != std::string::npos; });
    ASSERT_NE(spot, plan.blemishes.end());
    EXPECT_NEAR(spot->amount, 1 + 0.45 + 0.25, 0.05) << "the keep-out's side, and the robot's length";
}

TEST(Field, TheDriveBeginsWhereItIsParkedAndEndsWhereItIsToldTo) {
    for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{{"park.exit", "none"},
                                                                                     {"park.exit", "parked"},
                                                                                     {"park.exit", "outside"},
                                                                                     {"park.exit_x", "7"}}) {
        const Plan plan = planned(two_lines(), {{"park.x", "7"},
                                                {"park.y", "1"},
                                                {"park.heading", "90deg"},
                                                {key, value},
                                                {"field.keep_out", rock}});
        expect_sound(plan);
        EXPECT_TRUE(plan.warnings.empty()) << value;
        EXPECT_NEAR(distance(plan.samples.front().pose.at, {7, 1}), 0, 1e-9);
        EXPECT_NEAR(plan.samples.front().pose.heading, pi / 2, 1e-9);
        EXPECT_EQ(plan.connections.front().from, -1);
        EXPECT_GT(plan.figures.in_driven, 3);
        double sum = 0;
        for (std::size_t i = 1; i < plan.samples.size() && plan.samples[i - 1].motion != Motion::draw; ++i)
            sum += distance(plan.samples[i - 1].pose.at, plan.samples[i].pose.at);
        EXPECT_NEAR(plan.figures.in_driven, sum, 1e-9);
        const Point last = plan.samples.back().pose.at;
        EXPECT_TRUE(value != "none" || plan.figures.out_driven == 0);
        EXPECT_TRUE(value != "parked" || distance(last, {7, 1}) < 1e-6);
        EXPECT_TRUE(value != "outside" || !contains(Box{{2, 4}, {12, 10}}, last));
        EXPECT_TRUE(value != "7" || distance(last, {7, 0}) < 1e-6);
        if (value != "none") {
            EXPECT_EQ(plan.connections.back().to, -1);
            EXPECT_GT(plan.figures.out_driven, 0.5);
            EXPECT_LT(plan.figures.in_driven + plan.figures.out_driven, plan.figures.up_driven);
        }
    }
}

TEST(Field, ASideArmsPlanIsSound) {
    for (const double side : {0.4, -0.4}) {
        Robot robot = *builtin_robot("turf");
        robot.rake_side = side;
        const auto plan = make_plan({two_lines(R"(<circle id="c" cx="7" cy="7" r="3" stroke="black"
            stroke-width="0.3" fill="none"/>)"),
                                     "lines.svg"},
                                    robot, {});
        ASSERT_TRUE(plan);
        expect_sound(*plan);
        EXPECT_TRUE(plan->undrivable.empty());
    }
}

TEST(Field, WhatCannotBeReadIsRefusedByItsSetting) {
    Options options;
    EXPECT_FALSE(set(options, "field.keep_out", "1,1 2,2"));
    EXPECT_FALSE(set(options, "field.keep_out", "1,1 2,2 3"));
    EXPECT_FALSE(set(options, "field.border", "0,0 1,0 1,1; 5,5 6,5 6,6"));
    EXPECT_TRUE(set(options, "field.keep_out", "0,0 100cm,0 1,1; 5,5 6,5 6,6"));
    EXPECT_TRUE(set(options, "park.exit", "parked"));
    const auto refused = valid(options, *builtin_robot("beachbot"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place, "park.exit");
}

TEST(Field, AvoidReachesThePlanner) {
    // Drawn first of all, an area lies between the two lines.
    const std::string area =
        R"(<rect id="sand" x="5" y="3" width="4" height="8" data-strandline-order="-1"/>)";
    const std::vector<Edit> row{DirectionEdit{"a", "forward"}, DirectionEdit{"b", "forward"}};
    const auto over = [&](const char* avoid) {
        return check::prove(planned(two_lines(area), {{"avoid.finished", avoid}}, row)).over_finished;
    };
    EXPECT_EQ(over("on"), 0);
    EXPECT_GT(over("off"), 3.5);
}

}  // namespace
}  // namespace strandline
