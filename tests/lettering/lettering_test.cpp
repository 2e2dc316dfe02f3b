// A font of our own, small enough to know every number by heart.
#include "input/lettering/lettering.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace strandline::lettering {
namespace {

/// ' ' is 6 units wide, '!' a bar, '"' no ink at all; 30 further places are spaces, then 'A' (a bar from cap
/// line -12 to base line 9 and a foot to the right), 'B' the same wider, 'C' under the base line to 16.
std::string tiny() {
    std::string text = "    1  1OU\n    2  3MWRFR[\n    3  1NV\n";
    for (int i = 3; i < 33; ++i) text += "    4  1OU\n";
    text += "    5  6MWMFM[ RM[W[\n";  // A: bounds -5..5
    text += "    6  6HWHFH[ RH[W[\n";  // B: bounds -10..5
    text += "    7  3MWMFMb\n";        // C
    return text;
}
Font font() {
    const auto read = read_font(tiny(), "tiny");
    EXPECT_TRUE(read) << (read ? "" : sentence(read.error()));
    return read.value_or(Font{});
}
svg::Document drawn(const std::string& text, const Options& options = {}) {
    auto document = lettered(text, font(), options);
    if (!document) {
        ADD_FAILURE() << sentence(document.error());
        return {};
    }
    return *document;
}
std::vector<std::string> ids(const svg::Document& document) {
    std::vector<std::string> names;
    for (const svg::Shape& shape : document.shapes) names.push_back(shape.id);
    return names;
}
Point start_of(const svg::Document& document, std::size_t shape) {
    return document.shapes.at(shape).subpaths.front().start;
}
std::string refusal(const Outcome<svg::Document>& outcome) {
    return outcome ? "was drawn" : sentence(outcome.error());
}

TEST(Font, GlyphsHaveTheirBoundsAndStrokes) {
    const Font f = font();
    ASSERT_EQ(f.glyphs.size(), 36U);
    EXPECT_EQ(f.cap_line, -12);
    EXPECT_EQ(f.base_line, 9);
    const Glyph& a = f.glyphs['A' - ' '];
    EXPECT_EQ(a.left, -5);
    EXPECT_EQ(a.right, 5);
    ASSERT_EQ(a.strokes.size(), 2U);
    EXPECT_EQ(a.strokes[0], (Polyline{{-5, -12}, {-5, 9}}));
    EXPECT_EQ(a.strokes[1], (Polyline{{-5, 9}, {5, 9}}));
}
TEST(Font, AGlyphMayRunOverSeveralLinesAndLinesMayEndAsOnDos) {
    std::string folded = tiny();
    folded.insert(folded.find("MFM[ RM[W[") + 4, "\r\n");
    const auto read = read_font(folded, "f");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->glyphs['A' - ' '].strokes, font().glyphs['A' - ' '].strokes);
}
TEST(Font, WhatIsNoFontIsRefusedWithItsLine) {
    const auto refused = [](const std::string& text, const std::string& words) {
        const auto read = read_font(text, "f.jhf");
        ASSERT_FALSE(read) << text;
        EXPECT_NE(sentence(read.error()).find(words), std::string::npos) << sentence(read.error());
    };
    refused("", "no glyphs");
    refused("hello", "line 1");
    refused(tiny() + "    8  9MWMFMb\n", "line 37");
    refused(tiny() + "    8  2MWM\xff\n", "line 37");
    refused(tiny() + "    8  2WMMM\n", "line 37");
    refused("    1  1OU\n", "A to Z");
}

