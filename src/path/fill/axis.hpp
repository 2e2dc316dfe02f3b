#pragma once
// Private to the room: the middle lines of an area as paths.
#include <span>

#include "math/region/region.hpp"
#include "path/fill/fill.hpp"

namespace strandline::fill {

/// A middle line. At a junction of several the two that go on straightest are one path; others begin where
/// the discs of that one end.
struct AxisPath {
    Polyline line;               // closed: first point not repeated
    std::vector<double> radius;  // to the outline, at each point
    bool closed = false;
};
/// Longest first. Branches that only reach into corners are left out, and the ends drawn on to the outline.
/// An area about as long as wide gets one path along its longest edge. O(n log n).
std::vector<AxisPath> axis_paths(const Region& area, const Options& options);

/// The same paths as they look from afar: side branches and the outline's roughness do not turn them.
std::vector<AxisPath> straightened(const std::vector<AxisPath>& paths, const Options& options);

/// The same paths, parted where they turn sharply: longest leg first.
std::vector<AxisPath> parted_at_bends(const std::vector<AxisPath>& paths, const Options& options);

/// Where a line through `from` along the unit vector `along` leaves the area, both ways: distances forward
/// and backward; none when `from` is outside. O(corners).
struct Reach {
    double forward = 0, backward = 0;
};
std::optional<Reach> reach_from(std::span<const Region> area, Point from, Point along);

}  // namespace strandline::fill
