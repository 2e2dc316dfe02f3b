// Lines whose ends meet, and lines that are there twice.
#include <gtest/gtest.h>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

using Ids = std::vector<std::string>;

/// Each segment goes on where the one before ended.
void expect_sound(const Path& path) {
    Point at = path.start;
    for (const Segment& segment : path.segments) {
        if (const auto* arc = std::get_if<ArcSegment>(&segment)) {
            const Point from = arc->center + std::cos(arc->start) * arc->u + std::sin(arc->start) * arc->v;
            EXPECT_NEAR(distance(from, at), 0, 1e-9);
        }
        at = end_of(segment);
    }
    EXPECT_TRUE(!path.closed || at == path.start);
}

TEST(Joining, TwoEndsThatMeetBecomeOneLineInAnySense) {
    const Path first = line({{0, 0}, {10, 0}}), second = line({{10.003, 0}, {20, 5}});
    for (const bool flip_first : {false, true})
        for (const bool flip_second : {false, true}) {
            const Drawing d = drawn({stroked(flip_first ? reversed(first) : first),
                                     stroked(flip_second ? reversed(second) : second)});
            ASSERT_EQ(ids(d), Ids{"a"});
            EXPECT_EQ(d.counts.joined, 1);
            EXPECT_EQ(line_of(d, 0).path.segments.size(), 2u);
            EXPECT_NEAR(length(d.elements[0]), 10 + std::sqrt(125), 0.01);
            expect_sound(line_of(d, 0).path);
            // The first piece keeps its sense.
            const Point start = line_of(d, 0).path.start, end = end_of(line_of(d, 0).path);
            EXPECT_EQ(start.x < end.x, !flip_first);
        }
}

TEST(Joining, EndsFartherThanTheToleranceStayApart) {
    EXPECT_EQ(
        drawn({stroked(line({{0, 0}, {10, 0}})), stroked(line({{10.006, 0}, {20, 5}}))}).elements.size(), 2u);
}

TEST(Joining, WhereThreeEndsMeetNothingIsJoined) {
    const Drawing d = drawn({stroked(line({{0, 0}, {10, 10}})), stroked(line({{20, 0}, {10, 10}})),
                             stroked(line({{10, 10}, {10, 30}}))});
    EXPECT_EQ(d.elements.size(), 3u);
    EXPECT_EQ(d.counts.joined, 0);
}

TEST(Joining, AChainThatComesRoundIsClosed) {
    const Drawing d = drawn({stroked(line({{0, 0}, {10, 0}})), stroked(line({{10, 10}, {10, 0}})),
                             stroked(line({{10, 10}, {0, 10}})), stroked(line({{0, 0}, {0, 10}}))});
    ASSERT_EQ(ids(d), Ids{"a"});
    EXPECT_TRUE(line_of(d, 0).path.closed);
    EXPECT_EQ(d.counts.joined, 4);
    EXPECT_NEAR(length(d.elements[0]), 40, 1e-9);
    expect_sound(line_of(d, 0).path);
}

TEST(Joining, APathWhoseEndsMeetIsClosedAlsoWhereAStickTouchesIt) {
    const Drawing d = drawn(
        {stroked(line({{0, 0}, {10, 0}, {10, 10}, {0.002, 0.001}})), stroked(line({{0, 0}, {-20, -5}}))});
    ASSERT_EQ(d.elements.size(), 2u);
    EXPECT_TRUE(line_of(d, 0).path.closed);
    EXPECT_FALSE(line_of(d, 1).path.closed);
    expect_sound(line_of(d, 0).path);
}

TEST(Joining, OtherPinsAndOtherLayersAreOtherLines) {
    Robot robot = beachbot();
    robot.fill_wide_strokes = false;
    svg::Shape one = stroked(line({{0, 0}, {10, 0}}), 1), two = stroked(line({{10, 0}, {20, 5}}), 0.2);
    const auto lines = [&] { return drawn({one, two}, metre_a_unit(), robot).elements.size(); };
    EXPECT_EQ(lines(), 1u);
    two.stroke_width = 3;
    EXPECT_EQ(lines(), 2u);
    two.stroke_width = 1;
    two.layer = "other";
    EXPECT_EQ(lines(), 2u);
}

