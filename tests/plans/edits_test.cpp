// Edits of single elements, and a Planner that keeps what they do not touch.
#include <gtest/gtest.h>

#include <algorithm>

#include "plan/pipeline/pipeline.hpp"

namespace strandline {
namespace {

const char* const boxes = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <rect id="outer" x="5" y="5" width="90" height="90" fill="none" stroke="black"/>
  <rect id="middle" x="20" y="20" width="60" height="60" fill="none" stroke="black"/>
  <rect id="inner" x="35" y="35" width="30" height="30" fill="black"/>
  <path id="line" d="M10 10 L10 90" stroke="black" fill="none"/>
</svg>)";
const Source source{boxes, "boxes.svg"};

Plan planned(const std::vector<Edit>& edits) {
    auto plan = make_plan(source, *builtin_robot("beachbot"), {}, edits);
    EXPECT_TRUE(plan) << sentence(plan.error());
    return plan ? *plan : Plan{};
}
std::vector<std::string> ids(const Plan& plan) {
    std::vector<std::string> names;
    for (const Element& element : plan.drawing.elements) names.push_back(element.id);
    return names;
}
std::vector<std::string> driven(const Plan& plan) {
    std::vector<std::string> names;
    for (const Stroke& stroke : plan.strokes)
        if (const std::string& id = plan.drawing.elements[static_cast<std::size_t>(stroke.element)].id;
            names.empty() || names.back() != id)
            names.push_back(id);
    return names;
}
const Element& element(const Plan& plan, const std::string& id) {
    return *std::ranges::find(plan.drawing.elements, id, &Element::id);
}

TEST(Edits, AnErasedElementIsGoneAndWhatItEnclosedLiesInWhatEnclosedIt) {
    const Plan plan = planned({HintEdit{"middle", "ink", "off"}});
    EXPECT_EQ(ids(plan), (std::vector<std::string>{"outer", "inner", "line"}));
    EXPECT_EQ(plan.drawing.elements[static_cast<std::size_t>(element(plan, "inner").inside)].id, "outer");
}

TEST(Edits, AHintIsForOneElementAndTheLastOneWins) {
    const Plan plan = planned({HintEdit{"line", "pins", "7"}, HintEdit{"line", "pins", "3"},
                               HintEdit{"inner", "fill-style", "zigzag"}});
    EXPECT_EQ(std::get<LineElement>(element(plan, "line").what).pins, 3);
    EXPECT_EQ(std::get<LineElement>(element(plan, "outer").what).pins, 1);
    EXPECT_EQ(*value_of(element(plan, "inner").hints, "fill-style"), "zigzag");
    EXPECT_EQ(value_of(element(plan, "outer").hints, "fill-style"), nullptr);
}

TEST(Edits, AnOrderIsKeptEvenWhereItPutsTheOuterFirst) {
    const std::vector<std::string> wished{"outer", "line", "inner", "middle"};
    EXPECT_EQ(driven(planned({OrderEdit{wished}})), wished);
    EXPECT_EQ(driven(planned({OrderEdit{{"line", "line", "inner", "middle", "outer"}}})),
              (std::vector<std::string>{"line", "inner", "middle", "outer"}));
}

TEST(Edits, LinesDrawnByHandAreElementsInMetres) {
    const Path one = path_through({{2, 2}, {4, 2}}, false), two = path_through({{2, 3}, {4, 3}}, false);
    const Plan plan = planned({DrawEdit{"pen", {one, two}, 3, 0}});
    EXPECT_EQ(std::get<LineElement>(element(plan, "pen").what), (LineElement{one, 3}));
    EXPECT_EQ(std::get<LineElement>(element(plan, "pen/2").what).path, two);
    const auto bare = Planner().plan({"", "sketch"}, *builtin_robot("beachbot"), {}, plan.edits);
    ASSERT_TRUE(bare) << sentence(bare.error());
    EXPECT_EQ(ids(*bare), (std::vector<std::string>{"pen", "pen/2"}));
}

TEST(Edits, OneWhosePlaceIsGoneIsListedAndChangesNothing) {
    const std::vector<Edit> edits{HintEdit{"gone", "ink", "off"}, HintEdit{"line", "pause", "x"},
                                  OrderEdit{{"gone"}}};
    Plan plan = planned(edits);
    EXPECT_EQ(plan.idle_edits.size(), 3u);
    const Plan without = planned({});
    EXPECT_EQ(plan.samples, without.samples);
}

TEST(Planner, PlansAsIfItHadKeptNothing) {
    Planner planner;
    const Robot beachbot = *builtin_robot("beachbot"), turf = *builtin_robot("turf");
    Options wide, zigzag;
    wide.canvas.width = 20;
    zigzag.fill.style = "zigzag";
    const std::vector<Edit> none, erased{HintEdit{"middle", "ink", "off"}},
        turned{HintEdit{"inner", "fill-style", "spiral"}},
        drawn{DrawEdit{"pen", {path_through({{2, 2}, {4, 5}}, false)}, 1, 0}};
    struct Round {
        const Robot& robot;
        Options options;
        const std::vector<Edit>& edits;
    };
    for (const Round& round :
         {Round{beachbot, {}, none}, Round{beachbot, {}, erased}, Round{beachbot, {}, turned},
          Round{beachbot, zigzag, turned}, Round{turf, zigzag, drawn}, Round{beachbot, wide, drawn},
          Round{beachbot, {}, none}}) {
        const auto kept = planner.plan(source, round.robot, round.options, round.edits);
        const auto fresh = make_plan(source, round.robot, round.options, round.edits);
        ASSERT_TRUE(kept && fresh);
        EXPECT_EQ(*kept, *fresh);
    }
}

}  // namespace
}  // namespace strandline
