#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

constexpr double near = 1e-9;

TEST(Contacts, OutlinesOfValidAreasHaveNone) {
    EXPECT_TRUE(contacts({shapes::square({0, 0}, 4), reversed(shapes::square({1, 1}, 1))}, near).empty());
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        for (const Region& region : shapes::random_regions(seed))
            EXPECT_TRUE(contacts({region.outer}, near).empty()) << seed;
}

TEST(Contacts, ABowTieCrossesItselfInOnePlaceAndAPentagramInFive) {
    for (const Affine& map : {Affine{}, shapes::turned, shapes::mirrored}) {
        const auto tie = contacts({shapes::moved(Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, map)}, near);
        ASSERT_EQ(tie.size(), 1u);
        EXPECT_LT(distance(tie[0].at, apply(map, {1, 1})), 1e-9);
    }
    Polygon star;
    for (int k = 0; k < 5; ++k) star.push_back(unit(4 * pi * k / 5));
    EXPECT_EQ(contacts({star}, near).size(), 5u);
}

TEST(Contacts, OutlinesThatRunBackOverThemselvesTouch) {
    EXPECT_FALSE(
        contacts({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {2, 4}, {0, 4}}}, near).empty());  // a slit
    EXPECT_FALSE(contacts({{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}}, near).empty());         // a whisker
}

TEST(Contacts, CornersOnEdgesAndSharedCornersTouch) {
    const Polygon square = shapes::square({0, 0}, 2);
    const auto corner = contacts({square, shapes::square({2, 2}, 1)}, near);
    ASSERT_EQ(corner.size(), 1u);
    EXPECT_EQ(corner[0], (Contact{0, 1, {2, 2}}));
    const auto on_edge = contacts({square, {{2, 1}, {3, 0.5}, {3, 1.5}}}, near);
    ASSERT_EQ(on_edge.size(), 1u);
    EXPECT_EQ(on_edge[0].at, (Point{2, 1}));
}

TEST(Contacts, AreCountedUpToTheMostOfAPair) {
    Polygon comb{{0, -1}};
    for (int k = 0; k < 30; ++k) {
        comb.push_back({k + 0.25, 1});
        comb.push_back({k + 0.75, -1});
    }
    comb.push_back({31, -5});
    comb.push_back({-1, -5});
    const Polygon bar{{-2, 0}, {40, 0}, {40, 0.1}, {-2, 0.1}};
    EXPECT_EQ(contacts({comb, bar}, near, 7).size(), 7u);
    EXPECT_GT(contacts({comb, bar}, near, 1000).size(), 60u);
}

}  // namespace
}  // namespace strandline
