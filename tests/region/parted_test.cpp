#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

using shapes::square;

TEST(RegionParted, ALineIsPartedInOrder) {
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

TEST(RegionParted, PartsOfALineAddUp) {
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

}  // namespace
}  // namespace strandline
