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
/// How a zigzag area is cut into segments: not at all, its lines joined row by row; into cells in each of
/// which every line is in one piece (one direction for all); into the fewest convex parts, each with its own
/// direction; or where a cut and another direction behind it waste less sand than they cost.
enum class Partition { none, monotone, optimal_convex, fitted };
/// How rings follow from the outline (rings, spiral): Euclidean insets; or the mitred ones of its straight
/// skeleton, as in the thesis.
enum class Insets { offset, skeleton };
/// How a ring leads on to the next one (rings): by a step half a width before it closes; from wherever it
/// ends to the nearest place of the next; the same with the sense turned at each ring; from the longest edge.
enum class Join { half_step, nearest, alternating, longest_edge };

/// What is narrower than the rake: one pass along its middle, which spills and is said, or bare sand and a
/// warning.
enum class Narrow { single_pass, warn };

struct Options {
    Style style = Style::rings;
    Insets insets = Insets::offset;
    Join join = Join::half_step;
    double shift = 3;     ///< spiral, rake widths: the stretch of each turn along which it shifts to the next
                          ///< ring; more than a turn: all along, as a spiral of Archimedes
    double width = 0.42;  ///< rake width, metres
    double spacing = 0.40;  ///< metres between neighbouring passes, 0 < spacing <= width
    std::optional<double> direction =
        {};  ///< zigzag lines, radians; absent: that with the least waste, in each segment
    Partition partition = Partition::fitted;
    std::vector<Polyline> cuts = {};  ///< zigzag: lines that part the area before anything else, metres
    double part_inset = 0;            ///< metres: each part of a partition shrinks by this (zigzag)
    double min_area = 0.01;           ///< m^2: smaller parts are dropped and counted
    bool border = true;               ///< a pass along the outline, driven last
    Narrow narrow = Narrow::single_pass;
    double tolerance = 0.002;  ///< metres
    double turn_radius =
        0;  ///< metres: least radius of the rake path in turns, as far as there is room; 0: sharp turns
    bool round_corners =
        true;  ///< bend passes by turn_radius here; false: whoever drives them rounds their corners
    bool one_stroke =
        false;  ///< the rake never lifts inside the region, even if it must rake over raked sand
    bool rake_turns =
        true;  ///< zigzag: the rake stays down from line to line where that stays inside; false: it is lifted
    bool pivots = false;   ///< the vehicle may lift, back up and turn on the spot anywhere: corners are cut
    int pins = 7;          ///< written into the strokes
    bool masked = false;   ///< pins are lifted over raked sand and outside: passes may overlap and overshoot
    bool account = false;  ///< judge the fill too: as dear as the fill itself
};

/// The pins that are down over a part of a stroke: from and to are metres along its rake path, the highest of
/// the `pins` bits is the leftmost pin looking forward.
struct PinSpan {
    double from = 0, to = 0;
    unsigned mask = 0;
    bool operator==(const PinSpan&) const = default;
};
using PinSpans = std::vector<PinSpan>;  ///< ascending; where there is none, all are up

/// A piece of the drive of a fill: chords, and the pins that are down on it.
struct Move {
    Polyline line;
    unsigned mask = 0;  ///< 0: rake up
    bool operator==(const Move&) const = default;
};
/// Mask of a rake with all of 1 to 32 pins down.
constexpr unsigned all_pins(int pins) { return pins >= 32 ? ~0U : (1U << pins) - 1; }

/// Sand of the area that no stroke rakes.
struct Gap {
    Point at;         ///< centre of the widest disc in it
    double area = 0;  ///< m^2
    double disc = 0;  ///< diameter of the widest disc in it, metres
    bool operator==(const Gap&) const = default;
};

