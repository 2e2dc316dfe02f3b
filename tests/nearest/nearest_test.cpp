#include "math/nearest/nearest.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace strandline {
namespace {

Point any_point() { return {*rc::gen::inRange(-1000, 1000) / 100.0, *rc::gen::inRange(-1000, 1000) / 100.0}; }

TEST(Nearest, TheTreeAgreesWithAllSegmentsAskedOneByOne) {
    EXPECT_TRUE(rc::check("distance", [] {
        Polyline line;
        for (int n = *rc::gen::inRange(2, 60); n > 0; --n) line.push_back(any_point());
        const SegmentTree tree(segments_of(line, false));
        for (int k = 0; k < 10; ++k) {
            const Point p = any_point();
            if (std::abs(tree.distance(p) - distance_to(line, p)) > 1e-12) return false;
        }
        return true;
    }));
}

TEST(Nearest, NoSegmentsAreInfinitelyFar) { EXPECT_TRUE(std::isinf(SegmentTree({}).distance({0, 0}))); }

TEST(Nearest, BandsHoldWhatTheRegionHolds) {
    EXPECT_TRUE(rc::check("contains", [] {
        Region region;
        for (int n = *rc::gen::inRange(3, 80); n > 0; --n) region.outer.push_back(any_point());
        const BandedRegion banded(region);
        for (int k = 0; k < 20; ++k) {
            const Point p = any_point();
            if (banded.contains(p) != contains(region.outer, p) &&
                distance_to_outline(region.outer, p) > 1e-9)
                return false;
        }
        return true;
    }));
}

}  // namespace
}  // namespace strandline
