#include "math/geometry/geometry.hpp"

#include <gtest/gtest.h>

namespace strandline {
namespace {

const Polygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Geometry, AreaIsPositiveCounterClockwise) {
    EXPECT_DOUBLE_EQ(signed_area(unit_square), 1);
    EXPECT_DOUBLE_EQ(signed_area(reversed(unit_square)), -1);
}

TEST(Geometry, AHoleIsNotInsideItsRegion) {
    const Region ring{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
    EXPECT_TRUE(contains(ring, {0.5, 0.5}));
    EXPECT_FALSE(contains(ring, {2, 2}));
    EXPECT_DOUBLE_EQ(area(ring), 12);
}

TEST(Geometry, AnglesWrapIntoHalfOpenTurn) {
    EXPECT_DOUBLE_EQ(wrap_angle(3 * pi), pi);
    EXPECT_DOUBLE_EQ(wrap_angle(-pi), pi);
    EXPECT_NEAR(wrap_angle(2 * pi + 0.25), 0.25, 1e-15);
}

TEST(Geometry, CrossingSegmentsMeetInOnePoint) {
    const auto hit = crossing({0, 0}, {2, 2}, {0, 2}, {2, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->at, (Point{1, 1}));
    EXPECT_FALSE(crossing({0, 0}, {1, 0}, {0, 1}, {1, 1}));
}

TEST(Geometry, ComposedMapsApplyInnerFirst) {
    const Affine turn{0, 1, -1, 0, 0, 0}, shift{1, 0, 0, 1, 5, 0};
    EXPECT_EQ(apply(composed(turn, shift), {1, 0}), apply(turn, apply(shift, {1, 0})));
}

TEST(Geometry, SliceKeepsCornersBetweenItsEnds) {
    const Polyline bent{{0, 0}, {2, 0}, {2, 2}};
    EXPECT_EQ(slice(bent, 1, 3), (Polyline{{1, 0}, {2, 0}, {2, 1}}));
}

}  // namespace
}  // namespace strandline