/// What a fill leaves in the sand, from a simulation on a raster: a straight bar across the path with flat
/// ends that pivots about the path's corners. Shares are of the area.
struct Account {
    double area = 0;            ///< m^2
    double coverage = 0;        ///< share raked
    double overdraw = 0;        ///< share raked again, more than a width of travel after it was last
    double spill = 0;           ///< area raked outside / area
    double spill_reach = 0;     ///< farthest raked sand from the area, metres
    double ratio = 0;           ///< length x width of what is down / area
    int hops = 0, pivots = 0;   ///< rake-up moves longer than a width, and shorter ones
    double hops_length = 0;     ///< of both, metres
    int drives_over = 0;        ///< times the path, rake up or down, enters sand raked more than 1.5 widths
                                ///< of travel before and stays for more than 0.75
    double driven_over = 0;     ///< metres of path over such sand, short stays too
    double crisp_edge = 0;      ///< share of the outline within 0.1 width of the raked edge
    double end_off_border = 0;  ///< from the outside of the rake at the end to the outline, metres
    std::vector<Gap> gaps;      ///< largest first
    double cell = 0;            ///< of the raster, metres: figures are good to a few of them along edges
    bool operator==(const Account&) const = default;
};

/// The fill of one region and its account.
struct Fill {
    std::vector<Stroke>
        strokes;  ///< in the order they must be raked: inside to outside, border last; one_way, fill = true
    std::vector<Polyline> ways;  ///< rake-up way to stroke i from the one before, over sand not yet raked;
                                 ///< its ends left out, {}: straight
    double area = 0;             ///< of the region, m^2
    double swept = 0;            ///< stroke length x width, m^2
    std::optional<Account> account;  ///< where options ask for it
    int dropped_parts = 0;           ///< smaller than min_area or narrower than the rake
    int skeletons_replaced = 0;      ///< 1: Euclidean insets instead of the skeleton's
    Warnings warnings;               ///< partition replaced, what is narrower than the rake, by place; ...
};

/// "0,2 4,2; 1,0 1,5" -> cuts, metres where no unit is given. Error.place is `place`.
Outcome<std::vector<Polyline>> cuts_of(const std::string& text, const std::string& place);

/// Never fails: a region nothing fits into gives no strokes and a warning. `element` is written into the
/// strokes; `place` names the region in warnings. O(n log n + passes).
Fill fill_region(const Region& region, int element, const std::string& place, const Options& options);

/// The strokes as chords within `tolerance`, with the rake-up moves between them along `ways` (as Fill has
/// them; may be shorter). `masks`: by stroke; empty: all pins are down. Parts with other pins follow each
/// other without a move between; parts without any are rake-up moves, at the ends of a stroke too.
std::vector<Move> moves_of(const std::vector<Stroke>& strokes, const std::vector<Polyline>& ways,
                           const std::vector<PinSpans>& masks, int pins, double tolerance);

/// For each stroke, in this order and along these ways, which of the `options.pins` pins are to be down:
/// where sand under them is inside and not raked yet. Strokes may overlap and reach outside. A pin's width of
/// stairs is left where an edge runs across the pins; neither raked twice nor bare for more. Of the options:
/// width, pins, tolerance. About 20 ns a cell of w / (4 pins) that is driven over.
std::vector<PinSpans> pin_masks(const Regions& regions, const std::vector<Stroke>& strokes,
                                const std::vector<Polyline>& ways, const Options& options);

struct AccountOptions {
    double width = 0.42;          ///< rake width, metres
    int pins = 7;                 ///< that a mask's bits stand for
    double cell_share = 1 / 16.;  ///< of the width: the raster's cells; coarser is faster
    bool details = true;          ///< gaps, the outline and the reach of spill too
    int most_gaps = 20;           ///< listed
    double least_gap = 0.1;       ///< width: gaps no wider are not listed
};
/// Judges a drive, first move to last. Areas of more than some eight million cells get larger ones. About
/// 10 ns a cell of the area and its surroundings.
Account account_of(const Regions& regions, const std::vector<Move>& moves, const AccountOptions& options);
/// Of fills beside each other: shares by area, the rest summed; all their gaps; the farthest spill and end.
Account joined(Account a, const Account& b);

}  // namespace strandline::fill
