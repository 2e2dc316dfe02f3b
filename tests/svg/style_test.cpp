#include <gtest/gtest.h>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

/// The fill of a rectangle with these attributes, inside groups with those.
std::optional<Paint> fill_of(const std::string& attributes, const std::string& group = "",
                             const std::string& defs = "") {
    const auto document =
        drawn(defs + "<g " + group + "><rect stroke='red' width='9' height='9' " + attributes + "/></g>");
    return document.shapes.empty() ? std::nullopt : document.shapes[0].fill;
}
Colour colour_of(const std::string& text) {
    const auto fill = fill_of("fill='" + text + "'");
    EXPECT_TRUE(fill) << text;
    return fill.value_or(Paint{{1, 2, 3}, 0}).colour;
}

TEST(Style, FillIsBlackAndStrokeIsNoneByDefault) {
    const auto shape = first_shape("<rect width='9' height='9'/>");
    EXPECT_EQ(shape.fill, (Paint{{0, 0, 0}, 1}));
    EXPECT_FALSE(shape.stroke);
    EXPECT_EQ(shape.stroke_width, 1);
    EXPECT_EQ(shape.fill_rule, FillRule::nonzero);
}

TEST(Style, ColoursAreReadInEveryNotation) {
    const Colour coral{255, 127, 80};
    for (const char* text :
         {"coral", "CORAL", "#ff7f50", "#FF7F50", "rgb(255,127,80)", "rgb( 255 127 80 )",
          "rgba(255,127,80,0.5)", "rgb(100%, 49.8%, 31.3725%)", "#ff7f50 icc-color(x, 1)", "rgb(300,127,80)"})
        EXPECT_EQ(colour_of(text), coral) << text;
    EXPECT_EQ(colour_of("#f80"), (Colour{255, 136, 0}));
    EXPECT_EQ(colour_of("hsl(120, 100%, 25%)"), (Colour{0, 128, 0}));
    EXPECT_EQ(colour_of("aliceblue"), (Colour{240, 248, 255}));
    EXPECT_EQ(colour_of("yellowgreen"), (Colour{154, 205, 50}));
}

TEST(Style, AlphaAndOpacitiesMultiply) {
    EXPECT_DOUBLE_EQ(fill_of("fill='#00000080'")->opacity, 128 / 255.0);
    EXPECT_DOUBLE_EQ(fill_of("fill='#0008'")->opacity, 136 / 255.0);
    EXPECT_DOUBLE_EQ(
        fill_of("fill='rgba(0,0,0,.5)' fill-opacity='50%' opacity='.5'", "opacity='0.5'")->opacity, 0.0625);
    EXPECT_FALSE(fill_of("fill='transparent'"));
    EXPECT_FALSE(fill_of("fill-opacity='-3'"));
    EXPECT_DOUBLE_EQ(fill_of("opacity='7'")->opacity, 1);
}

TEST(Style, TheStyleAttributeWinsOverPresentationAttributes) {
    EXPECT_EQ(fill_of("fill='red' style='fill:lime'")->colour, (Colour{0, 255, 0}));
    EXPECT_EQ(fill_of("style='fill:lime;fill : blue !important ;' fill='red'")->colour, (Colour{0, 0, 255}));
    EXPECT_EQ(fill_of("style='/* fill:red; */FILL:blue/**/'")->colour, (Colour{0, 0, 255}));
}

TEST(Style, ValuesAreInheritedAndInheritAsksForThem) {
    EXPECT_EQ(fill_of("", "fill='blue'")->colour, (Colour{0, 0, 255}));
    EXPECT_EQ(fill_of("fill='red' style='fill:inherit'", "fill='blue'")->colour, (Colour{0, 0, 255}));
    EXPECT_EQ(fill_of("fill='initial'", "fill='blue'")->colour, (Colour{0, 0, 0}));
    EXPECT_DOUBLE_EQ(fill_of("opacity='inherit'", "opacity='.5'")->opacity, 0.25);
}

TEST(Style, CurrentColorIsTheColorWhereItIsUsed) {
    EXPECT_EQ(fill_of("fill='currentColor' color='blue'")->colour, (Colour{0, 0, 255}));
    EXPECT_EQ(fill_of("color='lime'", "fill='currentcolor' color='red'")->colour, (Colour{0, 255, 0}));
}

TEST(Style, AValueThatIsNotUnderstoodLeavesTheInheritedOne) {
    const auto document =
        drawn("<g fill='blue'><rect width='9' height='9' fill='#12' stroke-linecap='pointy'/></g>");
    EXPECT_EQ(document.shapes.at(0).fill->colour, (Colour{0, 0, 255}));
    EXPECT_TRUE(warns_of(document, "fill: #12 (2 times, first here)"));
}

