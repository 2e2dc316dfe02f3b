// Who encloses whom.
#include <gtest/gtest.h>

#include <random>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

using Insides = std::vector<int>;

Insides nested(std::vector<svg::Shape> shapes) {
    for (svg::Shape& s : shapes) s.stroke_width = 0.1;
    return insides(drawn(std::move(shapes)));
}

TEST(Enclosure, TheSmallestOutlineCounts) {
    EXPECT_EQ(
        nested({stroked(square({0, 0}, 90)), stroked(square({10, 10}, 50)), stroked(square({20, 20}, 10)),
                stroked(square({70, 70}, 10)), stroked(line({{22, 22}, {28, 28}}))}),
        (Insides{-1, 0, 1, 0, 2}));
    EXPECT_EQ(nested({stroked(line({{22, 22}, {28, 28}})), stroked(square({20, 20}, 10)),
                      stroked(square({0, 0}, 90))}),
              (Insides{1, 2, -1}));
}

TEST(Enclosure, OpenLinesEncloseNothing) {
    EXPECT_EQ(
        nested({stroked(line({{0, 0}, {90, 0}, {90, 90}, {0, 90}, {0, 1}})), stroked(square({20, 20}, 10))}),
        (Insides{-1, -1}));
}

TEST(Enclosure, WhatLiesInAHoleIsInsideItsRegionsOutline) {
    EXPECT_EQ(nested({filled({square({0, 0}, 90), reversed(square({20, 20}, 50))}),
                      filled({square({30, 30}, 20)}), stroked(square({35, 35}, 5))}),
              (Insides{-1, 0, 1}));
}

TEST(Enclosure, ABayIsNotInside) {
    // A U with a square and a line between its arms.
    const Path u =
        path_through({{0, 0}, {90, 0}, {90, 90}, {70, 90}, {70, 20}, {20, 20}, {20, 90}, {0, 90}}, true);
    EXPECT_EQ(nested({filled({u}), stroked(square({40, 40}, 10)), stroked(line({{30, 50}, {60, 50}})),
                      stroked(line({{5, 80}, {80, 80}}))}),
              (Insides{-1, -1, -1, -1}));
}

TEST(Enclosure, ALineThatEndsNearTheWallsOfABayIsNotInside) {
    const Path u =
        path_through({{0, 0}, {90, 0}, {90, 90}, {70, 90}, {70, 20}, {20, 20}, {20, 90}, {0, 90}}, true);
    for (const double gap : {0.0, 0.002, 0.1})
        EXPECT_EQ(nested({filled({u}), stroked(line({{20 + gap, 50}, {70 - gap, 60}}))}), (Insides{-1, -1}))
            << gap;
    for (const double gap : {0.002, 0.1})
        EXPECT_EQ(nested({filled({u}), stroked(line({{gap, 50}, {20 - gap, 60}}))}), (Insides{-1, 0}));
}

TEST(Enclosure, AnEdgeThatCrossesABayIsSeen) {
    const Path u =
        path_through({{0, 0}, {90, 0}, {90, 90}, {70, 90}, {70, 20}, {20, 20}, {20, 90}, {0, 90}}, true);
    // Every corner lies in the arms or the foot of the U.
    EXPECT_EQ(nested({filled({u}), stroked(path_through({{5, 80}, {85, 80}, {45, 5}}, true))}),
              (Insides{-1, -1}));
}

TEST(Enclosure, CrossingOutlinesDoNotEncloseEachOther) {
    EXPECT_EQ(
        nested({stroked(square({0, 0}, 50)), stroked(square({25, 25}, 50)), stroked(square({30, 30}, 10))}),
        (Insides{-1, -1, 1}));
}

TEST(Enclosure, AnOutlineThatTouchesFromInsideIsInside) {
    EXPECT_EQ(nested({stroked(square({0, 0}, 50)), stroked(square({0, 0}, 20)),
                      stroked(line({{0, 30}, {50, 30}})), stroked(line({{50, 5}, {50, 45}}))}),
              (Insides{-1, 0, 0, 0}));
    EXPECT_EQ(
        nested({stroked(circle({50, 50}, 30)), stroked(circle({60, 50}, 20)), stroked(circle({90, 50}, 10))}),
        (Insides{-1, 0, -1}));
}

TEST(Enclosure, OfEqualOutlinesTheEarlierEnclosesTheLater) {
    EXPECT_EQ(nested({filled({square({0, 0}, 50)}), stroked(square({0, 0}, 50))}), (Insides{-1, 0}));
    EXPECT_EQ(nested({stroked(reversed(square({0, 0}, 50))), filled({square({0, 0}, 50)}),
                      stroked(square({10, 10}, 5))}),
              (Insides{-1, 0, 1}));
}

TEST(Enclosure, TheLobesOfAnOutlineThatCrossesItselfEncloseToo) {
    const Path eight = path_through({{0, 0}, {40, 40}, {40, 0}, {0, 40}}, true);
    EXPECT_EQ(nested({stroked(eight), stroked(square({35, 18}, 4)), stroked(square({18, 35}, 4))}),
              (Insides{-1, 0, -1}));
    // The middle of a pentagram, which even-odd would call outside.
    std::vector<Point> star;
    for (int i = 0; i < 5; ++i) star.push_back(Point{50, 50} + 40 * unit(4 * pi * i / 5));
    EXPECT_EQ(nested({stroked(path_through(star, true)), stroked(square({49, 49}, 2))}), (Insides{-1, 0}));
}

TEST(Enclosure, RandomSquaresAsBruteForceSaysTurnedAndMirroredToo) {
    std::mt19937_64 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    struct Square {
        Point corner;
        double side;
    };
    for (int round = 0; round < 20; ++round) {
        std::vector<Square> squares;
        std::vector<svg::Shape> shapes;
        for (int i = 0; i < 60; ++i) {
            squares.push_back({{uniform(0, 90), uniform(0, 90)}, std::exp(uniform(-1, 4))});
            svg::Shape s = stroked(square(squares.back().corner, squares.back().side), 0.1);
            s.id = "s" + std::to_string(i);
            shapes.push_back(s);
        }
        const auto holds = [](const Square& a, const Square& b) {
            return a.corner.x < b.corner.x && a.corner.y < b.corner.y &&
                   a.corner.x + a.side > b.corner.x + b.side && a.corner.y + a.side > b.corner.y + b.side;
        };
        Insides expected;
        for (const Square& inner : squares) {
            int best = -1;
            for (int j = 0; j < 60; ++j)
                if (holds(squares[static_cast<std::size_t>(j)], inner) &&
                    (best < 0 || squares[static_cast<std::size_t>(j)].side <
                                     squares[static_cast<std::size_t>(best)].side))
                    best = j;
            expected.push_back(best);
        }
        DrawingOptions options = metre_a_unit();
        options.join_tolerance = 1e-6;
        options.rotate = uniform(0, 2 * pi);
        options.mirror = round % 2 == 1;
        EXPECT_EQ(insides(drawn(shapes, options)), expected) << "round " << round;
    }
}

}  // namespace
}  // namespace strandline
