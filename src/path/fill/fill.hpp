#pragma once
// Regions -> strokes that rake them. Three styles: rings (nested insets, inside to outside), spiral (one
// continuous line of inset polygons) and zigzag (parallel lines); all with holes. Nothing is drawn in a hole.
// Metres.
#include <optional>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/robot/robot.hpp"
#include "math/region/region.hpp"
#include "path/stroke/stroke.hpp"

namespace strandline::fill {

enum class Style { rings, spiral, zigzag };
enum class Partition { none, monotone, optimal_convex };
/// How a ring leads on to the next one (rings): by a step half a width before it closes; from wherever it
/// ends to the nearest place of the next; the same with the sense turned at each ring; from the longest edge.
enum class Join { half_step, nearest, alternating, longest_edge };

struct Options {
    Style style = Style::rings;
    Join join = Join::half_step;
    double width = 0.42;    ///< rake width, metres
    double spacing = 0.40;  ///< metres between neighbouring passes, 0 < spacing <= width
    std::optional<double> direction =
        {};  ///< zigzag lines, radians; absent: the direction with the least passes
    Partition partition = Partition::monotone;
    double part_inset = 0;     ///< metres: each part of a partition shrinks by this (zigzag)
    double min_area = 0.01;    ///< m^2: smaller parts are dropped and counted
    bool border = true;        ///< a pass along the outline, driven last
    double tolerance = 0.002;  ///< metres
    double turn_radius =
        0;  ///< metres: least radius of the rake path in turns, as far as there is room; 0: sharp turns
    bool round_corners =
        true;  ///< bend passes by turn_radius here; false: whoever drives them rounds their corners
    bool rake_turns =
        true;  ///< zigzag: the rake stays down from line to line where that stays inside; false: it is lifted
    bool pivots = false;  ///< the vehicle may lift, back up and turn on the spot anywhere: corners are cut
    int pins = 7;         ///< written into the strokes
};

/// The fill of one region and its account.
struct Fill {
    std::vector<Stroke>
        strokes;  ///< in the order they must be raked: inside to outside, border last; one_way, fill = true
    std::vector<Polyline> ways;  ///< rake-up way to stroke i from the one before, over sand not yet raked;
                                 ///< its ends left out, {}: straight
    double area = 0;             ///< of the region, m^2
    double swept = 0;            ///< stroke length x width, m^2
    int dropped_parts = 0;       ///< smaller than min_area or narrower than the rake
    Warnings warnings;           ///< partition replaced, region narrower than the rake, ...
};

/// Never fails: a region nothing fits into gives no strokes and a warning. `element` is written into the
/// strokes; `place` names the region in warnings. O(n log n + passes).
Fill fill_region(const Region& region, int element, const std::string& place, const Options& options);

}  // namespace strandline::fill
