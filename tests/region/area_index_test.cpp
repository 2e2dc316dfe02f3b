#include <gtest/gtest.h>

#include "curve/random_poses.hpp"
#include "math/region/region.hpp"

namespace strandline {
namespace {

using testing::Dice;
using Cover = AreaIndex::Cover;

/// 10 x 10 with a hole from 4 to 6.
const Regions ring{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}}};
Path circle(Point center, double radius) {
    const Point east = center + Point{radius, 0}, west = center - Point{radius, 0};
    return {east,
            {ArcSegment{center, {radius, 0}, {0, radius}, 0, pi, west},
             ArcSegment{center, {radius, 0}, {0, radius}, pi, pi, east}},
            true};
}
double total(const std::vector<Path>& paths) {
    double sum = 0;
    for (const auto& path : paths) sum += length(path);
    return sum;
}

TEST(AreaIndex, ABoxIsInsideOutsideOrCrossed) {
    const AreaIndex index(ring);
    EXPECT_EQ(index.cover_of({{1, 1}, {3, 3}}), Cover::inside);
    EXPECT_EQ(index.cover_of({{4.5, 4.5}, {5, 5}}), Cover::outside);
    EXPECT_EQ(index.cover_of({{1, 1}, {7, 7}}), Cover::crossed);  // the hole is in it
    EXPECT_EQ(index.cover_of({{9, 9}, {11, 11}}), Cover::crossed);
    EXPECT_EQ(index.cover_of({{11, 1}, {12, 2}}), Cover::outside);
    EXPECT_EQ(AreaIndex({}).cover_of({{0, 0}, {1, 1}}), Cover::outside);
}

TEST(AreaIndex, KnowsTheSamePointsAsTheRegions) {
    Dice dice(4);
    std::vector<Polygon> outlines(3);
    for (auto& outline : outlines)
        for (int i = 0; i < 40; ++i) outline.push_back(dice.point(5));
    const Regions area = resolved(outlines, FillRule::even_odd);
    const AreaIndex index(area);
    int inside = 0;
    for (int i = 0; i < 5000; ++i) {
        const Point p = dice.point(6);
        ASSERT_EQ(index.contains(p), contains(area, p));
        inside += index.contains(p) ? 1 : 0;
    }
    EXPECT_GT(inside, 500);
}

TEST(AreaIndex, ALineIsCutExactlyAtTheOutline) {
    const auto parts = AreaIndex(ring).parted(path_through({{-2, 5}, {12, 5}}, false), 0.01);
    ASSERT_EQ(parts.inside.size(), 2u);
    ASSERT_EQ(parts.outside.size(), 3u);
    EXPECT_NEAR(parts.inside[0].start.x, 0, 1e-12);
    EXPECT_NEAR(end_of(parts.inside[0]).x, 4, 1e-12);
    EXPECT_NEAR(parts.inside[1].start.x, 6, 1e-12);
    EXPECT_NEAR(end_of(parts.inside[1]).x, 10, 1e-12);
}

TEST(AreaIndex, ACircleOverACornerLeavesThreeQuartersInOnePiece) {
    const auto parts = AreaIndex(ring).parted(circle({0, 0}, 3), 0.01);
    ASSERT_EQ(parts.inside.size(), 1u);
    ASSERT_EQ(parts.outside.size(), 1u);
    EXPECT_NEAR(length(parts.inside[0]), 1.5 * pi, 1e-9);
    EXPECT_NEAR(length(parts.outside[0]), 4.5 * pi, 1e-9);
    for (const auto& segment : parts.outside[0].segments)
        EXPECT_TRUE(std::holds_alternative<ArcSegment>(segment));
}

TEST(AreaIndex, WhatDoesNotCrossStaysWholeAndClosed) {
    const AreaIndex index(ring);
    const auto in = index.parted(circle({2, 2}, 1), 0.01), out = index.parted(circle({5, 5}, 0.5), 0.01);
    ASSERT_EQ(in.inside.size(), 1u);
    EXPECT_EQ(in.inside[0], circle({2, 2}, 1));
    EXPECT_TRUE(in.outside.empty());
    ASSERT_EQ(out.outside.size(), 1u);
    EXPECT_TRUE(out.outside[0].closed);
}

TEST(AreaIndex, PartsAddUpAndLieOnTheirSide) {
    Dice dice(9);
    for (int round = 0; round < 200; ++round) {
        std::vector<Polygon> outlines(2);
        for (auto& outline : outlines)
            for (int i = 0; i < 8; ++i) outline.push_back(dice.point(5));
        const AreaIndex index(resolved(outlines, FillRule::nonzero));
        Path path{dice.point(6), {}, false};
        for (int i = 0; i < 4; ++i)
            path.segments.emplace_back(CubicSegment{dice.point(6), dice.point(6), dice.point(6)});
        const auto parts = index.parted(path, 1e-4);
        EXPECT_NEAR(total(parts.inside) + total(parts.outside), length(path), 1e-6);
        for (const bool in : {true, false})
            for (const auto& piece : in ? parts.inside : parts.outside)
                if (length(piece) > 0.1) {
                    EXPECT_EQ(index.contains(point_at(piece, places_at(piece, {0.05})[0])), in);
                }
    }
}

}  // namespace
}  // namespace strandline
