#pragma once
// Private to the room: what a pass does at its corners so that the sand outside the turn is raked too.
#include "path/fill/fill.hpp"

namespace strandline::fill {

/// How a corner is cut: the pass runs on beyond it by `onward`, the rake is lifted, and the
/// next pass starts `ahead` behind the corner. Metres.
struct Corner {
    double onward = 0, ahead = 0;
};
/// The corner between two edges, as far as cutting it pays. A right corner is tiled exactly: the first pass's
/// flat end closes with the outer edge of the second, which starts flush beside the first's inner edge. With
/// pins any sharp corner is cut, since what is raked twice or outside is masked; nothing otherwise: a turn on
/// the spot sweeps a round wedge, and leaves (w^2/4)(cot(a/2) - (pi - a)/2) of a corner of angle a. `border`:
/// of a pass along the outline. O(1).
std::optional<Corner> cut_corner(Point before, Point corner, Point after, bool border,
                                 const Options& options);

/// The passes of a line whose corners are cut. `closed`: the line ends where it starts, and that place is a
/// corner too, when one. O(points).
std::vector<Polyline> with_cut_corners(const Polyline& line, bool closed, bool border,
                                       const Options& options);

/// A ring whose sharp corners are drawn on towards the tip: the wedge that a turn on the spot sweeps then
/// reaches further into what it leaves bare, and for the first stretch gains more than the sides rake twice.
/// For rings that have a ring outside of them, or it would spill; the area is on the left. Corners that are
/// cut stay. O(points).
Polygon with_pointed_corners(const Polygon& ring, const Options& options);

}  // namespace strandline::fill
