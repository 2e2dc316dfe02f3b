#pragma once
// Private to the room: zigzag fills, step by step: segments with a direction each, their lines, and the
// order.
#include "path/fill/rings.hpp"

namespace strandline::fill {

/// What one set of parallel lines is to rake, or another style.
struct Segment {
    Regions target;
    double direction = 0;             ///< of its lines, radians
    std::optional<Style> style = {};  ///< rings or spiral: no lines
};
/// The target (what the border ring leaves of the region) in segments, by options.partition and options.cuts,
/// each with the direction or style asked for there, else the direction that wastes least. Cuts, choices and
/// parts that cannot be are said in account.warnings.
std::vector<Segment> segments_of(const Region& region, const Regions& target, const std::string& place,
                                 const Options& options, Fill& account);

/// A segment raked in another style, and where a lifted rake may go in it as long as it is not raked.
struct OtherFill {
    std::vector<Pass> passes;
    std::vector<Ring> corridors;  ///< insets nested like its rings (their level), and its arms
};
/// The segment in its style, flush with what lies beside it: half an overlap larger, within the region.
OtherFill other_fill(const Segment& segment, const Region& region, const std::string& place,
                     const Options& options, Fill& account);

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

}  // namespace strandline::fill
