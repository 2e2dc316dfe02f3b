#include "result/legibility/legibility.hpp"

#include <gtest/gtest.h>

namespace strandline::legibility {
namespace {

Polygon box(Point low, Point high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }
Drawing areas(std::vector<Region> regions) {
    Drawing drawing;
    for (Region& region : regions) drawing.elements.push_back({"area", "", RegionElement{std::move(region)}});
    return drawing;
}
const Robot robot;  // a pin is 6 cm

TEST(Legibility, WhatIsWiderThanAPinIsNoDetail) {
    EXPECT_TRUE(report(areas({{box({0, 0}, {1, 1}), {}}}), robot).details.empty());
    EXPECT_TRUE(report(areas({{box({0, 0}, {1, 0.07}), {}}}), robot).details.empty());
    EXPECT_EQ(report(areas({{box({0, 0}, {1, 1}), {}}}), robot).factor, 1);
}

TEST(Legibility, ANarrowBarNeedsACanvasOnWhichItIsAPinWide) {
    const Report r = report(areas({{box({0, 0}, {1, 0.02}), {}}}), robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_EQ(r.details.front().kind, Detail::Kind::narrow);
    EXPECT_NEAR(r.details.front().width, 0.02, 1e-6);
    EXPECT_NEAR(r.factor, 3, 1e-3);
}

TEST(Legibility, ABridgeBetweenTwoSquaresIsOneDetailAtItsPlace) {
    const Polygon dumbbell{{0, 0},   {1, 0},   {1, 0.48},   {1.5, 0.48}, {1.5, 0}, {2.5, 0},
                           {2.5, 1}, {1.5, 1}, {1.5, 0.52}, {1, 0.52},   {1, 1},   {0, 1}};
    const Report r = report(areas({{dumbbell, {}}}), robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_NEAR(r.details.front().at.x, 1.25, 0.3);
    EXPECT_NEAR(r.details.front().at.y, 0.5, 0.01);
    EXPECT_NEAR(r.factor, 0.06 / 0.04, 0.01);
}

TEST(Legibility, CornersAreNoDetailsWhicheverWayTheyPoint) {
    for (const double turn : {0.0, 0.3, 1.1, 2.0})
        for (const double corner : {12.0, 20.0, 40.0, 60.0, 90.0, 120.0}) {
            const double half = corner / 2 * pi / 180;
            const Polygon kite{Point{}, unit(turn - half), 2 * std::cos(half) * unit(turn),
                               unit(turn + half)};
            EXPECT_TRUE(report(areas({{kite, {}}}), robot).details.empty()) << turn << " " << corner;
        }
}

TEST(Legibility, AHornThatIsLostForAThirdIsNamedByItsWidthThere) {
    // A triangle on a square: 80 cm long, 12 cm wide at its foot.
    const Polygon horned{{0, 0}, {1, 0}, {1, 0.44}, {1.8, 0.5}, {1, 0.56}, {1, 1}, {0, 1}};
    for (const double turn : {0.0, 0.7, 2.1}) {
        Polygon turned;
        for (Point p : horned) turned.push_back(p.x * unit(turn) + p.y * left_normal(unit(turn)));
        const Report r = report(areas({{turned, {}}}), robot);
        ASSERT_EQ(r.details.size(), 1u) << turn;
        EXPECT_EQ(r.details.front().kind, Detail::Kind::horn);
        EXPECT_LT(distance(r.details.front().at, turned[3]), 1e-6);
        EXPECT_NEAR(r.details.front().width, 0.04, 0.003);
        EXPECT_NEAR(r.factor, 1.5, 0.12);
    }
    // Twice as wide at its foot it shows for more than two thirds.
    const Polygon stout{{0, 0}, {1, 0}, {1, 0.38}, {1.8, 0.5}, {1, 0.62}, {1, 1}, {0, 1}};
    EXPECT_TRUE(report(areas({{stout, {}}}), robot).details.empty());
}

TEST(Legibility, ARoundedTipIsATipAndABluntEndIsNone) {
    Polygon rounded{{0, 0}, {1, 0}, {1, 0.44}};  // round the end of the horn, 1 cm across
    for (int k = -4; k <= 4; ++k) rounded.push_back(Point{1.7, 0.5} + 0.01 * unit(k * pi / 8));
    rounded.insert(rounded.end(), {{1, 0.56}, {1, 1}, {0, 1}});
    const Report r = report(areas({{rounded, {}}}), robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_EQ(r.details.front().kind, Detail::Kind::horn);
    const Polygon blunt{{0, 0}, {1, 0}, {1, 0.44}, {2, 0.46}, {2, 0.54}, {1, 0.56}, {1, 1}, {0, 1}};
    EXPECT_TRUE(report(areas({{blunt, {}}}), robot).details.empty());
}

TEST(Legibility, AHoleThatNoPinLeavesOpenIsNamed) {
    const Region holed{box({0, 0}, {1, 1}), {reversed(box({0.5, 0.5}, {0.53, 0.6}))}};
    const Report r = report(areas({holed}), robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_EQ(r.details.front().kind, Detail::Kind::hole);
    EXPECT_NEAR(r.factor, 2, 1e-3);
}

TEST(Legibility, ASmallRingOfALineFillsUp) {
    Drawing drawing;
    drawing.elements.push_back({"ring", "", LineElement{path_through(box({0, 0}, {0.08, 0.08}), true), 1}});
    drawing.elements.push_back({"large", "", LineElement{path_through(box({0, 0}, {0.5, 0.5}), true), 1}});
    const Report r = report(drawing, robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_EQ(r.details.front().element, 0);
    EXPECT_NEAR(r.factor, 0.12 / 0.08, 1e-3);
}

Drawing lines(const std::vector<std::pair<Polyline, int>>& all) {
    Drawing drawing;
    for (const auto& [points, pins] : all)
        drawing.elements.push_back({"line", "", LineElement{path_through(points, false), pins}});
    return drawing;
}

TEST(Legibility, TwoLinesSideBySideNeedTheirGroovesAndAPinBetween) {
    const Drawing near = lines({{{{0, 0}, {3, 0}}, 1}, {{{1, 0.15}, {2, 0.15}}, 3}});
    const Report r = report(near, robot);
    ASSERT_EQ(r.details.size(), 1u);
    const Detail& gap = r.details.front();
    EXPECT_EQ(gap.kind, Detail::Kind::gap);
    EXPECT_EQ(gap.element, 0);
    EXPECT_EQ(gap.other, 1);
    EXPECT_NEAR(gap.width, 0.15, 1e-9);
    EXPECT_NEAR(gap.needed, 0.03 + 0.09 + 0.06, 1e-9);
    EXPECT_NEAR(gap.at.y, 0.075, 1e-9);
    EXPECT_GT(gap.at.x, 0.9);
    EXPECT_LT(gap.at.x, 2.1);
    EXPECT_TRUE(report(lines({{{{0, 0}, {3, 0}}, 1}, {{{1, 0.19}, {2, 0.19}}, 3}}), robot).details.empty());
}

TEST(Legibility, AGapIsBetweenNeighboursOnly) {
    // Ten lines 4 cm apart: nine gaps, none from the first to the third.
    std::vector<std::pair<Polyline, int>> hatch;
    for (int k = 0; k < 10; ++k) hatch.push_back({{{0, 0.04 * k}, {3, 0.04 * k}}, 1});
    const Report r = report(lines(hatch), robot);
    EXPECT_EQ(r.details.size(), 9u);
    EXPECT_NEAR(r.factor, 3, 1e-6);
    EXPECT_TRUE(r.whole);
}

TEST(Legibility, LinesThatCrossTouchMeetOrLieOnEachOtherHaveNoGap) {
    for (const double turn : {0.12, 0.3, 0.7, pi / 2, 2.5}) {
        const Point aside = unit(turn);
        EXPECT_TRUE(
            report(lines({{{{-2, 0}, {2, 0}}, 1}, {{-2 * aside, 2 * aside}, 1}}), robot).details.empty())
            << turn;
        EXPECT_TRUE(report(lines({{{{-2, 0}, {0, 0}}, 1}, {{{0, 0}, 2 * aside}, 1}}), robot).details.empty())
            << turn;
    }
    EXPECT_TRUE(report(lines({{{{0, 0}, {2, 0}}, 1}, {{{1, 0}, {3, 0}}, 1}}), robot).details.empty());
    EXPECT_TRUE(report(lines({{{{0, 0}, {2, 0}}, 1}, {{{2.03, 0}, {3, 0}}, 1}}), robot).details.empty())
        << "a broken line is not closed by its width";
    // A line round an area is its border.
    Drawing bordered = areas({{box({0, 0}, {1, 1}), {}}});
    bordered.elements.push_back({"border", "", LineElement{path_through(box({0, 0}, {1, 1}), true), 1}});
    EXPECT_TRUE(report(bordered, robot).details.empty());
}

TEST(Legibility, LinesThatPartFromOnePlaceHaveAGapWhereTheyRunSideBySide) {
    const Report r =
        report(lines({{{{0, 0}, {3, 0}}, 1}, {{{0, 0}, {0.2, 0.08}, {2, 0.08}, {2.2, 1}}, 1}}), robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_NEAR(r.details.front().width, 0.08, 0.002);
}

TEST(Legibility, AreasHaveGapsUnlessOneCoversThem) {
    const Region left{box({0, 0}, {1, 1}), {}}, right{box({1.02, 0}, {2, 1}), {}};
    const Report r = report(areas({left, right}), robot);
    ASSERT_EQ(r.details.size(), 1u);
    EXPECT_NEAR(r.details.front().width, 0.02, 1e-6);
    EXPECT_NEAR(r.factor, 3, 1e-3);
    // Two lines on one area, 2 cm apart: between them is raked sand.
    Drawing covered = areas({{box({-1, -1}, {3, 2}), {}}, left, right});
    covered.elements[1].inside = covered.elements[2].inside = 0;
    EXPECT_TRUE(report(covered, robot).details.empty());
    // An island in the hole of another, round which 3 cm stay.
    Drawing ring = areas({{box({0, 0}, {2, 2}), {reversed(box({0.5, 0.5}, {1.5, 1.5}))}},
                          {box({0.53, 0.53}, {1.47, 1.47}), {}}});
    ring.elements[1].inside = 0;
    const Report island = report(ring, robot);
    ASSERT_EQ(island.details.size(), 1u);
    EXPECT_EQ(island.details.front().kind, Detail::Kind::gap);
    EXPECT_NEAR(island.factor, 2, 1e-3);
}

TEST(Legibility, WhereEverythingLiesOnEverythingTheSearchEnds) {
    std::vector<std::pair<Polyline, int>> heap;
    for (int k = 0; k < 400; ++k)
        heap.push_back({{{0, 1e-4 * k}, {0.3, 0.1}, {0, 0.2 - 1e-4 * k}, {0.3, 0.3}, {0, 0.4}}, 7});
    const Report r = report(lines(heap), robot);
    EXPECT_LT(r.details.size(), 1'000'000u);
    EXPECT_FALSE(report(lines(std::vector(3000, heap.front())), robot).whole);
}

TEST(Legibility, OnTheCanvasItAsksForNothingIsLost) {
    const Region bar{box({0, 0}, {1, 0.013}), {}};
    const double factor = report(areas({bar}), robot).factor;
    Region larger = bar;
    for (Point& p : larger.outer) p = factor * (1 + 1e-9) * p;
    EXPECT_TRUE(report(areas({larger}), robot).details.empty());
    const auto scaled = [](double by) {
        return lines({{{{0, 0}, {3 * by, 0}}, 1}, {{{by, 0.1 * by}, {2 * by, 0.08 * by}}, 3}});
    };
    const double wider = report(scaled(1), robot).factor;
    EXPECT_GT(wider, 2);
    EXPECT_TRUE(report(scaled(wider * 1.001), robot).details.empty());
    EXPECT_FALSE(report(scaled(wider * 0.99), robot).details.empty());
}

}  // namespace
}  // namespace strandline::legibility