TEST(Joining, ACurveOfManyPiecesShorterThanTheToleranceIsOneLine) {
    std::vector<svg::Shape> pieces;
    for (int i = 0; i < 500; ++i) pieces.push_back(stroked(line({unit(i * 0.001), unit((i + 1) * 0.001)})));
    const Drawing d = drawn(pieces);
    ASSERT_EQ(d.elements.size(), 1u);
    EXPECT_NEAR(length(d.elements[0]), 0.5, 1e-6);
    EXPECT_EQ(d.counts.joined, 499);
    EXPECT_EQ(d.counts.too_short, 0);
}

TEST(Joining, ArcsAndCurvesKeepTheirShapes) {
    const auto arc = [](Point center, double start, double sweep) {
        const auto at = [&](double t) { return center + 5 * unit(t); };
        return Path{at(start), {ArcSegment{center, {5, 0}, {0, 5}, start, sweep, at(start + sweep)}}, false};
    };
    const Path curve{{5, 0.002}, {CubicSegment{{5, 3}, {9, 3}, {9, 0}}}, false};
    for (const auto& [first, second] :
         {std::pair{arc({0, 0}, pi, -pi), curve}, std::pair{curve, arc({14.002, 0}, pi, -pi)},
          std::pair{arc({0, 0}, pi, -pi), arc({10.002, 0}, pi, -pi)}}) {
        const Drawing apart = drawn({stroked(first)}), other = drawn({stroked(second)}),
                      d = drawn({stroked(first), stroked(second)});
        ASSERT_EQ(d.elements.size(), 1u);
        EXPECT_NEAR(length(d.elements[0]), length(apart.elements[0]) + length(other.elements[0]), 0.01);
        expect_sound(line_of(d, 0).path);
    }
}

TEST(Duplicates, TheSameLineAgainInEitherSenseIsDropped) {
    const Path bent = line({{0, 0}, {10, 0}, {10, 10}});
    const Path nearly = line({{0.002, 0}, {5, 0.001}, {10, 0}, {10, 10.001}});
    const Drawing d = drawn({stroked(bent), stroked(bent), stroked(reversed(bent)), stroked(nearly),
                             stroked(line({{0.1, 0}, {10, 0}, {10, 9.9}}))});
    EXPECT_EQ(ids(d), (Ids{"a", "e"}));
    EXPECT_EQ(d.counts.duplicates, 3);
    EXPECT_EQ(d.counts.joined, 0);
}

TEST(Duplicates, TheWiderRakeStays) {
    svg::Shape narrow = stroked(line({{0, 0}, {90, 0}}), 1), wide = stroked(line({{0, 0}, {90, 0}}), 3);
    const Drawing d = drawn({narrow, wide}, {});
    ASSERT_EQ(ids(d), Ids{"a"});
    EXPECT_EQ(line_of(d, 0).pins, 3);
}

TEST(Duplicates, AClosedLineMayStartElsewhere) {
    const Path ring = square({0, 0}, 10), again = path_through({{10, 10}, {10, 0}, {0, 0}, {0, 10}}, true);
    const Drawing d = drawn({stroked(ring), stroked(again), stroked(circle({50, 50}, 9)),
                             stroked(reversed(circle({50, 50}, 9)))});
    EXPECT_EQ(ids(d), (Ids{"a", "c"}));
    EXPECT_EQ(d.counts.duplicates, 2);
}

TEST(Duplicates, PiecesThatJoinToAnExistingLineAreFoundToo) {
    const Drawing d = drawn({stroked(square({0, 0}, 10)), stroked(line({{0, 0}, {10, 0}, {10, 10}})),
                             stroked(line({{0, 0}, {0, 10}, {10, 10}}))});
    EXPECT_EQ(ids(d), Ids{"a"});
    EXPECT_EQ(d.counts.duplicates, 1);
}

TEST(Duplicates, RegionsAreTheSameOnlyWithTheSameHoles) {
    const auto ring = filled({square({0, 0}, 30), reversed(square({10, 10}, 10))}),
               disc = filled({square({0, 0}, 30)});
    DrawingOptions each = metre_a_unit();
    each.occlusion = false;
    EXPECT_EQ(ids(drawn({ring, disc, ring, disc}, each)), (Ids{"a", "b"}));
}

TEST(Duplicates, ALineOnARegionsOutlineIsNoDuplicate) {
    EXPECT_EQ(drawn({filled({square({0, 0}, 30)}), stroked(square({0, 0}, 30), 0.3)}).elements.size(), 2u);
}

}  // namespace
}  // namespace strandline
