// use, symbol, nested svg, layers, hints.
#include <gtest/gtest.h>

#include <chrono>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

const std::string dot = "<rect id='dot' width='2' height='2'/>";

Box box_of(const Shape& shape) {
    Box box;
    for (const auto& path : shape.subpaths) box = united(box, bounds(path));
    return box;
}
void expect_box(const Shape& shape, Box box) {
    expect_near(box_of(shape).low, box.low, 1e-9);
    expect_near(box_of(shape).high, box.high, 1e-9);
}

TEST(Use, DrawsAgainMovedAndStyled) {
    const auto document = drawn("<defs>" + dot + "</defs><use id='u' href='#dot' x='5' y='6' fill='red'/>" +
                                "<use xlink:href='#dot' transform='scale(3)' style='fill:lime'/>");
    ASSERT_EQ(document.shapes.size(), 2u) << all_warnings(document);
    expect_box(document.shapes[0], {{5, 6}, {7, 8}});
    expect_box(document.shapes[1], {{0, 0}, {6, 6}});
    EXPECT_EQ(document.shapes[0].fill->colour, (Colour{255, 0, 0}));
    EXPECT_EQ(document.shapes[0].id, "u");
    EXPECT_EQ(document.shapes[1].id, "use@1:161");
}

TEST(Use, ThePartsOfAGroupAreNamedByTheUseAndThemselves) {
    const auto document =
        drawn("<g id='pair'>" + dot + "<rect width='3' height='3'/></g><use id='a' href='#pair'/>" +
              "<g id='twice'><use id='b' href='#pair'/></g><use id='c' href='#twice' x='9'/>");
    ASSERT_EQ(document.shapes.size(), 8u);
    EXPECT_EQ(document.shapes[2].id, "a/dot");
    EXPECT_EQ(document.shapes[4].id, "b/dot");
    EXPECT_EQ(document.shapes[6].id, "c/b/dot");
    EXPECT_EQ(document.shapes[7].id, "c/b/rect@1:113");
}

TEST(Use, StylesInheritFromTheUseAndMatchWhereTheElementStands) {
    const auto document = drawn("<style>defs rect{stroke:red}.wild rect{fill:lime}</style><defs>" + dot +
                                "</defs><g class='wild' fill='blue'><use href='#dot'/></g>");
    ASSERT_EQ(document.shapes.size(), 1u);
    EXPECT_EQ(document.shapes[0].fill->colour, (Colour{0, 0, 255}));
    EXPECT_EQ(document.shapes[0].stroke->colour, (Colour{255, 0, 0}));
}

TEST(Use, ASymbolIsFittedToTheSizeOfTheUseAndCutThere) {
    const auto document = drawn(
        "<symbol id='s' viewBox='0 0 10 10'><rect width='20' height='5'/></symbol>"
        "<use href='#s' x='10' y='20' width='40' height='30'/>");
    ASSERT_EQ(document.shapes.size(), 1u);
    // 10 units become 30, centred in 40; the symbol shows what is in its 40 x 30
    expect_box(document.shapes[0], {{15, 20}, {50, 35}});
    EXPECT_TRUE(drawn("<symbol id='s'>" + dot + "</symbol>").shapes.empty());
    EXPECT_EQ(drawn("<symbol id='s'>" + dot + "</symbol><use href='#s'/>").shapes.size(), 1u);
}

TEST(Use, CirclesAreSaidWithTheirPlace) {
    for (const char* text :
         {"\n<g id='a'><use href='#a'/></g>",
          "\n<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>", "\n<use id='a' href='#a'/>"}) {
        const auto document = drawn(std::string(text) + dot);
        EXPECT_EQ(document.shapes.size(), 1u) << text;
        EXPECT_TRUE(warns_of(document, "line 2, <use>")) << all_warnings(document);
        EXPECT_TRUE(warns_of(document, "a reference in a circle: passed over"));
    }
}

TEST(Use, WhatCannotBeDrawnIsSaid) {
    EXPECT_TRUE(warns_of(drawn("<use href='#no'/>"), "<use> of what is not in the file: draws nothing: #no"));
    EXPECT_TRUE(warns_of(drawn("<use href='a.svg#no'/>"), "<use> of another file"));
    EXPECT_TRUE(warns_of(drawn("<use/>"), "<use> of another file"));
    EXPECT_TRUE(warns_of(drawn("<linearGradient id='l'/><use href='#l'/>"), "draws nothing by itself"));
}

TEST(Use, ABombIsRefusedInTime) {
    std::string bomb = "<svg><defs><g id='g0'>" + dot + "</g>";
    for (int i = 1; i < 40; ++i) {
        bomb += "<g id='g" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) bomb += "<use href='#g" + std::to_string(i - 1) + "'/>";
        bomb += "</g>";
    }
    const auto error = read(bomb + "</defs><use href='#g39'/></svg>", {.limits = {.expanded = 1000}}).error();
    EXPECT_EQ(error.reason, "more than 1000 elements are drawn through <use>, markers and clips");
}

