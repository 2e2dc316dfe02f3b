#pragma once
// Paths of an SVG -> elements in metres on the canvas: what is to be raked, as lines and regions. y up,
// origin at the canvas's lower left.
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/svg/svg.hpp"
#include "machine/robot/robot.hpp"
#include "math/curve/curve.hpp"
#include "math/region/region.hpp"

namespace strandline {

/// A line to be drawn: a polyline (open) or a polygon (closed). The path is exact: its nodes are the
/// drawing's own.
struct LineElement {
    Path path;
    int pins = 1;
    bool operator==(const LineElement&) const = default;
};
/// An area to be filled. Outlines flattened to the drawing's tolerance.
struct RegionElement {
    Region region;
    bool operator==(const RegionElement&) const = default;
};
/// Something drawn.
struct Element {
    std::string id, layer;
    std::variant<LineElement, RegionElement> what;
    int inside = -1;  ///< the smallest element whose outline encloses this one, -1: none
    /// What rules and the file itself ask for it, by name; "pause" names the layer that a stop comes before.
    std::vector<svg::Hint> hints = {};
    int section =
        0;  ///< pauses part the drawing into sections, in painting order; they are driven one by one
    bool operator==(const Element&) const = default;
};
bool is_region(const Element& element);
Box bounds(const Element& element);
/// Drawn length of a line; perimeter of a region.
double length(const Element& element);

/// A line drawn by hand as smooth curves that leave it by at most `tolerance` metres (> 0).
Path drawn_by_hand(const Path& path, double tolerance);

/// nullptr: there is no hint of that name.
const std::string* value_of(const std::vector<svg::Hint>& hints, std::string_view name);

struct Canvas {
    double width = 14, height = 14;
    bool operator==(const Canvas&) const = default;
};

/// Hints for every shape of a layer, a colour (fill or stroke) or an id; `*` in the pattern stands for any
/// letters.
struct InkRule {
    enum class Of { layer, colour, id } of = Of::layer;
    std::string pattern;
    std::vector<svg::Hint> hints;
};

enum class Place { fit, actual, width, scale };
struct DrawingOptions {
    Canvas canvas{};      ///< metres
    double margin = 0.5;  ///< metres kept free round the drawing (fit)
    Place place = Place::fit;
    double place_width = 0;              ///< metres, for Place::width: the drawing's width on the ground
    double scale_denominator = 0;        ///< for Place::scale, 1:50 -> 50: a metre of the SVG becomes 1/50 m
    std::optional<Point> position = {};  ///< metres: lower left corner of the drawing's box; default: centred
    double rotate = 0;                   ///< radians, counter-clockwise, before fitting
    bool mirror = false;                 ///< left and right swapped, before rotating
    double tolerance = 0.002;            ///< metres: flattening of regions
    double join_tolerance = 0.005;       ///< metres: line ends that near are one point
    double min_length = 0.01;            ///< metres: shorter lines are dropped and counted
    double simplify = 0;                 ///< metres: lines by fewer points within this; 0: as they are
    double smooth = 0;                   ///< metres: lines as smooth curves within this; 0: as they are
    double min_area = 0.0;               ///< m^2: smaller regions are dropped and counted
    double ink_threshold = 0.9;          ///< relative luminance above which paint is bare sand
    bool invert = false;                 ///< light on dark: what is bright is ink, and the ground is black
    std::vector<std::string> layers{};   ///< only what is in one of these is drawn; empty: everything
    std::vector<InkRule> rules{};        ///< later ones win, hints in the file over all of them
    /// a tool of its own for each layer or colour of what asks for none: the hint `tool`, counted from 1 in
    /// painting order
    enum class Tools { asked, by_layer, by_colour } tools = Tools::asked;
    bool occlusion = true;  ///< false: every element is drawn, whatever lies over it
};

/// What was done to the file's shapes on the way.
struct DrawingCounts {
    int unchosen = 0;  ///< shapes in layers that are not drawn, or with the hint ink=off
    int shapes = 0, joined = 0, duplicates = 0, too_short = 0, too_small = 0, bare = 0, merged = 0,
        wide_strokes = 0, hidden = 0, cut = 0;  ///< hidden: wholly under later paint; cut: lines, in part
    bool operator==(const DrawingCounts&) const = default;
};
struct Drawing {
    Canvas canvas;
    double scale = 1;                         ///< metres per SVG user unit
    std::optional<double> scale_denominator;  ///< 1 : this, against the SVG's physical size, where it has one
    Affine to_canvas;                         ///< user units -> metres
    std::vector<Element> elements;
    std::optional<Point> start;    ///< from a stroke of #00ff00: its first point
    std::optional<Region> border;  ///< of the hint field=border: where the robot may drive
    Regions keep_out;              ///< of the hint field=keep-out: where it must not
    DrawingCounts counts;
    Warnings warnings;
    bool operator==(const Drawing&) const = default;
};

/// Fill -> region, stroke -> line; fill and stroke of the same ink on one shape -> one region; a stroke wider
/// than the rake -> a region (where the robot's profile asks for it); nothing is raked twice; ends that meet
/// are joined; who encloses whom. Layers whose name begins with % are left out; elements of one whose name
/// begins with ! get the hint "pause". The hints "ink" (on, off) and "pins" are obeyed here. Error: nothing
/// to draw, zero-size canvas, margin larger than the canvas, a scale that is not finite. O(n log n).
Outcome<Drawing> make_drawing(const svg::Document& document, const Robot& robot,
                              const DrawingOptions& options, const Progress& progress = {});

/// "A4", "a3-landscape", "letter", "legal", "210x297mm", "14x14" (bare: metres) -> metres. A0 to A6 by ISO
/// 216. Error: unknown, or a side that is not above zero.
Outcome<Canvas> canvas_named(const std::string& name);
/// The defaults above belong to a beach of 14 m; here they are scaled down (never up) by the canvas's shorter
/// side, so that a sheet of A4 has a margin of 7.5 mm and loses no line over 0.15 mm.
DrawingOptions options_for(const Canvas& canvas);

}  // namespace strandline
