// Text in DejaVu Sans, which scripts/setup.sh installs for the tests.
#include "input/typeset/typeset.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace strandline::typeset {
namespace {

using Anchor = svg::TextSpan::Anchor;

svg::TextSpan span(const std::string& text, const std::string& family = "DejaVu Sans", double size = 100) {
    svg::TextSpan s;
    s.text = text;
    s.family = family;
    s.size = size;
    return s;
}
Outlines set(std::vector<svg::TextSpan> spans, const Options& options = {}) {
    static const Typesetter typesetter;
    auto outlines = typesetter.outlines({"t", "line 1, <text>", std::move(spans)}, options);
    if (!outlines) {
        ADD_FAILURE() << sentence(outlines.error());
        return {};
    }
    return *outlines;
}
Box box_of(const std::vector<Path>& paths) {
    Box box;
    for (const Path& path : paths) box = united(box, bounds(path));
    return box;
}
Box box_of(const svg::TextSpan& s) { return box_of(set({s}).spans.at(0)); }
bool installed() { return set({span("I")}).warnings.empty(); }
#define NEEDS_DEJAVU() \
    if (!installed()) GTEST_SKIP() << "DejaVu Sans is not installed"

TEST(Typeset, ALetterStandsOnItsBaseLineAtItsSize) {
    NEEDS_DEJAVU();
    svg::TextSpan s = span("I");
    s.x = {10};
    s.y = {200};
    const Outlines outlines = set({s});
    ASSERT_EQ(outlines.spans.size(), 1U);
    ASSERT_EQ(outlines.spans[0].size(), 1U);
    const Path& path = outlines.spans[0][0];
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(end_of(path), path.start);
    // DejaVu Sans has 2048 units to the em; its I is a box from (201, 0) to (403, 1493).
    const Box box = bounds(path);
    EXPECT_NEAR(box.low.x, 10 + 100 * 201 / 2048.0, 1e-3);
    EXPECT_NEAR(box.high.x, 10 + 100 * 403 / 2048.0, 1e-3);
    EXPECT_NEAR(box.low.y, 200 - 100 * 1493 / 2048.0, 1e-3);
    EXPECT_NEAR(box.high.y, 200, 1e-3);
}
TEST(Typeset, OutlinesHaveHolesByWinding) {
    NEEDS_DEJAVU();
    const std::vector<Path> o = set({span("o")}).spans.at(0);
    ASSERT_EQ(o.size(), 2U);
    EXPECT_LT(signed_area(flattened(o[0], 0.01)) * signed_area(flattened(o[1], 0.01)), 0);
}
TEST(Typeset, SizeScalesAndTextIsAnchored) {
    NEEDS_DEJAVU();
    const Box one = box_of(span("Hamburg")), two = box_of(span("Hamburg", "DejaVu Sans", 200));
    EXPECT_NEAR(two.width(), 2 * one.width(), 1e-6);
    svg::TextSpan s = span("III");
    s.x = {500};
    double left[3];
    for (const Anchor anchor : {Anchor::start, Anchor::middle, Anchor::end}) {
        s.anchor = anchor;
        left[static_cast<int>(anchor)] = box_of(s).low.x;
    }
    const double advance = 3 * 100 * 604 / 2048.0;  // the I's, each
    EXPECT_NEAR(left[0] - left[1], advance / 2, 1e-3);
    EXPECT_NEAR(left[0] - left[2], advance, 1e-3);
}
TEST(Typeset, SpansGoOnAndAreAnchoredTogether) {
    NEEDS_DEJAVU();
    svg::TextSpan first = span("II"), second = span("I");
    first.x = {500};
    first.anchor = Anchor::end;
    const Outlines parts = set({first, second});
    svg::TextSpan whole = span("III");
    whole.x = {500};
    whole.anchor = Anchor::end;
    EXPECT_NEAR(box_of(parts.spans[1]).high.x, box_of(whole).high.x, 1e-6);
    EXPECT_NEAR(box_of(parts.spans[0]).low.x, box_of(whole).low.x, 1e-6);
}
TEST(Typeset, CharactersHavePlacesShiftsAndTurnsOfTheirOwn) {
    NEEDS_DEJAVU();
    svg::TextSpan s = span("IIII");
    s.x = {0, 300};
    s.dy = {0, 0, 50};
    const std::vector<Path> paths = set({s}).spans.at(0);
    ASSERT_EQ(paths.size(), 4U);
    const auto at = [&](std::size_t i) { return bounds(paths[i]).low; };
    EXPECT_NEAR(at(1).x - at(0).x, 300, 1e-6);
    EXPECT_NEAR(at(2).x - at(1).x, 100 * 604 / 2048.0, 1e-3);
    EXPECT_NEAR(at(2).y - at(1).y, 50, 1e-6);
    EXPECT_NEAR(at(3).y - at(2).y, 0, 1e-6);
    svg::TextSpan turned = span("I");
    turned.rotate = {90};
    const Box box = box_of(turned);  // on its side, its top to the right
    EXPECT_NEAR(box.high.x, 100 * 1493 / 2048.0, 1e-3);
    EXPECT_NEAR(box.low.y, 100 * 201 / 2048.0, 1e-3);
}
TEST(Typeset, LettersAreSpaced) {
    NEEDS_DEJAVU();
    svg::TextSpan s = span("II");
    const double before = box_of(s).width();
    s.letter_spacing = 7;
    EXPECT_NEAR(box_of(s).width(), before + 7, 0.01);
}
TEST(Typeset, AFontThatIsAbsentIsNamedWithTheOneUsed) {
    const Outlines outlines = set({span("I", "'No Such Font', serif"), span("J", "No Such Font")});
    ASSERT_EQ(outlines.warnings.size() >= 1, true);
    EXPECT_EQ(outlines.warnings[0].place, "line 1, <text>");
    EXPECT_NE(outlines.warnings[0].reason.find("No Such Font is not on this machine: "), std::string::npos);
    EXPECT_FALSE(outlines.spans[0].empty());
    static const Typesetter typesetter;
    const auto strict =
        typesetter.outlines({"t", "here", {span("I", "No Such Font")}}, {.substitutes = false});
    ASSERT_FALSE(strict);
    EXPECT_NE(sentence(strict.error()).find("No Such Font"), std::string::npos);
    EXPECT_TRUE(set({span("I", "sans-serif")}, {.substitutes = false}).warnings.empty());
}
TEST(Typeset, ATextWithoutFontSaysWhichIsUsed) {
    const Outlines outlines = set({span("I", "")});
    ASSERT_EQ(outlines.warnings.size(), 1U);
    EXPECT_NE(outlines.warnings[0].reason.find("names no font"), std::string::npos);
}
TEST(Typeset, WhatNoFontHasIsNamed) {
    const Outlines outlines = set({span("I\xF3\xB0\x80\x80", "sans-serif")});  // U+F0000, for private use
    ASSERT_FALSE(outlines.warnings.empty());
    EXPECT_NE(outlines.warnings.back().reason.find("\xF3\xB0\x80\x80"), std::string::npos);
}
TEST(Typeset, BytesThatAreNoTextAreRefused) {
    const Typesetter typesetter;
    EXPECT_FALSE(typesetter.outlines({"t", "here", {span("\xff")}}));
    svg::TextSpan wide = span("II");
    wide.letter_spacing = 1e12;
    EXPECT_FALSE(typesetter.outlines({"t", "here", {wide}}));
    EXPECT_FALSE(typesetter.outlines({"t", "here", {span(std::string(20'000, 'I'))}}));
}
TEST(Typeset, ALongLineKeepsItsPlaces) {
    NEEDS_DEJAVU();
    EXPECT_NEAR(box_of(span(std::string(10'000, 'I'))).width(), 100 * (9'999 * 604 + 202) / 2048.0, 1);
}
TEST(Typeset, TheSameTwice) {
    const Typesetter other;
    const svg::Text text{"t", "here", {span("Strandline fi \xC3\xBC", "sans-serif")}};
    EXPECT_EQ(other.outlines(text)->spans, Typesetter().outlines(text)->spans);
}

}  // namespace
}  // namespace strandline::typeset
