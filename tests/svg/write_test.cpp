// A written document, read back, is the same document.
#include <gtest/gtest.h>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

/// As read, written and read again.
void expect_same(const std::string& text) {
    const Document first = read_well(text), second = read_well(write(first));
    EXPECT_EQ(first.view, second.view);
    EXPECT_EQ(first.size_metres.has_value(), second.size_metres.has_value());
    if (first.size_metres && second.size_metres) {
        EXPECT_NEAR(distance(*first.size_metres, *second.size_metres), 0, 1e-12);
    }
    EXPECT_EQ(first.rake_sizes, second.rake_sizes);
    EXPECT_TRUE(second.warnings.empty()) << all_warnings(second);
    ASSERT_EQ(first.shapes.size(), second.shapes.size());
    for (std::size_t i = 0; i < first.shapes.size(); ++i) {
        const Shape &a = first.shapes[i], &b = second.shapes[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.layer, b.layer);
        EXPECT_EQ(a.subpaths, b.subpaths) << a.id;
        EXPECT_EQ(a.hints, b.hints) << a.id;
        EXPECT_EQ(a.fill, b.fill) << a.id;
        EXPECT_EQ(a.stroke, b.stroke) << a.id;
        EXPECT_TRUE(!a.fill || a.fill_rule == b.fill_rule) << a.id;
        if (a.stroke) {
            EXPECT_EQ(a.stroke_width, b.stroke_width) << a.id;
            EXPECT_EQ(a.cap, b.cap) << a.id;
            EXPECT_EQ(a.join, b.join) << a.id;
        }
    }
}

TEST(Write, PathsPaintsAndSizesComeBack) {
    expect_same(R"(<svg xmlns='http://www.w3.org/2000/svg' width='30mm' height='20mm' viewBox='-1.5 2 300 200'
        rake_sizes='0 1 2 3 4'>
      <path id='a' d='M0.1 0.2L1 7 3.3 4Z M5 5C6 6 7 8 9.7 1' fill='#102030' fill-rule='evenodd' opacity='.3'/>
      <path id='b &amp; &quot;c&quot; &lt;' d='M0 0L1e-9 123456.789' stroke='red' data-strandline-fill='zigzag' stroke-width='.7' fill='none'
        stroke-linecap='round' stroke-linejoin='bevel'/></svg>)");
}
TEST(Write, LayersComeBack) {
    expect_same(R"(<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'
        xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'>
      <path id='free' d='M0 0L1 1' stroke='black'/>
      <g inkscape:groupmode='layer' inkscape:label='sea &amp; sky'><path id='in' d='M0 0L2 1' stroke='black'/>
        <g inkscape:groupmode='layer' inkscape:label='deep'><path id='two' d='M0 0L2 1' stroke='black'/></g></g>
      <path id='last' d='M0 0L1 1' stroke='black'/></svg>)");
}
TEST(Write, DashesOfAFilledShapeAreASecondPath) {
    const Document first = drawn("<path id='a' d='M10 10H50V50H10Z' stroke='red' stroke-dasharray='5 3'/>");
    const Document second = read_well(write(first));
    ASSERT_EQ(second.shapes.size(), 2U);
    EXPECT_EQ(second.shapes[0].id, "a");
    EXPECT_FALSE(second.shapes[0].stroke);
    EXPECT_EQ(second.shapes[0].subpaths, first.shapes[0].subpaths);
    EXPECT_EQ(second.shapes[1].id, "a/stroke");
    EXPECT_FALSE(second.shapes[1].fill);
    EXPECT_EQ(second.shapes[1].subpaths, stroked_paths(first.shapes[0]));
}
TEST(Write, ArcsComeBackTurnedSkewedAndMirrored) {
    for (const char* map : {"rotate(30)", "scale(-1 1)", "skewX(25)", "matrix(1 .4 -2 .3 5 6)"}) {
        const Document first = drawn(std::string("<g transform='") + map +
                                     "'><ellipse cx='40' cy='30' rx='20' ry='7'/>"
                                     "<path d='M10 10A9 5 20 1 0 22 14A9 5 20 1 1 24 10'/></g>");
        const Document second = read_well(write(first));
        ASSERT_EQ(second.shapes.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            const Path &a = first.shapes[i].subpaths.front(), &b = second.shapes[i].subpaths.front();
            EXPECT_NEAR(length(a), length(b), 1e-7) << map;
            const Box p = bounds(a), q = bounds(b);
            EXPECT_NEAR(distance(p.low, q.low) + distance(p.high, q.high), 0, 1e-7) << map;
        }
    }
}

}  // namespace
}  // namespace strandline::svg
