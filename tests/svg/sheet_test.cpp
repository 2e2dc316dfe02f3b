// Style sheets: what wins, what is inherited, what is passed over and said.
#include <gtest/gtest.h>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

const Colour red{255, 0, 0}, lime{0, 255, 0}, blue{0, 0, 255}, black{0, 0, 0};

/// The fill of the element #x, under that sheet.
Colour filled(const std::string& sheet, const std::string& elements) {
    const auto document = drawn("<style>" + sheet + "</style>" + elements);
    for (const auto& shape : document.shapes)
        if (shape.id == "x") return shape.fill.value_or(Paint{{1, 2, 3}, 0}).colour;
    ADD_FAILURE() << "no #x: " << elements;
    return {};
}
const std::string square = "<rect id='x' class='a b' width='9' height='9'/>";
const std::string nested = "<g id='outer' class='group'><g class='middle'>" + square + "</g></g>";

TEST(Sheet, EverySimpleSelectorFindsItsElements) {
    for (const char* sheet : {"rect{fill:red}", ".a{fill:red}", ".b{fill:red}", "#x{fill:red}", "*{fill:red}",
                              "rect.a.b#x{fill:red}", " .none , .a { fill : red ; } ", "rect{}rect{fill:red"})
        EXPECT_EQ(filled(sheet, square), red) << sheet;
    for (const char* sheet : {"circle{fill:red}", ".c{fill:red}", "#y{fill:red}", "rect.c{fill:red}",
                              ".A{fill:red}", "RECT{fill:red}", ".a-b{fill:red}"})
        EXPECT_EQ(filled(sheet, square), black) << sheet;
}

TEST(Sheet, AncestorsAndParentsAreToldApart) {
    for (const char* sheet :
         {".group rect{fill:red}", "#outer .middle>rect{fill:red}", "g g rect{fill:red}",
          "svg > g > g > rect{fill:red}", "svg>g rect{fill:red}", "#outer > g rect{fill:red}"})
        EXPECT_EQ(filled(sheet, nested), red) << sheet;
    for (const char* sheet : {".group>rect{fill:red}", "g g g rect{fill:red}",
                              ".middle .group rect{fill:red}", "svg>g>rect{fill:red}"})
        EXPECT_EQ(filled(sheet, nested), black) << sheet;
}

TEST(Sheet, ANearerParentIsTriedAgainFurtherOut) {
    // The nearest g has no svg as its parent; the one around it has.
    EXPECT_EQ(filled("svg>g rect{fill:red}", "<g><g><g>" + square + "</g></g></g>"), red);
    EXPECT_EQ(filled(".p>.q rect{fill:red}",
                     "<g class='p'><g class='q'><g><g class='q'>" + square + "</g></g></g></g>"),
              red);
}

TEST(Sheet, SpecificityThenOrderDecides) {
    EXPECT_EQ(filled("#x{fill:red}.a{fill:lime}rect{fill:blue}", square), red);
    EXPECT_EQ(filled(".a{fill:lime}rect{fill:blue}*{fill:red}", square), lime);
    EXPECT_EQ(filled(".a{fill:lime}.b{fill:blue}", square), blue);
    EXPECT_EQ(filled(".b{fill:blue}.a{fill:lime}", square), lime);
    EXPECT_EQ(filled(".a.b{fill:lime}.b{fill:blue}", square), lime);
    EXPECT_EQ(filled("g rect{fill:lime}rect{fill:blue}", nested), lime);
}

TEST(Sheet, TheStyleAttributeWinsOverSheetsAndTheseOverAttributes) {
    const auto element = [](const std::string& more) {
        return "<rect id='x' class='a' width='9' height='9' " + more + "/>";
    };
    EXPECT_EQ(filled(".a{fill:lime}", element("fill='red'")), lime);
    EXPECT_EQ(filled(".a{fill:lime}", element("style='fill:blue'")), blue);
    EXPECT_EQ(filled(".a{fill:lime!important}", element("style='fill:blue'")), lime);
    EXPECT_EQ(filled(".a{fill:lime ! IMPORTANT}", element("style='fill:blue !important'")), blue);
    EXPECT_EQ(filled(".a{fill:lime!important}#x{fill:red}", element("")), lime);
    EXPECT_EQ(filled("*{fill:lime}", element("fill='red'")), lime);  // even the weakest rule
}

