// The table of settings: one row a field of Options. Everything that names, parses or prints a setting reads
// this table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include "base/units/units.hpp"
#include "math/region/region.hpp"
#include "plan/model/export_settings.hpp"
#include "plan/model/model.hpp"

namespace strandline {
namespace {

using Kind = Setting::Kind;
using Field = std::variant<double*, int*, bool*, std::string*>;

// Nothing that drives is larger than this; it also keeps squares and sums far from overflow.
constexpr double far = 100'000;

std::vector<Setting> make_table() {
    return {
        {"place.mode",
         "how the drawing is put on the canvas",
         Kind::choice,
         0,
         0,
         {"fit", "actual", "width", "scale"},
         "",
         [](Options& o) -> Field { return &o.place.mode; }},
        {"place.width",
         "width of the drawing on the ground, for mode width",
         Kind::length,
         1e-4,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.place.width; }},
        {"place.scale",
         "N of the scale 1:N against the SVG's own size, for mode scale",
         Kind::number,
         1e-6,
         1e9,
         {},
         "",
         [](Options& o) -> Field { return &o.place.scale_denominator; }},
        {"place.x",
         "left edge of the drawing on the canvas",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.place.x; }},
        {"place.y",
         "lower edge of the drawing on the canvas",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.place.y; }},
        {"place.positioned",
         "put the drawing's lower left corner at place.x, place.y",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.place.positioned; }},
        {"place.rotate",
         "turn the drawing counter-clockwise",
         Kind::angle,
         -1000,
         1000,
         {},
         "",
         [](Options& o) -> Field { return &o.place.rotate; }},
        {"place.mirror",
         "swap left and right",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.place.mirror; }},
        {"canvas.width",
         "width of the canvas",
         Kind::length,
         0,
         far,
         {},
         "--field_width",
         [](Options& o) -> Field { return &o.canvas.width; }},
        {"canvas.height",
         "height of the canvas",
         Kind::length,
         0,
         far,
         {},
         "--field_height",
         [](Options& o) -> Field { return &o.canvas.height; }},
        {"canvas.margin",
         "kept free round the drawing when it is fitted",
         Kind::length,
         0,
         far,
         {},
         "--field_offset",
         [](Options& o) -> Field { return &o.canvas.margin; }},
        {"canvas.run_out",
         "how far round the canvas the robot may drive; negative: 2 R + footprint",
         Kind::length,
         -1,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.canvas.run_out; }},
        {"drawing.tolerance",
         "largest distance between the drawing and the planned rake path",
         Kind::length,
         1e-6,
         1,
         {},
         "--angle_step",
         [](Options& o) -> Field { return &o.drawing.tolerance; }},
        {"drawing.join_tolerance",
         "line ends nearer than this are one point",
         Kind::length,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.join_tolerance; }},
        {"drawing.min_length",
         "shorter lines are dropped and counted",
         Kind::length,
         0,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.min_length; }},
        {"drawing.simplify",
         "lines by fewer points, off by at most this; 0: as they are",
         Kind::length,
         0,
         10,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.simplify; }},
        {"drawing.smooth",
         "freehand lines as smooth curves, off by at most this; 0: as they are",
         Kind::length,
         0,
         10,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.smooth; }},
        {"drawing.occlusion",
         "what a later shape covers is not drawn; off: every element is",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.occlusion; }},
        {"drawing.layers",
         "layers to draw, names separated by \";\" (* for any letters); empty: all",
         Kind::text,
         0,
         0,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.layers; }},
        {"drawing.rules",
         "hints by layer, colour or id: \"layer=NAME: pins=3; colour=#ff0000: tool=2\"",
         Kind::text,
         0,
         0,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.rules; }},
        {"drawing.tools",
         "what has no tool asked for is drawn with a tool of its own for each layer, or for each colour; "
         "asked: "
         "all with tool 1",
         Kind::choice,
         0,
         0,
         {"asked", "layer", "colour"},
         "",
         [](Options& o) -> Field { return &o.drawing.tools; }},
        {"ink.threshold",
         "paint brighter than this (luminance 0 to 1) is bare sand",
         Kind::number,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.ink.threshold; }},
        {"ink.invert",
         "the drawing is light on dark: what is bright is raked",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.ink.invert; }},
        {"drawing.dpi",
         "px to the inch in the SVG; 0: 96, or 90 where an Inkscape before 0.92 wrote it",
         Kind::number,
         0,
         1e5,
         {},
         "",
         [](Options& o) -> Field { return &o.drawing.dpi; }},
        {"trace.threshold",
         "of a picture, what is darker than this (0 to 1) is ink; 0: found by Otsu's method",
         Kind::number,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.trace.threshold; }},
        {"trace.despeckle",
         "specks of a picture of up to so many pixels are left out",
         Kind::integer,
         0,
         1'000'000'000,
         {},
         "",
         [](Options& o) -> Field { return &o.trace.despeckle; }},
        {"trace.alphamax",
         "roundness of a traced picture: 0 keeps polygons, from 4/3 on there are no corners",
         Kind::number,
         0,
         2,
         {},
         "",
         [](Options& o) -> Field { return &o.trace.alphamax; }},
        {"trace.opttolerance",
         "in pixels; curves of a traced picture are joined where that moves them by less",
         Kind::number,
         0,
         1000,
         {},
         "",
         [](Options& o) -> Field { return &o.trace.opttolerance; }},
        {"text.substitutes",
         "text whose font is not on this machine is set in another; off: it is left out",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.text.substitutes; }},
        {"fill.style",
         "how areas are raked",
         Kind::choice,
         0,
         0,
         {"rings", "spiral", "zigzag"},
         "--fill_method",
         [](Options& o) -> Field { return &o.fill.style; }},
        {"fill.inset",
         "rings, spiral: how they follow from the outline: Euclidean insets, or those of its straight "
         "skeleton",
         Kind::choice,
         0,
         0,
         {"offset", "skeleton"},
         "",
         [](Options& o) -> Field { return &o.fill.inset; }},
        {"fill.join",
         "rings: how one leads on to the next: half-step stops half a width before it closes and steps over; "
         "nearest "
         "closes and goes on from there; alternating turns the sense at each ring; longest-edge begins each "
         "in "
         "the middle of its longest edge",
         Kind::choice,
         0,
         0,
         {"half-step", "nearest", "alternating", "longest-edge"},
         "",
         [](Options& o) -> Field { return &o.fill.join; }},
        {"fill.shift",
         "spiral: rake widths along which each turn shifts outwards; many: all round",
         Kind::number,
         0.1,
         1e6,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.shift; }},
        {"fill.spacing",
         "between neighbouring passes, at most the rake's width; 0: a pin less than the rake where pins lift "
         "one by one, else a twentieth less than it is wide. Where pins lift, whole pins fit best",
         Kind::length,
         0,
         far,
         {},
         "--line_distance",
         [](Options& o) -> Field { return &o.fill.spacing; }},
        {"fill.direction",
         "zigzag: of its lines; giving it switches fill.best_direction off",
         Kind::angle,
         -1000,
         1000,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.direction; }},
        {"fill.best_direction",
         "zigzag: the direction that wastes least, in each part, whatever fill.direction says",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.best_direction; }},
        {"fill.partition",
         "zigzag: how an area is cut into parts; fitted: where another direction wastes less sand",
         Kind::choice,
         0,
         0,
         {"none", "monotone", "optimal-convex", "fitted"},
         "--segmentation_on",
         [](Options& o) -> Field { return &o.fill.partition; }},
        {"fill.cuts",
         "zigzag: lines that part areas first, in metres on the ground: \"x,y x,y; x,y x,y\"",
         Kind::text,
         0,
         0,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.cuts; }},
        {"fill.segments",
         "zigzag: directions and styles of single segments, each by a point in it, in metres on the ground: "
         "\"x,y direction=30deg; x,y style=rings\"",
         Kind::text,
         0,
         0,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.segments; }},
        {"fill.one_stroke",
         "the rake stays down inside an area, even where it must rake over raked sand. Made for plotters: "
         "where a rake that trails cannot follow a corner it is lifted all the same, and that is counted",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.one_stroke; }},
        {"fill.rake_turns",
         "zigzag: the rake stays down from line to line; off: it is lifted at each line's end",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.rake_turns; }},
        {"fill.part_inset",
         "zigzag: each part shrinks by this, so that sand stays bare between parts and inside the border",
         Kind::length,
         0,
         far,
         {},
         "--segment_offset",
         [](Options& o) -> Field { return &o.fill.part_inset; }},
        {"fill.min_area",
         "smaller areas and parts, in square metres, are dropped and counted",
         Kind::number,
         0,
         far,
         {},
         "--area_deletion_threshold",
         [](Options& o) -> Field { return &o.fill.min_area; }},
        {"fill.narrow",
         "parts of areas that are narrower than the rake: one pass along the middle, which reaches outside, "
         "or "
         "left bare; both with a warning",
         Kind::choice,
         0,
         0,
         {"single-pass", "warn"},
         "",
         [](Options& o) -> Field { return &o.fill.narrow; }},
        {"fill.tips",
         "sharp corners of areas that are raked to their tips, by a loop with the rake up, where the robot "
         "cannot turn on the spot and its pins lift one by one: of all passes, of those along the border "
         "(sooner done), or none (rounded)",
         Kind::choice,
         0,
         0,
         {"off", "border", "all"},
         "",
         [](Options& o) -> Field { return &o.fill.tips; }},
        {"fill.lift_pins",
         "pins lift one by one over sand that is raked already and outside the area; off: all pins of a rake "
         "are "
         "down together",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.lift_pins; }},
        {"fill.border",
         "zigzag: a pass along the outline, driven last; rings and spirals always end on it",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.fill.border; }},
        {"tour.inner_first",
         "what lies inside an outline is drawn before the outline",
         Kind::flag,
         0,
         1,
         {},
         "--no_tree_ordering",
         [](Options& o) -> Field { return &o.tour.inner_first; }},
        {"tour.start_x",
         "start point",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.start_x; }},
        {"tour.start_y",
         "start point",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.start_y; }},
        {"tour.has_start",
         "begin near tour.start_x, tour.start_y",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.has_start; }},
        {"tour.end_x",
         "end point",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.end_x; }},
        {"tour.end_y",
         "end point",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.end_y; }},
        {"tour.has_end",
         "end near tour.end_x, tour.end_y",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.has_end; }},
        {"tour.method",
         "best: a search, and a proof where it can be had; exact: the shortest for straight gaps, or an "
         "error; "
         "nearest, file: no search, to compare with",
         Kind::choice,
         0,
         0,
         {"best", "exact", "nearest", "file"},
         "",
         [](Options& o) -> Field { return &o.tour.method; }},
        {"tour.cost",
         "what the search makes least: metres driven between robot poses with what avoid.* asks for, seconds "
         "(the "
         "same, with bends that the robot takes slower), or straight gaps",
         Kind::choice,
         0,
         0,
         {"driven", "seconds", "straight"},
         "",
         [](Options& o) -> Field { return &o.tour.cost; }},
        {"tour.grouped",
         "neighbouring strokes are finished together, so that the drawing grows part by part",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.grouped; }},
        {"tour.threads",
         "so many searches at once, with seeds from tour.seed on; the best is taken",
         Kind::integer,
         1,
         64,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.threads; }},
        {"tour.seed",
         "of the search for the order",
         Kind::integer,
         0,
         2'000'000'000,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.seed; }},
        {"tour.moves",
         "budget of the search; 0: from the size",
         Kind::integer,
         0,
         2'000'000'000,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.moves; }},
        {"tour.time_limit",
         "stop the search after this; 0: no limit. A plan made so may differ from run to run",
         Kind::duration,
         0,
         1e6,
         {},
         "",
         [](Options& o) -> Field { return &o.tour.time_limit; }},
        {"corner.threshold",
         "corners that turn this much or more are treated as corner.above says, others as "
         "corner.below",
         Kind::angle,
         0,
         pi,
         {},
         "--threshold_round_angle",
         [](Options& o) -> Field { return &o.corner.threshold; }},
        {"corner.radius",
         "of corners rounded inside",
         Kind::length,
         0,
         far,
         {},
         "--round_radius",
         [](Options& o) -> Field { return &o.corner.radius; }},
        {"corner.fill_radius",
         "of corners in fills, which are always rounded inside",
         Kind::length,
         0,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.corner.fill_radius; }},
        {"corner.below",
         "corners under the threshold: driven exactly, or rounded inside",
         Kind::choice,
         0,
         0,
         {"exact", "round"},
         "",
         [](Options& o) -> Field { return &o.corner.below; }},
        {"corner.above",
         "corners over the threshold: a loop outside, stop and turn, or rounded inside",
         Kind::choice,
         0,
         0,
         {"loop", "pivot", "round"},
         "--stop_go_outer",
         [](Options& o) -> Field { return &o.corner.above; }},
        {"connect.style",
         "curves between strokes, bounded in curvature and sharpness: the shortest (bounded), gentler at "
         "some "
         "more length (fair), splines where they keep the limits (spiro, bezier); or straight with turns on "
         "the spot",
         Kind::choice,
         0,
         0,
         {"bounded", "fair", "spiro", "bezier", "straight"},
         "",
         [](Options& o) -> Field { return &o.connect.style; }},
        {"connect.extra_length",
         "share of its length by which a fair connection may be longer than the shortest",
         Kind::number,
         0,
         10,
         {},
         "",
         [](Options& o) -> Field { return &o.connect.extra_length; }},
        {"connect.min_length",
         "gaps shorter than this are joined directly",
         Kind::length,
         0,
         1,
         {},
         "--round_connection_threshold",
         [](Options& o) -> Field { return &o.connect.min_length; }},
        {"avoid.finished",
         "rake up round finished areas, and across few drawn lines; off: the shortest way and order",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.avoid.finished; }},
        {"avoid.clearance",
         "kept by the robot's turning point from finished areas; negative: as far as its wheels reach",
         Kind::length,
         -1,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.avoid.clearance; }},
        {"avoid.crossing_cost",
         "way that one crossing of a drawn line is worth",
         Kind::length,
         0,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.avoid.crossing_cost; }},
        {"avoid.area_cost",
         "metres of way that a metre over a finished area is worth; too near to one, a quarter of that",
         Kind::number,
         0,
         1000,
         {},
         "",
         [](Options& o) -> Field { return &o.avoid.area_cost; }},
        {"field.border",
         "where the robot may drive: corners \"x,y x,y x,y\" in metres on the canvas; empty: the drawing's, "
         "or "
         "the canvas and canvas.run_out round it",
         Kind::text,
         0,
         0,
         {},
         "",
         [](Options& o) -> Field { return &o.field.border; }},
        {"field.keep_out",
         "where the robot must not go: corners \"x,y x,y x,y\" in metres on the canvas, \";\" between areas",
         Kind::text,
         0,
         0,
         {},
         "",
         [](Options& o) -> Field { return &o.field.keep_out; }},
        {"park.x",
         "where the robot is parked: its turning point on the canvas",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.park.x; }},
        {"park.y",
         "where the robot is parked: its turning point on the canvas",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.park.y; }},
        {"park.heading",
         "where the parked robot looks; 0: along x, counter-clockwise",
         Kind::angle,
         -1000,
         1000,
         {},
         "",
         [](Options& o) -> Field { return &o.park.heading; }},
        {"park.parked",
         "the drive begins at park.x, park.y, looking along park.heading; off: at the first stroke",
         Kind::flag,
         0,
         1,
         {},
         "",
         [](Options& o) -> Field { return &o.park.parked; }},
        {"park.exit_x",
         "where the drive ends, for exit pose",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.park.exit_x; }},
        {"park.exit_y",
         "where the drive ends, for exit pose",
         Kind::length,
         -far,
         far,
         {},
         "",
         [](Options& o) -> Field { return &o.park.exit_y; }},
        {"park.exit_heading",
         "where the robot looks at the end, for exit pose",
         Kind::angle,
         -1000,
         1000,
         {},
         "",
         [](Options& o) -> Field { return &o.park.exit_heading; }},
        {"park.exit",
         "where the drive ends: at the last stroke, where it was parked, outside the drawing, or at "
         "park.exit_x, "
         "park.exit_y, looking along park.exit_heading",
         Kind::choice,
         0,
         0,
         {"none", "parked", "outside", "pose"},
         "",
         [](Options& o) -> Field { return &o.park.exit; }},
        {"trajectory.step",
         "between samples of the robot path",
         Kind::length,
         0.0001,
         0.05,
         {},
         "--max_interp_distance",
         [](Options& o) -> Field { return &o.trajectory.step; }},
    };
}

