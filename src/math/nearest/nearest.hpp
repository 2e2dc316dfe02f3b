#pragma once
// Distances to many segments and containment in large regions, asked for thousands of points.
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
