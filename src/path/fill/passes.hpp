#pragma once
// Private to the room: what the styles hand to fill_region.
#include <functional>

#include "path/fill/fill.hpp"

namespace strandline::fill {

/// One go of the rake as a chain of points. `way`: the corners of the rake-up way from the last pass's end to
/// this one's start, both left out; empty: straight.
struct Pass {
    Polyline way, line;
};
/// Where a fill is to begin and end, as near as that goes.
struct Wish {
    std::optional<Point> start, exit;
};
/// A fill, planned as far as no wish matters.
using Passes = std::function<std::vector<Pass>(const Wish&)>;
Passes ring_passes(const Region& region, const std::string& place, const Options& options, Fill& account);
Passes spiral_passes(const Region& region, const std::string& place, const Options& options, Fill& account);
Passes zigzag_passes(const Region& region, const std::string& place, const Options& options, Fill& account);
inline std::vector<Pass> no_passes(const Wish&) { return {}; }

/// Where the centre of a rake may be without any of it leaving the region: the inset by half the width,
/// without parts that serve less than `min_area` (counted in `account`, and said).
Regions room_for_centre(const Region& region, const std::string& place, const Options& options,
                        Fill& account);
/// The insets whose outlines are rings. Level k of the rake's centre is half a width and k spacings from the
/// outline, level k of the sand that it and the further ones rake k spacings.
struct Levels {
    Regions room;                       // level 0 of the centre
    std::vector<Regions> sand, centre;  // all levels from the straight skeleton; empty: each from the last
};
/// Falls back to Euclidean insets with a warning where there is no skeleton.
Levels levels_of(const Region& region, const std::string& place, const Options& options, Fill& account);
/// The sand of the next level within the rings along `centre`, which is of `level`.
Regions sand_within(const Levels& levels, const Regions& centre, int level, const Options& options);
/// The centre of `level` in sand of it.
Regions centre_of(const Levels& levels, const Region& sand, int level, const Options& options);
/// The middle line of a long thin area without holes: midpoints of the pairs of outline points that are
/// equally far from the tip at which pairing leaves the least distance. Empty when a pair is farther apart
/// than `widest`. O(corners), 48 x 64 samples.
Polyline middle_line(const Polygon& outline, double widest);
/// The chain without corners that lie within `tolerance` of it: Douglas-Peucker (1973).
Polyline thinned(const Polyline& line, double tolerance);
/// The area with its outlines thinned so; holes that come to nothing are dropped. Outlines may come to touch.
Region thinned_region(const Region& region, double tolerance);
/// The chain with its corners rounded to `radius`, or as much as half the shorter neighbour allows. Corners
/// of less than about 6 degrees stay.
Polyline rounded(const Polyline& line, double radius);
/// The chain moved `left` metres sideways, mitred at corners up to 120 degrees. One that ends where it begins
/// is closed.
Polyline moved_aside(const Polyline& line, double left);

}  // namespace strandline::fill
