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

TEST(Nearest, SquaresFindEverySegmentInReachOnceAndNoOther) {
    EXPECT_TRUE(rc::check("near", [] {
        SegmentTree::Segments segments;
        for (int n = *rc::gen::inRange(0, 40); n > 0; --n) segments.emplace_back(any_point(), any_point());
        const double square = *rc::gen::inRange(10, 500) / 100.0;
        const SegmentSquares squares(segments, square);
        for (int k = 0; k < 10; ++k) {
            const Point p = any_point();
            const double reach = *rc::gen::inRange(0, 800) / 100.0;
            const auto found = squares.near(p, reach);
            std::size_t next = 0;
            for (std::size_t n = 0; n < segments.size(); ++n) {
                const double d = distance_to_segment(p, segments[n].first, segments[n].second);
                const bool here = next < found.size() && found[next].number == n;
                if (here && (std::abs(found[next].distance - d) > 1e-12 ||
                             std::abs(distance(found[next].at, p) - d) > 1e-12))
                    return false;
                if (here != (d <= reach) && std::abs(d - reach) > 1e-9) return false;
                next += here;
            }
            if (next != found.size()) return false;
        }
        return true;
    }));
}

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
