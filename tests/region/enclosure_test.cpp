#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

using shapes::square;

TEST(RegionEnclosure, ALineIsPartedInOrder) {
    const Regions ring{{square({0, 0}, 9), {reversed(square({3, 3}, 3))}}};
    const LineParts parts = parted({{-1, 4}, {5, 4}, {10, 4}}, ring);
    ASSERT_EQ(parts.inside.size(), 2u);
    ASSERT_EQ(parts.outside.size(), 3u);
    EXPECT_EQ(parts.inside[0].front(), (Point{0, 4}));
    EXPECT_EQ(parts.inside[0].back(), (Point{3, 4}));
    EXPECT_EQ(parts.inside[1].back(), (Point{9, 4}));
    EXPECT_EQ(parts.outside[1].front(), (Point{3, 4}));
    EXPECT_EQ(parts.outside[1].size(), 3u);  // the corner at (5, 4) stays
    EXPECT_EQ(parts.outside[2].back(), (Point{10, 4}));
}

TEST(RegionEnclosure, PartsOfALineAddUp) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::mt19937_64 random(seed);
        const Regions regions = shapes::random_regions(seed);
        const Polyline line = shapes::blob(random, centroid(regions[0].outer), 8, 40);
        const LineParts parts = parted(line, regions);
        double sum = 0;
        for (const Polyline& part : parts.inside) sum += length(part);
        for (const Polyline& part : parts.outside) sum += length(part);
        EXPECT_NEAR(sum, length(line), 1e-9);
        for (const Polyline& part : parts.inside)
            EXPECT_TRUE(contains(regions, point_at(part, length(part) / 2)) || length(part) < 1e-9);
    }
}

TEST(RegionEnclosure, TheSmallestEnclosingOutlineIsTheParent) {
    const std::vector<Polygon> outlines{square({3, 3}, 1), square({0, 0}, 9), square({2, 2}, 4),
                                        square({20, 0}, 1)};
    EXPECT_EQ(nesting(outlines), (std::vector<int>{2, -1, 1, -1}));
}

TEST(RegionEnclosure, TouchingOutlinesEnclose) {
    EXPECT_EQ(nesting({square({0, 0}, 4), square({0, 0}, 2), square({3, 1}, 1)}),
              (std::vector<int>{-1, 0, 0}));
}

TEST(RegionEnclosure, NeighboursThatTouchFromOutsideDoNot) {
    EXPECT_EQ(nesting({square({0, 0}, 4), square({4, 0}, 2)}), (std::vector<int>{-1, -1}));
}

TEST(RegionEnclosure, OfEqualOutlinesTheEarlierEnclosesTheLater) {
    const Polygon one = square({0, 0}, 2), same{{2, 2}, {0, 2}, {0, 1}, {0, 0}, {2, 0}};
    EXPECT_EQ(nesting({one, same, one}), (std::vector<int>{-1, 0, 1}));
    EXPECT_EQ(nesting({one, square({0.5, 0.5}, 1), reversed(one)}), (std::vector<int>{-1, 2, 0}));
}

TEST(RegionEnclosure, CrossingOutlinesDoNotEnclose) {
    EXPECT_EQ(nesting({square({0, 0}, 4), square({2, 2}, 3)}), (std::vector<int>{-1, -1}));
    // All corners inside a U, one edge across its bay.
    const Polygon u{{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 2}, {2, 2}, {2, 6}, {0, 6}};
    EXPECT_EQ(nesting({u, {{1, 5}, {1, 1}, {5, 5}}}), (std::vector<int>{-1, -1}));
    EXPECT_EQ(nesting({u, {{2.5, 3}, {3.5, 3}, {3, 4}}}), (std::vector<int>{-1, -1}));
}

TEST(RegionEnclosure, NestingIsTheSameTurnedAndMirrored) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<Polygon> outlines;
        for (int i = 0; i < 25; ++i)
            outlines.push_back(shapes::blob(random,
                                            {shapes::uniform(random, 0, 6), shapes::uniform(random, 0, 6)},
                                            shapes::uniform(random, 0.1, 5), 9));
        const auto parents = nesting(outlines);
        for (const Affine& map : {shapes::turned, shapes::mirrored}) {
            auto other = outlines;
            for (Polygon& outline : other) outline = shapes::moved(outline, map);
            EXPECT_EQ(nesting(other), parents) << seed;
        }
    }
}

}  // namespace
}  // namespace strandline
