#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

using shapes::square;

TEST(RegionOffset, AnInsetSquareKeepsItsCorners) {
    const Regions small = inset({{square({0, 0}, 4), {}}}, 1);
    ASSERT_EQ(small.size(), 1u);
    EXPECT_NEAR(area(small), 4, 1e-7);
    EXPECT_EQ(small[0].outer.size(), 4u);
}

TEST(RegionOffset, AGrownSquareHasRoundCorners) {
    EXPECT_NEAR(area(inset({{square({0, 0}, 4), {}}}, -1, 1e-4)), 16 + 16 + pi, 1e-3);
}

TEST(RegionOffset, AHoleGrowsRoundWhenTheAreaShrinks) {
    const Regions ring{{square({0, 0}, 9), {reversed(square({4, 4}, 1))}}};
    const Regions small = inset(ring, 1, 1e-4);
    ASSERT_EQ(small.size(), 1u);
    EXPECT_NEAR(area(small), 49 - (1 + 4 + pi), 1e-3);
}

TEST(RegionOffset, AnInsetNeverGrowsAndKeepsItsDistance) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Regions whole = shapes::random_regions(seed);
        double last = area(whole);
        for (double by = 0.1; by < 2; by += 0.2) {
            const Regions small = inset(whole, by);
            EXPECT_LE(area(small), last + 1e-6) << seed;
            EXPECT_NEAR(area(subtracted(small, whole)), 0, 1e-6) << seed;
            last = area(small);
            for (const Region& part : small)
                for (Point p : part.outer) {
                    double nearest = 1e9;
                    for (const Region& region : whole) {
                        nearest = std::min(nearest, distance_to_outline(region.outer, p));
                        for (const Polygon& hole : region.holes)
                            nearest = std::min(nearest, distance_to_outline(hole, p));
                    }
                    EXPECT_GE(nearest, by * (1 - 1.0 / 500) - 1e-6) << seed;
                }
        }
        EXPECT_TRUE(inset(whole, 50).empty());
    }
}

TEST(RegionOffset, SimplifyingMovesTheOutlineByAtMostItsTolerance) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Regions whole = inset(shapes::random_regions(seed), 0.2, 1e-3);
        for (double tolerance : {0.001, 0.02, 0.1}) {
            const Regions plain = simplified(whole, tolerance), wide = inset(whole, -1.01 * tolerance);
            EXPECT_LT(area(subtracted(inset(plain, 1.01 * tolerance), whole)), 1e-6) << seed;
            for (const Region& part : plain)
                for (Point p : part.outer) EXPECT_TRUE(contains(wide, p)) << seed;
        }
    }
}

TEST(RegionOffset, SimplifyingDropsSpecks) {
    EXPECT_TRUE(simplified({{square({0, 0}, 0.05), {}}}, 0.1).empty());
    const Polygon dotted{{0, 0}, {1, 0.001}, {2, 0}, {2, 2}, {0, 2}};
    const Regions plain = simplified({{dotted, {}}}, 0.01);
    ASSERT_EQ(plain.size(), 1u);
    EXPECT_EQ(plain[0].outer.size(), 4u);
}

TEST(RegionOffset, APenSweepsItsLine) {
    const Polyline line{{0, 0}, {3, 0}};
    EXPECT_NEAR(area(swept({line}, false, 0.5, Cap::flat)), 3, 1e-6);
    EXPECT_NEAR(area(swept({line}, false, 0.5, Cap::square)), 4, 1e-6);
    EXPECT_NEAR(area(swept({line}, false, 0.5, Cap::round)), 3 + pi / 4, 0.01);
    EXPECT_NEAR(area(swept({line}, false, 0.5)), 3 + pi / 4, 0.01);
}

TEST(RegionOffset, AClosedLineSweepsARing) {
    const Regions ring = swept({square({0, 0}, 4)}, true, 0.5);
    ASSERT_EQ(ring.size(), 1u);
    ASSERT_EQ(ring[0].holes.size(), 1u);
    EXPECT_NEAR(area(ring), 25 - (1 - pi / 4) - 9, 0.01);
}

TEST(RegionOffset, LinesThatOverlapAreSweptOnce) {
    EXPECT_NEAR(area(swept({{{0, 0}, {3, 0}}, {{1, 0}, {4, 0}}}, false, 0.5, Cap::flat)), 4, 1e-6);
    EXPECT_TRUE(swept({}, false, 1).empty());
    EXPECT_TRUE(swept({{{0, 0}, {1, 0}}}, false, 0).empty());
}

}  // namespace
}  // namespace strandline
