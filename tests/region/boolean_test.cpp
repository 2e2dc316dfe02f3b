#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

using shapes::square;

TEST(RegionBoolean, ABowTieIsTwoTriangles) {
    const Regions parts = resolved({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, FillRule::even_odd);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(area(parts), 2, 1e-8);
    for (const Region& part : parts) EXPECT_GT(signed_area(part.outer), 0);
}

TEST(RegionBoolean, FillRulesDifferWhereOutlinesOverlap) {
    const std::vector<Polygon> both{square({0, 0}, 4), square({1, 1}, 2)};
    EXPECT_NEAR(area(resolved(both, FillRule::nonzero)), 16, 1e-8);
    const Regions ring = resolved(both, FillRule::even_odd);
    ASSERT_EQ(ring.size(), 1u);
    ASSERT_EQ(ring[0].holes.size(), 1u);
    EXPECT_LT(signed_area(ring[0].holes[0]), 0);
    EXPECT_NEAR(area(ring), 12, 1e-8);
}

TEST(RegionBoolean, AnIslandInAHoleIsARegionOfItsOwn) {
    const Regions parts =
        resolved({square({0, 0}, 9), square({1, 1}, 7), square({3, 3}, 2)}, FillRule::even_odd);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(area(parts), 81 - 49 + 4, 1e-7);
}

TEST(RegionBoolean, CornersThatAreShortInBinaryComeBackExactly) {
    const Polygon corners{{0.5, -0.25}, {3, 0}, {2.75, 8}};
    const Regions same = resolved({corners}, FillRule::nonzero);
    ASSERT_EQ(same.size(), 1u);
    for (Point p : corners) EXPECT_EQ(distance_to(Polyline(same[0].outer), p), 0);
}

TEST(RegionBoolean, ThePointInsideIsInsideAlsoBetweenHolesAndInABay) {
    const auto box = [](double x, double y, double w, double h) {
        return Polygon{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    };
    // a comb: the level line through the middle meets both teeth and the bay between
    const Region comb{{{0, 0}, {10, 0}, {10, 10}, {7, 10}, {7, 1}, {2, 1}, {2, 10}, {0, 10}}, {}};
    EXPECT_EQ(point_inside(comb), (Point{8.5, 5}));
    const Region holed{box(0, 0, 10, 10), {reversed(box(1, 1, 5, 8))}};
    EXPECT_EQ(point_inside(holed), (Point{8, 5}));
}

TEST(RegionBoolean, NothingComesOfNothing) {
    EXPECT_TRUE(resolved({}, FillRule::nonzero).empty());
    EXPECT_TRUE(resolved({{{1, 1}, {2, 2}}, {{3, 3}, {3, 3}, {3, 3}}}, FillRule::even_odd).empty());
    EXPECT_TRUE(resolved({{{0, 0}, {std::nan(""), 1}, {1, 1}}}, FillRule::nonzero).empty());
    EXPECT_TRUE(united(Regions{}, Regions{}).empty());
    EXPECT_TRUE(inset({}, 1).empty());
}

TEST(RegionBoolean, AreasFollowInclusionAndExclusion) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Regions a = shapes::random_regions(seed), b = shapes::random_regions(seed + 1000);
        const double both = area(intersected(a, b));
        EXPECT_NEAR(area(united(a, b)), area(a) + area(b) - both, 1e-5) << seed;
        EXPECT_NEAR(area(subtracted(a, b)), area(a) - both, 1e-5) << seed;
    }
}

TEST(RegionBoolean, TurningAndMirroringChangesNoArea) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Regions a = shapes::random_regions(seed), b = shapes::random_regions(seed + 1000);
        for (const Affine& map : {shapes::turned, shapes::mirrored}) {
            const Regions c = shapes::moved(a, map), d = shapes::moved(b, map);
            EXPECT_NEAR(area(subtracted(a, b)), area(subtracted(c, d)), 1e-5) << seed;
            EXPECT_NEAR(area(inset(a, 0.3)), area(inset(c, 0.3)), 1e-2) << seed;  // arcs begin elsewhere
        }
    }
}

TEST(RegionBoolean, AreasOfCutsAddUpAndLieOnTheirSides) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Regions whole = shapes::random_regions(seed);
        const Point a = between(bounds(whole).low, bounds(whole).high, 0.4), b = a + unit(double(seed));
        const Halves halves = cut(whole, a, b);
        EXPECT_NEAR(area(halves.left) + area(halves.right), area(whole), 1e-6) << seed;
        for (const Region& part : halves.left)
            for (Point p : part.outer) EXPECT_GE(cross(b - a, p - a), -1e-6) << seed;
        for (const Region& part : halves.right)
            for (Point p : part.outer) EXPECT_LE(cross(b - a, p - a), 1e-6) << seed;
    }
}

TEST(RegionBoolean, ALineThatMissesCutsNothingOff) {
    const Regions whole{{square({0, 0}, 2), {}}};
    EXPECT_NEAR(area(cut(whole, {5, 0}, {5, 1}).left), 4, 1e-8);
    EXPECT_NEAR(area(cut(whole, {5, 1}, {5, 0}).right), 4, 1e-8);
    EXPECT_NEAR(area(cut(whole, {1e9, 0}, {1e9, 1}).left), 4, 1e-8);
}

TEST(Boolean, ResolvingWithinAnAreaIsResolvingAndIntersecting) {
    const Polygon star{{0, 0}, {4, 10}, {8, 0}, {-1, 6}, {9, 6}};
    const Regions window{{{{0, 0}, {5, 0}, {5, 5}, {0, 5}}, {}}};
    for (const auto rule : {FillRule::nonzero, FillRule::even_odd}) {
        const auto both = intersected(resolved({star}, rule), window);
        EXPECT_NEAR(area(resolved_within({star}, rule, window)), area(both), 1e-6);
        EXPECT_GT(area(both), 1);
    }
    EXPECT_TRUE(resolved_within({star}, FillRule::nonzero, {}).empty());
}

}  // namespace
}  // namespace strandline
