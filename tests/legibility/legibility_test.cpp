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
        for (const double corner : {8.0, 20.0, 40.0, 60.0, 90.0, 120.0}) {
            const double half = corner / 2 * pi / 180;
            const Polygon kite{Point{}, unit(turn - half), 2 * std::cos(half) * unit(turn),
                               unit(turn + half)};
            EXPECT_TRUE(report(areas({{kite, {}}}), robot).details.empty()) << turn << " " << corner;
        }
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

TEST(Legibility, OnTheCanvasItAsksForNothingIsLost) {
    const Region bar{box({0, 0}, {1, 0.013}), {}};
    const double factor = report(areas({bar}), robot).factor;
    Region larger = bar;
    for (Point& p : larger.outer) p = factor * (1 + 1e-9) * p;
    EXPECT_TRUE(report(areas({larger}), robot).details.empty());
}

}  // namespace
}  // namespace strandline::legibility
