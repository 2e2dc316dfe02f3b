#include "machine/ground/ground.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

namespace strandline {
namespace {

using Cells = std::set<std::pair<int, int>>;

Cells cells_in(const Ground& ground, const Polygon& polygon) {
    Cells cells;
    for_cells_in(ground, polygon,
                 [&](int i, int j) { EXPECT_TRUE(cells.emplace(i, j).second) << "called twice"; });
    return cells;
}

Point any_point() {
    return {*rc::gen::inRange(-3000, 3000) / 1000.0, *rc::gen::inRange(-3000, 3000) / 1000.0};
}

TEST(Ground, AnUntouchedCellIsNotFoundAndATouchedOneIs) {
    Ground ground(0.02);
    EXPECT_EQ(ground.find(3, 4), nullptr);
    ground.at(3, 4).passes = 2;
    ASSERT_NE(ground.find(3, 4), nullptr);
    EXPECT_EQ(ground.find(3, 4)->passes, 2);
    EXPECT_EQ(ground.find(3, 5)->first_raked, Cell::never);
    EXPECT_EQ(ground.tiles(), 1u);
}

TEST(Ground, TilesOnAllSidesOfTheOriginAreApart) {
    Ground ground(0.02);
    const std::vector<std::pair<int, int>> places{{0, 0},   {-1, 0}, {0, -1},   {-1, -1},
                                                  {63, 63}, {64, 0}, {-64, -65}};
    for (std::size_t n = 0; n < places.size(); ++n)
        ground.at(places[n].first, places[n].second).element = static_cast<std::int16_t>(n);
    for (std::size_t n = 0; n < places.size(); ++n) {
        ASSERT_NE(ground.find(places[n].first, places[n].second), nullptr);
        EXPECT_EQ(ground.find(places[n].first, places[n].second)->element, static_cast<int>(n));
    }
    EXPECT_EQ(ground.tiles(), 6u);
}

TEST(Ground, VisitRunsByRowThenColumnThroughEveryTile) {
    Ground ground(0.1);
    ground.at(-1, 70).passes = 1;
    ground.at(200, 70).passes = 2;
    ground.at(5, -9).passes = 3;
    std::vector<int> met;
    std::pair<int, int> before{-100000, -100000};
    std::size_t cells = 0;
    ground.visit([&](int i, int j, const Cell& cell) {
        EXPECT_LT(before, (std::pair{j, i}));
        before = {j, i};
        ++cells;
        if (cell.passes > 0) met.push_back(cell.passes);
    });
    EXPECT_EQ(cells, 3u * 64 * 64);
    EXPECT_EQ(met, (std::vector<int>{3, 1, 2}));
}

TEST(Ground, ABoxHoldsTheCellsWhoseCentresItHolds) {
    const Ground ground(0.02);
    EXPECT_EQ(cells_in(ground, {{0, 0}, {0.06, 0}, {0.06, 0.04}, {0, 0.04}}),
              (Cells{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}));
    EXPECT_EQ(cells_in(ground, {{-0.019, -0.019}, {-0.005, -0.019}, {-0.005, -0.005}, {-0.019, -0.005}}),
              (Cells{{-1, -1}}));
    EXPECT_TRUE(cells_in(ground, {{0.011, 0}, {0.019, 0}, {0.019, 1}, {0.011, 1}}).empty());
    EXPECT_TRUE(cells_in(ground, {{0, 0}, {1, 1}}).empty());
}

TEST(Ground, CellsInAnyTriangleAreThoseWhoseCentresAreInside) {
    EXPECT_TRUE(rc::check("scan lines agree with point-in-polygon", [] {
        const Ground ground(0.13);
        const Polygon triangle{any_point(), any_point(), any_point()};
        Cells expected;
        for (int i = -30; i < 30; ++i)
            for (int j = -30; j < 30; ++j) {
                if (distance_to_outline(triangle, ground.centre(i, j)) < 1e-9)
                    return true;  // either way is right
                if (contains(triangle, ground.centre(i, j))) expected.emplace(i, j);
            }
        return cells_in(ground, triangle) == expected;
    }));
}

TEST(Ground, TwoHalvesOfABoxShareNoCellAndMissNone) {
    EXPECT_TRUE(rc::check("a cut through cell centres too", [] {
        const Ground ground(0.1);
        const double x = *rc::gen::inRange(-10, 10) * 0.05, y = *rc::gen::inRange(-10, 10) * 0.05;
        const Cells whole = cells_in(ground, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
        Cells left = cells_in(ground, {{-1, -1}, {x, -1}, {y, 1}, {-1, 1}});
        const Cells right = cells_in(ground, {{x, -1}, {1, -1}, {1, 1}, {y, 1}});
        const std::size_t together = left.size() + right.size();
        left.insert(right.begin(), right.end());
        return together == whole.size() && left == whole;
    }));
}

Polygon swept(Point a0, Point b0, Point a1, Point b1) {
    const Bar bar = swept_bar(a0, b0, a1, b1);
    return {bar.outline().begin(), bar.outline().end()};
}

TEST(Ground, ASweptBarIsTheHullOfItsEnds) {
    const Polygon box = swept({0, 1}, {0, -1}, {0.5, 1}, {0.5, -1});
    EXPECT_EQ(box.size(), 4u);
    EXPECT_DOUBLE_EQ(signed_area(box), 1);
    // Turning about one end: a triangle.
    const Polygon fan = swept({0, 0}, {1, 0}, {0, 0}, {0, 1});
    EXPECT_EQ(fan.size(), 3u);
    EXPECT_DOUBLE_EQ(signed_area(fan), 0.5);
    // Along itself: nothing is swept.
    EXPECT_DOUBLE_EQ(area(swept({0, 0}, {1, 0}, {1, 0}, {2, 0})), 0);
}

TEST(Ground, ASweptBarIsCounterClockwiseAndHoldsItsFourEnds) {
    EXPECT_TRUE(rc::check("hull", [] {
        const Point a = any_point(), b = any_point(), c = any_point(), d = any_point();
        const Polygon hull = swept(a, b, c, d);
        if (signed_area(hull) < 0) return false;
        for (Point p : {a, b, c, d})
            for (std::size_t k = 0; k < hull.size(); ++k)
                if (cross(hull[(k + 1) % hull.size()] - hull[k], p - hull[k]) < -1e-9) return false;
        return true;
    }));
}

}  // namespace
}  // namespace strandline