TEST(Sheet, ValuesInheritFromStyledGroups) {
    EXPECT_EQ(filled(".group{fill:red}", nested), red);
    EXPECT_EQ(filled(".group{fill:red}.middle{fill:inherit}#x{fill:inherit}", nested), red);
    EXPECT_EQ(filled(".group{color:lime;fill:red}#x{fill:currentColor}", nested), lime);
    EXPECT_EQ(filled(".group{fill:red}#x{fill:initial}", nested), black);
}

TEST(Sheet, CommentsCdataAndSeveralSheetsAreRead) {
    EXPECT_EQ(filled("/* .a{fill:red} */.a/**/{/* ; */fill:lime/*x*/;}", square), lime);
    EXPECT_EQ(filled("<![CDATA[ .a > .b {} .a { fill: lime } ]]>", square), lime);
    EXPECT_EQ(filled(".a{fill:red}", "<defs><style type='text/css'>.a{fill:lime}</style></defs>" + square),
              lime);
    EXPECT_EQ(filled("", square + "<style>.a{fill:lime}</style>"), lime);  // sheets hold for the whole file
}

TEST(Sheet, WhatIsNotReadIsPassedOverAndSaid) {
    const auto document = drawn(
        "\n<style>@import url('x;y.css');@font-face{font-family:x;src:url(data:x)}"
        "@media print{.a{fill:red}}.a:hover,[class~=a],.a+.a,.a{fill:lime}</style>" +
        square);
    EXPECT_EQ(document.shapes.at(0).fill->colour, lime);
    EXPECT_TRUE(warns_of(document,
                         "line 2, <style>: a part of a style sheet that is not read: passed over: "
                         "@import (2 times, first here)"))
        << all_warnings(document);
    EXPECT_TRUE(warns_of(document, "@font-face in a style sheet"));
    EXPECT_TRUE(
        warns_of(document, "a selector that is not read: its rule is not followed: .a:hover (3 times"));
    EXPECT_TRUE(warns_of(drawn("<style>.a{fill:red</style>" + square), "") &&
                drawn("<style>.a</style>").warnings.size() == 1);
    EXPECT_TRUE(warns_of(drawn("<style type='text/less'>.a{fill:red}</style>"), "of another language"));
    EXPECT_TRUE(warns_of(drawn("<style media='print'>.a{fill:red}</style>"), "for other media"));
}

TEST(Sheet, ExternalSheetsAreSaid) {
    EXPECT_TRUE(warns_of(read_well("<?xml-stylesheet href='a.css'?><svg><path d='M0 0h1'/></svg>"),
                         "a style sheet in another file"));
}

TEST(Sheet, GradientStopsTakeClassesToo) {
    const auto document = drawn(
        "<style>.s{stop-color:lime}#x{fill:url(#g)}</style><linearGradient id='g'><stop class='s'/>"
        "</linearGradient>" +
        square);
    EXPECT_EQ(document.shapes.at(0).fill->colour, lime);
}

TEST(Sheet, SeparatorsInsideQuotesAndBracketsDoNotEnd) {
    EXPECT_EQ(filled(".a{font-family:'a;b}c';fill:lime}", square), lime);
    EXPECT_EQ(filled(".a{marker:url(a;b);fill:lime}", square), lime);
}

TEST(Sheet, HidingByClassCounts) {
    EXPECT_TRUE(drawn("<style>.a{display:none}</style>" + square).shapes.empty());
    EXPECT_TRUE(drawn("<style>g{visibility:hidden}</style><g>" + square + "</g>").shapes.empty());
    const auto moved = drawn("<style>.a{transform:translate(5px,6px)}</style>" + square);
    EXPECT_EQ(moved.shapes.at(0).subpaths.at(0).start, (Point{5, 6}));
}

TEST(Sheet, EndlessMatchingIsRefused) {
    std::string selector = "b ", elements, closing;
    for (int i = 0; i < 30; ++i) selector += "g g>";
    for (int i = 0; i < 400; ++i) {
        elements += "<g>";
        closing += "</g>";
    }
    const auto document = read("<svg><style>" + selector + "a rect{}</style>" + elements +
                                   "<a><rect width='9' height='9'/></a>" + closing + "</svg>",
                               {.limits = {.steps = 100'000}});
    ASSERT_FALSE(document);
    EXPECT_NE(document.error().reason.find("too many"), std::string::npos);
}

}  // namespace
}  // namespace strandline::svg