const Setting* find(const std::string& key) {
    const auto& table = settings();
    const auto at = std::ranges::find(table, key, &Setting::key);
    return at == table.end() ? nullptr : &*at;
}

/// Levenshtein distance, for "did you mean".
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = above;
        }
    }
    return row.back();
}

Outcome<double> parse(const Setting& setting, const std::string& value) {
    switch (setting.kind) {
        case Kind::length:
            return parse_length(value, setting.key);
        case Kind::angle:
            return parse_angle(value, setting.key);
        case Kind::duration:
            return parse_duration(value, setting.key);
        default:
            return parse_number(value, setting.key);
    }
}

std::string range_text(const Setting& setting) {
    // A length of a field may not be zero: a canvas without extent holds nothing. Zero is named where it is
    // used.
    return fmt::format("use {} to {}{}", setting.low, setting.high,
                       setting.kind == Kind::length     ? " m"
                       : setting.kind == Kind::angle    ? " rad"
                       : setting.kind == Kind::duration ? " s"
                                                        : "");
}

Outcome<bool> parse_flag(const std::string& key, const std::string& value) {
    if (value == "true" || value == "on" || value == "yes" || value == "1") return true;
    if (value == "false" || value == "off" || value == "no" || value == "0") return false;
    return fail(key, fmt::format("\"{}\" is neither on nor off", value), "use on or off");
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

const std::vector<Setting>& settings() {
    static const std::vector<Setting> table = [] {
        std::vector<Setting> all = make_table();
        std::ranges::move(export_settings(), std::back_inserter(all));
        return all;
    }();
    return table;
}

std::string name_of(Setting::Kind kind) {
    switch (kind) {
        case Kind::length:
            return "length";
        case Kind::angle:
            return "angle";
        case Kind::duration:
            return "duration";
        case Kind::number:
            return "number";
        case Kind::integer:
            return "whole number";
        case Kind::flag:
            return "on or off";
        case Kind::choice:
            return "choice";
        case Kind::text:
            return "text";
    }
    return {};
}

namespace {

/// Giving a value means wanting it: a start point, a position and a direction each have a switch beside them.
void switch_on(Options& options, const std::string& key) {
    if (key == "place.x" || key == "place.y") options.place.positioned = true;
    if (key == "tour.start_x" || key == "tour.start_y") options.tour.has_start = true;
    if (key == "tour.end_x" || key == "tour.end_y") options.tour.has_end = true;
    if (key == "park.x" || key == "park.y" || key == "park.heading") options.park.parked = true;
    if (key.starts_with("park.exit_")) options.park.exit = "pose";
    if (key.starts_with("site.")) options.site.known = true;
    if (key == "fill.direction") options.fill.best_direction = false;
}

}  // namespace

Outcome<void> set(Options& options, const std::string& key, const std::string& value) {
    const Setting* setting = find(key);
    if (!setting) {
        const auto& table = settings();
        const auto nearest =
            std::ranges::min_element(table, {}, [&](const Setting& s) { return edit_distance(s.key, key); });
        return fail(key, "there is no such setting", fmt::format("did you mean {}?", nearest->key));
    }
    const Field field = setting->field(options);
    if (setting->kind == Kind::choice) {
        if (std::ranges::find(setting->choices, value) == setting->choices.end())
            return fail(key, fmt::format("\"{}\" is not a choice", value),
                        "use one of " + joined(setting->choices));
        *std::get<std::string*>(field) = value;
        return {};
    }
    if (setting->kind == Kind::text) {
        if (key == "drawing.rules")
            if (const auto rules = rules_of(value); !rules) return tl::unexpected(rules.error());
        if (key == "field.border" || key == "field.keep_out") {
            const auto outlines = outlines_of(value, key);
            if (!outlines) return tl::unexpected(outlines.error());
            if (key == "field.border" && outlines->size() > 1)
                return fail(key, "holds more than one outline", "what lies between them is a keep-out");
        }
        *std::get<std::string*>(field) = value;
        return {};
    }
    if (setting->kind == Kind::flag) {
        const auto flag = parse_flag(key, value);
        if (!flag) return tl::unexpected(flag.error());
        *std::get<bool*>(field) = *flag;
        return {};
    }
    const auto number = parse(*setting, value);
    if (!number) return tl::unexpected(number.error());
    if (*number < setting->low || *number > setting->high)
        return fail(key, fmt::format("{} is out of range", value), range_text(*setting));
    if (setting->kind == Kind::integer) {
        if (*number != std::floor(*number)) return fail(key, fmt::format("{} is not a whole number", value));
        *std::get<int*>(field) = static_cast<int>(*number);
    } else {
        *std::get<double*>(field) = *number;
    }
    switch_on(options, key);
    return {};
}

std::string get(const Options& options, const std::string& key) {
    const Setting* setting = find(key);
    if (!setting) return {};
    Options copy = options;  // the table's accessors give writable fields
    return std::visit(
        [&](auto* field) -> std::string {
            using Value = std::remove_pointer_t<decltype(field)>;
            if constexpr (std::is_same_v<Value, std::string>)
                return *field;
            else if constexpr (std::is_same_v<Value, bool>)
                return *field ? "on" : "off";
            else if constexpr (std::is_same_v<Value, int>)
                return fmt::format("{}", *field);
            else
                return number_text(*field) + (setting->kind == Kind::angle ? "rad" : "");
        },
        setting->field(copy));
}

DriveArea drive_area_of(const Drawing& drawing, const Options& options, const Robot& robot) {
    DriveArea area;
    const double run_out =
        options.canvas.run_out >= 0 ? options.canvas.run_out : 2 * robot.min_radius + footprint_reach(robot);
    const Box box = grown({{0, 0}, {drawing.canvas.width, drawing.canvas.height}}, run_out);
    area.border.outer = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    if (drawing.border) area.border = *drawing.border;
    const auto asked = outlines_of(options.field.border, "field.border");
    if (asked && !asked->empty()) area.border = {counter_clockwise(asked->front()), {}};
    if (robot.setback > 0 && (drawing.border || (asked && !asked->empty()))) {
        // of several parts the largest; where none is left, nothing is allowed
        const Regions parts = inset({area.border}, robot.setback);
        const auto largest =
            std::ranges::max_element(parts, {}, [](const Region& part) { return strandline::area({part}); });
        area.border = largest == parts.end() ? Region{} : *largest;
    }
    area.keep_out = drawing.keep_out;
    if (const auto more = outlines_of(options.field.keep_out, "field.keep_out"))
        for (const Polygon& outline : *more) area.keep_out.push_back({counter_clockwise(outline), {}});
    return area;
}
DriveArea drive_area_of(const Plan& plan) { return drive_area_of(plan.drawing, plan.options, plan.robot); }
Box field_of(const Plan& plan) { return bounds(drive_area_of(plan).border); }

}  // namespace strandline
