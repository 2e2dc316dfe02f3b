#pragma once
// Regions -> strokes that rake them. Three styles: rings (nested insets, inside to outside), spiral (one
// continuous line of inset polygons) and zigzag (parallel lines); all with holes. Nothing is drawn in a hole.
// Metres.
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/region/region.hpp"
#include "path/rake/rake.hpp"
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

/// Where a vehicle that goes round corners in loops rakes their tips: nowhere (it rounds corners if it can),
/// in passes along the outline, or in every pass. The pass runs on to the tip, the rake is lifted, and the
/// next pass begins beside it.
enum class Tips { off, border, all };

/// What is asked for in one segment of a zigzag: in the part that holds `at`.
struct SegmentChoice {
    Point at;                              ///< metres
    std::optional<double> direction = {};  ///< of its lines, radians; absent: as everywhere
    std::optional<Style> style = {};       ///< rings or spiral instead of lines
};

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
    /// Zigzag: own directions and styles of what the cuts leave in one piece, or, where parts have a gap
    /// between them or are convex, of a part. Later ones win.
    std::vector<SegmentChoice> segments = {};
    double part_inset = 0;   ///< metres: each part of a partition shrinks by this (zigzag)
    double min_area = 0.01;  ///< m^2: smaller parts are dropped and counted
    bool border = true;      ///< a pass along the outline, driven last
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
    bool pivots = false;    ///< the vehicle may lift, back up and turn on the spot anywhere: corners are cut
    Tips tips = Tips::off;  ///< of one that may not; read where pins are `masked`
    int pins = 7;           ///< written into the strokes
    bool masked = false;    ///< pins are lifted over raked sand and outside: passes may overlap and overshoot
    int variants = 0;  ///< other starts and exits that are offered, at most; none of areas that take more
                       ///< than 3,000 widths of driving
};

/// The same area begun or ended elsewhere: what comes before and after it decides which is shortest.
struct Variant {
    std::vector<Stroke> strokes;  ///< as those of Fill
    std::vector<Polyline> ways;
    double longer = 0;  ///< metres driven within the area beyond those of the fill itself, rake up and down
};

/// The fill of one region.
struct Fill {
    std::vector<Stroke>
        strokes;  ///< in an order that they may be raked in: inside to outside, border last; one_way, fill
    std::vector<std::pair<int, int>> before;  ///< the first stroke is raked before the second; what these
                                              ///< pairs leave open is open, with other work between
    std::vector<Polyline> ways;     ///< rake-up way to stroke i from the one before, over sand not yet raked;
                                    ///< its ends left out, {}: straight
    std::vector<Variant> variants;  ///< of a fill of one stroke: start or exit more than a width from those
                                    ///< of all others
    double area = 0;                ///< of the region, m^2
    double swept = 0;               ///< stroke length x width, m^2
    int dropped_parts = 0;          ///< smaller than min_area or narrower than the rake
    std::vector<bool> cuts_used;    ///< of Options::cuts: those that part the area
    std::vector<bool> segments_used;  ///< of Options::segments: those that lie in a segment of it
    int skeletons_replaced = 0;       ///< 1: Euclidean insets instead of the skeleton's
    Warnings warnings;                ///< partition replaced, what is narrower than the rake, by place; ...
};

/// The choice of that name, as people write it ("half-step"). Error: at `place`, lists the names.
/// Choice: Style, Partition, Insets, Join, Narrow or Tips.
template <class Choice>
Outcome<Choice> named(const std::string& name, const std::string& place);

/// "0,2 4,2; 1,0 1,5" -> cuts, metres where no unit is given. Error.place is `place`.
Outcome<std::vector<Polyline>> cuts_of(const std::string& text, const std::string& place);

/// "2,3 direction=30deg; 5,1 style=rings" -> choices, units as elsewhere. Error.place is `place`; says which
/// choice is wrong.
Outcome<std::vector<SegmentChoice>> segment_choices_of(const std::string& text, const std::string& place);

/// A choice other than the default that not every style reads, as settings name it ("part_inset").
struct Choice {
    std::string_view name, serves;  ///< serves: the styles that read it
    bool read = false;              ///< by the style that is asked for, or by that of a segment
    bool operator==(const Choice&) const = default;
};
std::vector<Choice> choices_of(const Options& options);

/// Never fails: a region nothing fits into gives no strokes and a warning. `element` is written into the
/// strokes; `place` names the region in warnings. O(n log n + passes).
Fill fill_region(const Region& region, int element, const std::string& place, const Options& options);

/// What those strokes leave, with pins that lift where options say so.
rake::Account account_of(const Region& region, const std::vector<Stroke>& strokes,
                         const std::vector<Polyline>& ways, const Options& options);

}  // namespace strandline::fill