TEST(NestedSvg, CutsAtItsEdgesUnlessItOverflows) {
    const std::string inside = "<rect width='20' height='20'/></svg>";
    expect_box(first_shape("<svg x='5' y='5' width='10' height='10'>" + inside), {{5, 5}, {15, 15}});
    expect_box(first_shape("<svg x='5' y='5' width='10' height='10' overflow='visible'>" + inside),
               {{5, 5}, {25, 25}});
    expect_box(first_shape("<svg x='5' y='5' width='10' height='10' style='overflow:hidden'>" + inside),
               {{5, 5}, {15, 15}});
    EXPECT_TRUE(warns_of(drawn("<svg width='10' height='10'><rect x='50' width='9' height='9'/></svg>"),
                         "wholly outside its clip"));
}

TEST(NestedSvg, PercentagesAreOfTheNearestViewport) {
    expect_box(first_shape("<svg width='50%' height='20%'><rect width='50%' height='50%'/></svg>"),
               {{0, 0}, {25, 10}});
    expect_box(
        first_shape("<svg width='50' height='20' viewBox='0 0 5 2'><rect width='50%' height='50%'/></svg>"),
        {{0, 0}, {25, 10}});
    EXPECT_DOUBLE_EQ(first_shape("<svg width='30' height='40' overflow='visible'><path stroke='red' "
                                 "stroke-width='10%' d='M0 0h1'/></svg>")
                         .stroke_width,
                     5 / std::sqrt(2));
}

TEST(Layers, InkscapesNestAndHiddenOnesAreLeftOut) {
    const auto document = drawn("<g inkscape:groupmode='layer' id='l1' inkscape:label='Sea'><g id='waves'>" +
                                dot + "<g inkscape:groupmode='layer' inkscape:label='Foam'>" + dot +
                                "</g></g></g>"
                                "<g inkscape:groupmode='layer' inkscape:label='Notes' style='display:none'>" +
                                dot + "</g>");
    ASSERT_EQ(document.shapes.size(), 2u);
    ASSERT_EQ(document.layers.size(), 2u);
    EXPECT_EQ(document.layers[1].name, "Foam");
    EXPECT_EQ(document.layers[1].parent, 0);
    EXPECT_EQ(document.layers[0].id, "l1");
    EXPECT_EQ(document.shapes[1].layer_index, 1);
    EXPECT_EQ(document.shapes[1].layer, "Sea/Foam");
    EXPECT_TRUE(warns_of(document, "hidden (display: none): left out"));
}

TEST(Layers, OtherProgramsLayersAreTheOutermostNamedGroups) {
    const auto document =
        drawn("<g><g id='Layer_x20_1'><g id='eye'>" + dot + "</g></g></g><g id='b' data-name='Ebene 2'>" +
              dot + "</g>" + dot + "<g id='c' serif:id='Sky &amp; sea'>" + dot + "</g>");
    ASSERT_EQ(document.layers.size(), 3u);
    EXPECT_EQ(document.layers[0].name, "Layer 1");
    EXPECT_EQ(document.layers[1].name, "Ebene 2");
    EXPECT_EQ(document.layers[2].name, "Sky & sea");
    EXPECT_EQ(document.shapes[0].layer_index, 0);
    EXPECT_EQ(document.shapes[2].layer_index, -1);
    EXPECT_EQ(document.shapes[0].layer, "");
}

TEST(Hints, AreTheElementsOwnAndItsGroups) {
    const auto document = drawn(
        "<g data-strandline-fill='zigzag' data-strandline-order='3'><g data-strandline-fill='rings'>" + dot +
        "<rect data-strandline-fill='spiral' data-other='1' width='1' height='1'/></g></g>" + dot);
    ASSERT_EQ(document.shapes.size(), 3u);
    EXPECT_EQ(document.shapes[0].hints, (std::vector<Hint>{{"fill", "rings"}, {"order", "3"}}));
    EXPECT_EQ(document.shapes[1].hints, (std::vector<Hint>{{"fill", "spiral"}, {"order", "3"}}));
    EXPECT_TRUE(document.shapes[2].hints.empty());
}

TEST(TransformOrigin, TurnsAboutThePointItNames) {
    expect_box(
        first_shape("<rect width='2' height='4' style='transform:rotate(90deg);transform-origin:2px 4px'/>"),
        {{2, 2}, {6, 4}});
    expect_box(first_shape("<rect width='2' height='4' transform='scale(2)' transform-origin='center'/>"),
               {{-50, -50}, {-46, -42}});
}

}  // namespace
}  // namespace strandline::svg
