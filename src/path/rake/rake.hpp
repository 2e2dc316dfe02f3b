#pragma once
// What a rake of liftable pins does along strokes: the moves of the drive, which pins are to be down where,
// and the account of what that leaves in the sand. Metres.
#include <optional>
#include <vector>

#include "math/region/region.hpp"
#include "path/stroke/stroke.hpp"

namespace strandline::rake {

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

/// The strokes as chords within `tolerance`, with the rake-up moves between them along `ways` (as Fill has
/// them; may be shorter). `masks`: by stroke; empty: all pins are down. Parts with other pins follow each
/// other without a move between; parts without any are rake-up moves, at the ends of a stroke too.
std::vector<Move> moves_of(const std::vector<Stroke>& strokes, const std::vector<Polyline>& ways,
                           const std::vector<PinSpans>& masks, int pins, double tolerance);

struct Rake {
    double width = 0.42;  ///< metres
    int pins = 7;
    double tolerance = 0.002;  ///< metres, of the chords that stand for a stroke
    double spill_price = 4;    ///< of sand raked outside, against sand left bare
};
/// For each stroke, in this order and along these ways, which of the `rake.pins` pins are to be down:
/// where sand under them is inside and not raked yet. Strokes may overlap and reach outside. A pin's width of
/// stairs is left where an edge runs across the pins; neither raked twice nor bare for more. About 20 ns a
/// cell of w / (4 pins) that is driven over.
std::vector<PinSpans> pin_masks(const Regions& regions, const std::vector<Stroke>& strokes,
                                const std::vector<Polyline>& ways, const Rake& rake);

/// The area with what is too thin for a pin made a pin wide, so that slivers are seen: parts that no disc as
/// wide as a pin reaches, if larger than two pins squared (corners' tips are smaller). O(corners log
/// corners).
Regions visible(const Region& region, double pin);

/// One go with the rake down, as driven: the bar's middle, and the heading that the bar stands square to (it
/// need not be that of its way).
struct Driven {
    std::vector<Pose> bar;
    double before = 0;  ///< metres driven before it
};
using DrivenMasks = std::vector<unsigned>;  ///< from each pose to the next: one less than poses
/// Whether the raster of an area of that size is fine enough for single pins. Of the rake: width, pins.
bool sees_single_pins(Box area, const Rake& rake);
/// The same from the bar's true track: for each go which pins are to be down. Of the rake: width, pins,
/// price. Nothing where the raster would be too coarse to see single pins.
std::optional<std::vector<DrivenMasks>> driven_masks(const Regions& regions, const std::vector<Driven>& goes,
                                                     const Rake& rake);

struct AccountOptions {
    double width = 0.42;          ///< rake width, metres
    int pins = 7;                 ///< that a mask's bits stand for
    double cell_share = 1 / 16.;  ///< of the width: the raster's cells; coarser is faster
    bool details = true;          ///< gaps, the outline and the reach of spill too
    double least_gap = 0.1;       ///< width: gaps no wider are not listed
};
/// Judges a drive, first move to last. Areas of more than some eight million cells get larger ones. About
/// 10 ns a cell of the area and its surroundings.
Account account_of(const Regions& regions, const std::vector<Move>& moves, const AccountOptions& options);
/// Of fills beside each other: shares by area, the rest summed; all their gaps; the farthest spill and end.
Account joined(Account a, const Account& b);

}  // namespace strandline::rake
