#pragma once
// Distances to many segments and containment in large regions, asked for thousands of points.
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "math/geometry/geometry.hpp"

namespace strandline {

/// Segments under a binary tree of boxes in the order given; a path's neighbours share a box, so the tree is
/// tight.
class SegmentTree {
  public:
    using Segments = std::vector<std::pair<Point, Point>>;
    explicit SegmentTree(Segments segments);
    /// Distance to the nearest segment; infinity when there is none. O(log n) typical.
    double distance(Point p) const;

  private:
    void search(std::size_t node, std::size_t first, std::size_t last, Point p, double& best_squared) const;
    Segments segments_;
    std::vector<Box> boxes_;          // heap order: children of k are 2 k + 1 and 2 k + 2
    mutable std::size_t latest_ = 0;  // where the last answer was: the next point is mostly near it
};

SegmentTree::Segments segments_of(const Polyline& line, bool closed);

/// Segments by the squares of a grid that they come through: all of them that are near a place, however they
/// lie in the order given. O(length / square) to make.
class SegmentSquares {
  public:
    /// `square`: metres, above 0; about the distance that is asked for.
    SegmentSquares(SegmentTree::Segments segments, double square);
    struct Near {
        std::size_t number = 0;  ///< of the segment
        Point at;                ///< nearest place on it
        double distance = 0;
    };
    /// Segments no farther than `reach` from p, each once, by number. O(segments in (1 + 2 reach / square)^2
    /// squares).
    std::vector<Near> near(Point p, double reach) const;

  private:
    int place(double coordinate) const;
    static std::uint64_t key(int i, int j);
    SegmentTree::Segments segments_;
    double square_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> squares_;
};

/// Outlines cut into horizontal bands, so that a point looks at the edges of its band only.
class BandedRegion {
  public:
    explicit BandedRegion(const Region& region);
    bool contains(Point p) const;

  private:
    Box box_;
    std::vector<SegmentTree::Segments> bands_;
};

}  // namespace strandline
