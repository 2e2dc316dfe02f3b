// What a plan says of its fills.
#include <gtest/gtest.h>

#include <algorithm>

#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"

namespace strandline {
namespace {

const char* const two_areas = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <rect id="left" x="0" y="0" width="40" height="100"/>
  <rect id="right" x="60" y="0" width="40" height="100" data-strandline-fill-style="spiral"/></svg>)";

const char* const star = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100"><polygon
  points="50,5 60,35 93,36 67,56 76,86 50,68 24,86 33,56 7,36 39,35"/></svg>)";

Plan planned(const std::string& robot, const std::vector<std::pair<std::string, std::string>>& asked,
             const char* drawing = two_areas) {
    Options options;
    for (const auto& [key, value] : asked) EXPECT_TRUE(set(options, key, value)) << key;
    auto plan = make_plan({drawing, "areas.svg"}, *builtin_robot(robot), options, {});
    EXPECT_TRUE(plan) << sentence(plan.error());
    return plan ? std::move(*plan) : Plan{};
}
std::vector<std::string> said_of(const Plan& plan, const std::string& place) {
    std::vector<std::string> reasons;
    for (const Warning& warning : plan.warnings)
        if (warning.place == place) reasons.push_back(warning.reason);
    return reasons;
}

TEST(FillsOfAPlan, AChoiceIsNamedOnlyWhereNoAreaReadsIt) {
    const Plan idle = planned("beachbot", {{"fill.join", "nearest"}, {"fill.style", "zigzag"}});
    ASSERT_EQ(said_of(idle, "fill.join").size(), 1u);
    EXPECT_NE(said_of(idle, "fill.join")[0].find("serves rings"), std::string::npos);
    EXPECT_GE(idle.figures.fallbacks, 1);
    // The right area is a spiral, the left one rings.
    const Plan read = planned("beachbot", {{"fill.join", "nearest"}, {"fill.shift", "5"}});
    EXPECT_TRUE(said_of(read, "fill.join").empty());
    EXPECT_TRUE(said_of(read, "fill.shift").empty());
    EXPECT_EQ(read.figures.fallbacks, 0);
}

TEST(FillsOfAPlan, ACutOrSegmentOfOneAreaIsNoMistakeInAnother) {
    const char* const lines = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
      <rect id="left" x="0" y="0" width="40" height="100"/><rect id="right" x="60" y="0" width="40" height="100"/></svg>)";
    const Plan plan = planned("beachbot",
                              {{"fill.style", "zigzag"},
                               {"fill.cuts", "0,7 7,7; 6.5,5 7.5,5"},
                               {"fill.segments", "2,3 direction=10deg; 7,7 direction=20deg"}},
                              lines);
    ASSERT_EQ(said_of(plan, "fill.cuts").size(), 1u);
    EXPECT_NE(said_of(plan, "fill.cuts")[0].find("cut 2"), std::string::npos);
    ASSERT_EQ(said_of(plan, "fill.segments").size(), 1u);
    EXPECT_NE(said_of(plan, "fill.segments")[0].find("choice 2"), std::string::npos);
}

TEST(FillsOfAPlan, AHintThatCannotBeReadOrSuitsNotTheRobotIsPassedOverAndCounted) {
    for (const char* hint : {"fill-cuts='1,1'", "fill-segments='1,1'", "fill-spacing='5m'"}) {
        const std::string drawing = std::string(
                                        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><rect "
                                        "id='plate' width='100' height='100' data-strandline-") +
                                    hint + "/></svg>";
        const Plan plan = planned("beachbot", {}, drawing.c_str());
        EXPECT_EQ(plan.figures.fallbacks, 1) << hint;
        EXPECT_TRUE(std::ranges::any_of(plan.warnings, [](const Warning& warning) {
            return warning.reason.find("hint fill-") != std::string::npos;
        })) << hint;
    }
}

TEST(FillsOfAPlan, ASpacingOfNoWholePinsIsNamedWithTheNearestOnes) {
    const auto said = said_of(planned("beachbot", {{"fill.spacing", "40cm"}}), "fill.spacing");
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("0.36 m or 0.42 m"), std::string::npos) << said[0];
    EXPECT_TRUE(said_of(planned("beachbot", {{"fill.spacing", "36cm"}}), "fill.spacing").empty());
    EXPECT_TRUE(
        said_of(planned("beachbot", {{"fill.spacing", "40cm"}, {"fill.lift_pins", "off"}}), "fill.spacing")
            .empty());
}