TEST(Lettering, TheHeightIsFromBaseLineToCapLine) {
    const svg::Document document = drawn("A", {.height = 2.1, .stroke_width = 4});
    ASSERT_EQ(document.shapes.size(), 2U);
    EXPECT_EQ(document.shapes[0].subpaths.front(), path_through({{2, 2}, {2, 2102}}, false));
    EXPECT_EQ(document.shapes[1].subpaths.front(), path_through({{2, 2102}, {1002, 2102}}, false));
    EXPECT_EQ(document.view, (Box{{0, 0}, {1004, 2104}}));
    EXPECT_EQ(document.size_metres, (Point{1.004, 2.104}));
    EXPECT_FALSE(document.shapes[0].fill);
}
TEST(Lettering, GlyphsStandSideBySideByTheirWidths) {
    // 21 units are 21 mm: A is 10 wide, the space 6, B's bar stands on its left bound.
    const svg::Document document = drawn("A B", {.height = 0.021, .stroke_width = 2});
    EXPECT_EQ(ids(document), (std::vector<std::string>{"t.1.1.A.1", "t.1.1.A.2", "t.1.3.B.1", "t.1.3.B.2"}));
    EXPECT_EQ(start_of(document, 2), (Point{17, 1}));
}
TEST(Lettering, AStrokeIsAMillimetreWideUnlessTheLettersAreSmall) {
    EXPECT_EQ(drawn("A", {.height = 1}).shapes[0].stroke_width, 1);
    EXPECT_EQ(drawn("A", {.height = 0.006}).shapes[0].stroke_width, 0.5);
}
TEST(Lettering, LettersMayBeSpaced) {
    EXPECT_EQ(start_of(drawn("AA", {.height = 0.021, .stroke_width = 2, .letter_spacing = 0.003}), 2),
              (Point{14, 1}));
}
TEST(Lettering, LinesAreAlignedByTheirWidths) {
    const auto starts = [](Align align) {
        const svg::Document d = drawn("A\nAB", {.height = 0.021, .align = align, .stroke_width = 2});
        return std::pair{start_of(d, 0).x, start_of(d, 2).x};
    };
    EXPECT_EQ(starts(Align::left), (std::pair{1.0, 1.0}));
    EXPECT_EQ(starts(Align::centre), (std::pair{8.5, 1.0}));
    EXPECT_EQ(starts(Align::right), (std::pair{16.0, 1.0}));
}
TEST(Lettering, LinesAreSpacedInHeightsAndEmptyOnesCount) {
    const svg::Document document = drawn("A\n\nA", {.height = 0.021, .line_spacing = 2, .stroke_width = 2});
    EXPECT_EQ(start_of(document, 2), (Point{1, 1 + 2 * 2 * 21}));
    EXPECT_EQ(document.shapes[2].id, "t.3.1.A.1");
}
TEST(Lettering, IdsNameSignsByTheirNumbers) { EXPECT_EQ(ids(drawn("!")).front(), "t.1.1.u0021.1"); }

TEST(Lettering, UnknownCharactersAreNamedInOneWarning) {
    const svg::Document document = drawn("AzA\xC3\xBC\nz\t");
    ASSERT_EQ(document.warnings.size(), 1U);
    EXPECT_EQ(sentence(document.warnings[0]),
              "text, line 1, character 2: the font tiny has no \"z\", \"\xC3\xBC\", U+0009: left out (4 in "
              "all)");
    EXPECT_EQ(document.shapes.size(), 4U);
}
TEST(Lettering, WhatCannotBeLetteredIsRefused) {
    const Font f = font();
    EXPECT_NE(refusal(lettered("", f, {})).find("nothing to draw"), std::string::npos);
    EXPECT_NE(refusal(lettered(" \n ", f, {})).find("nothing to draw"), std::string::npos);
    EXPECT_NE(refusal(lettered("zz", f, {})).find("\"z\""), std::string::npos);
    for (const char* bytes :
         {"A\xff", "A\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe0\x80\x80"})
        EXPECT_NE(refusal(lettered(bytes, f, {})).find("UTF-8"), std::string::npos);
    EXPECT_NE(refusal(lettered("A", f, {.height = 0})).find("height"), std::string::npos);
    EXPECT_NE(refusal(lettered("A", f, {.height = 1e9})).find("height"), std::string::npos);
    EXPECT_NE(refusal(lettered("A", f, {.stroke_width = -1})).find("stroke width"), std::string::npos);
    EXPECT_NE(refusal(lettered(std::string(100'001, 'A'), f, {})).find("100000"), std::string::npos);
}

}  // namespace
}  // namespace strandline::lettering
