#pragma once
// Private to the room: zigzag fills, step by step: segments with a direction each, their lines, and the
// order.
#include "path/fill/rings.hpp"

namespace strandline::fill {

/// What one set of parallel lines is to rake.
struct Segment {
    Regions target;
    double direction = 0;  ///< of its lines, radians
};
/// The target (what the border ring leaves of the region) in segments, by options.partition and options.cuts,
/// each with the direction that wastes least unless one is asked for. Cuts and parts that cannot be are said
/// in account.warnings.
std::vector<Segment> segments_of(const Regions& target, const std::string& place, const Options& options,
                                 Fill& account);

/// One line, from the left to the right as seen along the segment's direction.
struct Line {
    Polyline points;    ///< left, right, and one more at an end where the bar turns flush with a slanted edge
    Point left, right;  ///< as seen along the direction
    int row = 0;        ///< counted from below
    double from, to;    ///< of x in the frame turned by -direction
};
/// The lines of a segment, bottom up, left to right: the rows that waste least, each as long as covers its
/// band but for a budget of sand, and as the rake's whole bar stays in the region.
std::vector<Line> lines_of(const Segment& segment, const Regions& region, const Options& options);

/// Overlap and bare sand of those lines, m^2, bare sand weighed. O(edges + what bands meet).
double waste_of(const Segment& segment, const Options& options);

/// The regions turned about the origin.
Regions turned(Regions regions, double angle);

/// Lines and border rings in an order in which the sand not yet raked stays connected, with the ways between.
std::vector<Pass> driven(const std::vector<std::vector<Line>>& segments, const std::vector<Ring>& borders,
                         const Regions& room, const Wish& wish, const Options& options);

}  // namespace strandline::fill