TEST(FillsOfAPlan, ADirectionThatTheBestOneOverrulesIsNamed) {
    const auto said = [](const char* best) {
        return said_of(
            planned("beachbot",
                    {{"fill.style", "zigzag"}, {"fill.direction", "30"}, {"fill.best_direction", best}}),
            "fill.direction");
    };
    EXPECT_EQ(said("on").size(), 1u);
    EXPECT_TRUE(said("off").empty());
}

TEST(FillsOfAPlan, SpansThatCannotBeDrivenAreOneWarning) {
    const Plan plan = planned("beachbot", {{"fill.style", "zigzag"}}, star);
    ASSERT_FALSE(plan.undrivable.empty());
    ASSERT_EQ(said_of(plan, "the drive").size(), 1u);
    EXPECT_NE(said_of(plan, "the drive")[0].find(std::to_string(plan.undrivable.size()) + " spans"),
              std::string::npos);
    EXPECT_TRUE(said_of(planned("beachbot", {}), "the drive").empty());
}

TEST(FillsOfAPlan, OneStrokeSaysWhereTheRobotMustLiftAllTheSame) {
    const auto said = [](const Plan& plan) { return said_of(plan, "fill.one_stroke"); };
    const Plan lifted = planned("beachbot", {{"fill.one_stroke", "on"}}, star);
    EXPECT_EQ(lifted.strokes.size(), 1u);
    EXPECT_EQ(said(lifted).size(), 1u);
    EXPECT_GE(lifted.figures.fallbacks, 1);
    EXPECT_TRUE(said(planned("beachbot", {}, star)).empty());
    Robot free = *builtin_robot("beachbot");
    free.min_radius = 0;
    free.rake_offset = 0;
    Options options;
    ASSERT_TRUE(set(options, "fill.one_stroke", "on"));
    const auto plotted = make_plan({star, "star.svg"}, free, options, {});
    ASSERT_TRUE(plotted) << sentence(plotted.error());
    EXPECT_TRUE(said(*plotted).empty());
}

TEST(FillsOfAPlan, SandThatIsToStayBareIsNoFault) {
    const Plan gaps = planned(
        "beachbot", {{"fill.style", "zigzag"}, {"fill.partition", "monotone"}, {"fill.part_inset", "1m"}});
    const check::Report report = check::prove(gaps);
    EXPECT_LT(report.coverage, 0.8);
    EXPECT_TRUE(report.sound());
    Plan unasked = gaps;
    unasked.options.fill.part_inset = 0;
    EXPECT_FALSE(check::prove(unasked).sound());
}

TEST(FillsOfAPlan, ARobotThatLoopsRakesTheTipsOfCornersAsFarAsItIsAskedTo) {
    // Two tips of 33 degrees: rounded, they stay bare.
    const char* const spikes = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
      <polygon id="kite" points="50,0 65,50 50,100 35,50"/></svg>)";
    const auto covered = [&](const std::string& tips, const std::string& style) {
        const Plan plan = planned("beachbot", {{"fill.tips", tips}, {"fill.style", style}}, spikes);
        const check::Report report = check::prove(plan);
        EXPECT_TRUE(report.sound()) << tips << ' ' << style;
        EXPECT_LT(report.spill, 0.002) << tips << ' ' << style;
        return report.coverage;
    };
    for (const char* const style : {"rings", "spiral", "zigzag"}) {
        const double off = covered("off", style), border = covered("border", style),
                     all = covered("all", style);
        EXPECT_GT(border, off + 0.005) << style;
        EXPECT_GT(all, border - 0.002) << style;
    }
    EXPECT_GT(covered("all", "rings"), covered("border", "rings") + 0.001);
}

TEST(FillsOfAPlan, TipsAreLeftToRobotsThatLoopAndLiftTheirPins) {
    const auto strokes = [](const std::string& robot, const std::string& tips) {
        return planned(robot, {{"fill.tips", tips}}, star).strokes.size();
    };
    EXPECT_EQ(strokes("turf", "all"), strokes("turf", "off"));
    EXPECT_GT(strokes("beachbot", "all"), strokes("beachbot", "off"));
}

TEST(FillsOfAPlan, TurnsOfAZigzagAreLiftedByChoice) {
    const std::size_t raked = planned("beachbot", {{"fill.style", "zigzag"}}).strokes.size();
    EXPECT_GT(planned("beachbot", {{"fill.style", "zigzag"}, {"fill.rake_turns", "off"}}).strokes.size(),
              raked + 5);
}

}  // namespace
}  // namespace strandline
