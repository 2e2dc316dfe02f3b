#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

TEST(RegionSkeleton, InsetsOfASquareAreSquares) {
    const auto levels = skeleton_insets({shapes::square({0, 0}, 6), {}}, {0.5, 1.5, 2.5, 3.5});
    ASSERT_TRUE(levels);
    ASSERT_EQ(levels->size(), 4u);
    EXPECT_TRUE(levels->back().empty());
    for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ((*levels)[k].size(), 1u);
        EXPECT_EQ((*levels)[k][0].outer.size(), 4u);
        EXPECT_NEAR(area((*levels)[k]), std::pow(5.0 - 2.0 * static_cast<double>(k), 2), 1e-6);
    }
}

TEST(RegionSkeleton, AReflexCornerRunsOutToAPointWhereTheEuclideanInsetIsRound) {
    const Region letter{{{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 6}, {0, 6}}, {}};
    const auto levels = skeleton_insets(letter, {0.5});
    ASSERT_TRUE(levels);
    const Region& mitred = levels->front().at(0);
    EXPECT_EQ(mitred.outer.size(), 6u);
    const Regions round = inset({letter}, 0.5);
    EXPECT_NEAR(area(round) - area(mitred), (1 - pi / 4) * 0.25, 1e-3);
    EXPECT_LT(area(subtracted({mitred}, round)), 1e-6);  // mitred lies in round
}

TEST(RegionSkeleton, AHoleGrowsAsTheAreaShrinks) {
    const Region ring{shapes::square({0, 0}, 8), {reversed(shapes::square({3, 3}, 2))}};
    const auto levels = skeleton_insets(ring, {0.5, 1});
    ASSERT_TRUE(levels);
    ASSERT_EQ(levels->front().at(0).holes.size(), 1u);
    EXPECT_NEAR(area(levels->front()), 49 - 9, 1e-6);
    EXPECT_NEAR(area(levels->at(1)), 36 - 16, 1e-6);
}

TEST(RegionSkeleton, WhatHasNoneSaysWhy) {
    Polygon circle;
    for (int i = 0; i < 1200; ++i) circle.push_back(unit(2 * pi * i / 1200));
    const auto many = skeleton_insets({circle, {}}, {0.1});
    ASSERT_FALSE(many);
    EXPECT_NE(many.error().reason.find("1200 corners"), std::string::npos);
    const auto crossed = skeleton_insets({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, {0.1});
    ASSERT_FALSE(crossed);
    EXPECT_NE(crossed.error().reason.find("degenerate"), std::string::npos);
    EXPECT_FALSE(skeleton_insets({shapes::square({0, 0}, 1), {}}, {0}));
}

}  // namespace
}  // namespace strandline
