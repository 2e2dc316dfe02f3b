#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

using shapes::square;

double sum(const std::vector<Polygon>& parts) {
    double all = 0;
    for (const Polygon& part : parts) all += area(part);
    return all;
}

int pieces_of_line(const Polygon& part, Point through, double direction) {
    const Polyline line{through - 100 * unit(direction), through + 100 * unit(direction)};
    return static_cast<int>(parted(line, {{part, {}}}).inside.size());
}

TEST(RegionParts, AConvexAreaIsOneMonotonePart) {
    for (double direction : {0.0, 0.3, 1.5707963267948966, 2.9})
        EXPECT_EQ(monotone_parts({square({5, 5}, 3), {}}, direction).size(), 1u) << direction;
}

TEST(RegionParts, ASquareRingIsFourMonotoneParts) {
    const Region ring{square({0, 0}, 9), {reversed(square({3, 3}, 3))}};
    for (double direction : {0.0, pi / 2, 0.7}) {
        const auto parts = monotone_parts(ring, direction);
        EXPECT_EQ(parts.size(), 4u) << direction;
        EXPECT_NEAR(sum(parts), 72, 1e-6);
    }
}

TEST(RegionParts, ACombSplitsWhereItsTeethMeetTheBack) {
    const Polygon comb{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                       {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    EXPECT_EQ(monotone_parts({comb, {}}, 0).size(), 4u);       // back and three teeth
    EXPECT_EQ(monotone_parts({comb, {}}, pi / 2).size(), 1u);  // upright lines meet it once
}

TEST(RegionParts, MonotonePartsTileAndEveryLineMeetsThemOnce) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        std::mt19937_64 random(seed);
        for (const Region& region : shapes::random_regions(seed)) {
            const double direction = shapes::uniform(random, 0, pi);
            const auto parts = monotone_parts(region, direction);
            EXPECT_NEAR(sum(parts), area(region), 1e-5) << seed;
            EXPECT_NEAR(area(resolved(parts, FillRule::nonzero)), area(region), 1e-5) << seed;
            for (const Polygon& part : parts) {
                EXPECT_GT(signed_area(part), 0);
                const Box box = bounds(part);
                for (int i = 0; i < 7; ++i) {
                    const Point p{shapes::uniform(random, box.low.x, box.high.x),
                                  shapes::uniform(random, box.low.y, box.high.y)};
                    EXPECT_LE(pieces_of_line(part, p, direction), 1) << seed;
                }
            }
        }
    }
}

TEST(RegionParts, TurnedAreasWithTurnedLinesGiveTheSameParts) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        for (const Region& region : shapes::random_regions(seed)) {
            const Region other = shapes::moved({region}, shapes::turned)[0];
            const auto here = monotone_parts(region, 0.4),
                       there = monotone_parts(other, 0.4 + heading(apply_to_vector(shapes::turned, {1, 0})));
            ASSERT_EQ(here.size(), there.size()) << seed;
            for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(area(here[i]), area(there[i]), 1e-6);
        }
}

TEST(RegionParts, AnLIsTwoConvexParts) {
    const auto parts = convex_parts({{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, {}});
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->size(), 2u);
    EXPECT_NEAR(sum(*parts), 7, 1e-12);
}

TEST(RegionParts, ConvexPartsAreConvexAndTile) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        std::mt19937_64 random(seed);
        const Polygon blob = shapes::blob(random, {3, 4}, 5, 30);
        for (const Polygon& outline : {blob, reversed(blob), shapes::moved(blob, shapes::turned)}) {
            const auto parts = convex_parts({outline, {}});
            ASSERT_TRUE(parts) << seed;
            EXPECT_NEAR(sum(*parts), area(outline), 1e-9);
            for (const Polygon& part : *parts)
                for (std::size_t i = 0, n = part.size(); i < n; ++i)
                    EXPECT_GE(cross(part[(i + 1) % n] - part[i], part[(i + 2) % n] - part[i]), -1e-9);
        }
    }
}

TEST(RegionParts, WhatCannotBeCutIntoConvexPartsSaysWhy) {
    std::mt19937_64 random(1);
    const Region holed{square({0, 0}, 9), {reversed(square({3, 3}, 3))}};
    EXPECT_NE(convex_parts(holed).error().reason.find("1 holes"), std::string::npos);
    EXPECT_NE(convex_parts({shapes::blob(random, {}, 5, 121), {}}).error().reason.find("121 corners"),
              std::string::npos);
    EXPECT_FALSE(convex_parts({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}));
    EXPECT_FALSE(convex_parts({{{0, 0}, {1, 0}, {2, 0}}, {}}));
    const Polygon pinched{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}};
    EXPECT_FALSE(convex_parts({pinched, {}}));
    const Polygon slit{{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 4}, {5, 4},
                       {5, 3}, {4, 3}, {6, 3}, {6, 6}, {0, 6}};
    EXPECT_FALSE(convex_parts({slit, {}}));
}

TEST(RegionParts, CornersOnAStraightLineDoNotCountForConvexParts) {
    Polygon dotted;
    for (int i = 0; i < 100; ++i) dotted.push_back({i * 0.0625, 0});
    for (int i = 0; i < 100; ++i) dotted.push_back({6.25, i * 0.0625});
    dotted.push_back({0, 6.25});
    const auto parts = convex_parts({dotted, {}});
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->size(), 1u);
}

}  // namespace
}  // namespace strandline
