#pragma once
// Private to the room: cuts of a zigzag's area, found here, from its plain outline (whose corners all
// matter). Each is a little longer than in that outline, so that it parts the true area.
#include "path/fill/passes.hpp"

namespace strandline::fill {

/// Smaller parts, as a share of width^2, are left to their neighbours' overlap.
inline constexpr double least_part = 0.05;

/// Cuts the area where that wastes less than one direction for all of it and the cut do, again and again.
/// O(cuts x reflex corners x corners).
std::vector<Polyline> fitted_cuts(const Region& plain, const Options& options);
/// The joints of the fewest convex parts. Chords of an arc would cost a sliver each: a joint from none but
/// such corners is left out where one direction serves both sides at no more waste than the cut costs. Error:
/// as convex_parts(). O(joints^2 x edges) beside it.
Outcome<std::vector<Polyline>> convex_cuts(const Region& plain, const Options& options);

}  // namespace strandline::fill