TEST(Style, StrokeWidthsHaveUnits) {
    const auto width = [](const std::string& text) {
        return first_shape("<path d='M0 0h9' stroke='red' font-size='20' stroke-width='" + text + "'/>")
            .stroke_width;
    };
    EXPECT_DOUBLE_EQ(width("3"), 3);
    EXPECT_DOUBLE_EQ(width("3px"), 3);
    EXPECT_DOUBLE_EQ(width("3pt"), 4);
    EXPECT_DOUBLE_EQ(width("1pc"), 16);
    EXPECT_DOUBLE_EQ(width("25.4mm"), 96);
    EXPECT_DOUBLE_EQ(width("2.54cm"), 96);
    EXPECT_DOUBLE_EQ(width("1in"), 96);
    EXPECT_DOUBLE_EQ(width("101.6Q"), 96);
    EXPECT_DOUBLE_EQ(width("1.5em"), 30);
    EXPECT_DOUBLE_EQ(width("5%"), 5);
    EXPECT_DOUBLE_EQ(width("bold"), 1);
}

TEST(Style, RuleCapAndJoinAreRead) {
    const auto shape = first_shape(
        "<g stroke-linecap='round'><path d='M0 0h9v9z' stroke='red' "
        "style='stroke-linejoin:bevel;fill-rule:evenodd'/></g>");
    EXPECT_EQ(shape.fill_rule, FillRule::even_odd);
    EXPECT_EQ(shape.cap, LineCap::round);
    EXPECT_EQ(shape.join, LineJoin::bevel);
}

TEST(Style, HiddenPartsAreLeftOutAndCounted) {
    const std::string rect = "<rect width='9' height='9'/>";
    const auto document = drawn("<g display='none'>" + rect + rect + "</g><g style='display:none'>" + rect +
                                "</g>" + "<g visibility='hidden'>" + rect +
                                "<rect width='9' height='9' visibility='visible' id='seen'/></g>");
    ASSERT_EQ(document.shapes.size(), 1u);
    EXPECT_EQ(document.shapes[0].id, "seen");
    EXPECT_TRUE(warns_of(document, "line 1, <g>: hidden (display: none): left out (2 times, first here)"));
    EXPECT_TRUE(warns_of(document, "hidden (visibility): left out"));
}

TEST(Style, WhatHasNoPaintIsLeftOutAndCounted) {
    const auto document =
        drawn("<path d='M0 0h9' fill='none'/><path d='M0 0h9' fill='none' stroke='red' stroke-width='0'/>");
    EXPECT_TRUE(document.shapes.empty());
    EXPECT_TRUE(warns_of(document, "neither filled nor stroked: draws nothing (2 times, first here)"));
}

TEST(Style, AStrokeUnderItsFillIsWarnedOfUnlessThatIsTheUsualOrder) {
    const std::string path = "<path d='M0 0h9v9z' stroke='red' ";
    EXPECT_TRUE(warns_of(drawn(path + "paint-order='stroke'/>"), "paint-order is not supported"));
    EXPECT_FALSE(warns_of(drawn(path + "style='paint-order:fill stroke'/>"), "paint-order is not supported"));
}

TEST(Style, AStrokeThatDoesNotScaleKeepsItsWidthOnThePage) {
    const auto document = read_well(
        "<svg viewBox='0 0 10 10' width='100' height='100'><path d='M0 0h1' stroke='red' stroke-width='5' "
        "transform='scale(3)' vector-effect='non-scaling-stroke'/></svg>");
    EXPECT_DOUBLE_EQ(document.shapes.at(0).stroke_width, 0.5);
}

const std::string gradients =
    "<linearGradient id='base'><stop stop-color='red'/><stop style='stop-color:blue'/></linearGradient>"
    "<radialGradient id='derived' xlink:href='#base'/><linearGradient id='plain'><stop "
    "stop-color='lime'/></linearGradient>"
    "<linearGradient id='fading'><stop/><stop stop-color='white' stop-opacity='0'/></linearGradient>"
    "<linearGradient id='empty'/><linearGradient id='a' href='#b'/><linearGradient id='b' "
    "href='#a'/><pattern id='dots'/>";

TEST(Style, AGradientCountsAsTheMeanOfItsStops) {
    EXPECT_EQ(fill_of("fill='url(#base)'", "", gradients)->colour, (Colour{128, 0, 128}));
    EXPECT_EQ(fill_of("fill='url( \"#derived\" ) red'", "", gradients)->colour, (Colour{128, 0, 128}));
    EXPECT_EQ(fill_of("fill='url(#fading)'", "", gradients), (Paint{{0, 0, 0}, 0.5}));
    EXPECT_TRUE(warns_of(drawn(gradients + "<path d='M0 0h1v1z' fill='url(#base)'/>"),
                         "a gradient: drawn as one ink"));
    EXPECT_TRUE(drawn(gradients + "<path d='M0 0h1v1z' fill='url(#plain)'/>").warnings.empty());
}

TEST(Style, PaintWithoutStopsOrTargetIsNoneOrItsFallback) {
    for (const char* id : {"empty", "a", "b", "absent"})
        EXPECT_FALSE(fill_of("fill='url(#" + std::string(id) + ")'", "", gradients)) << id;
    EXPECT_EQ(fill_of("fill='url(#absent) lime'", "", gradients)->colour, (Colour{0, 255, 0}));
    EXPECT_EQ(fill_of("fill='url(#dots)'", "", gradients)->colour, (Colour{0, 0, 0}));
}

}  // namespace
}  // namespace strandline::svg
