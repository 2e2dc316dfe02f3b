#pragma once
// SVG text -> plain paths with their final paint, in user units of the root, y DOWN as SVG has it. What is
// not understood is a warning with its place; nothing is dropped silently. The contract of the tree that
// comes out is in docs/svg.md.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/curve/curve.hpp"

namespace strandline::svg {

struct Colour {
    unsigned char r = 0, g = 0, b = 0;
    bool operator==(const Colour&) const = default;
};

/// Ink laid on an outline or inside it. Absent where `none`. opacity in 0..1, all inherited opacities
/// multiplied in.
struct Paint {
    Colour colour;
    double opacity = 1;
    bool operator==(const Paint&) const = default;
};

enum class FillRule { nonzero, even_odd };
enum class LineCap { butt, round, square };
enum class LineJoin { miter, round, bevel };

/// One shape element of the file that draws something: it has a fill or a stroke. Every path is in the root's
/// user units with all transforms applied.
struct Shape {
    std::string
        id;  ///< unique: the element's id, "path@LINE:COLUMN" without one, "ID@LINE:COLUMN" when taken
    std::string layer;           ///< names of the Inkscape layers around it, joined by "/"; "" outside
    std::string place;           ///< for messages: "line 12, <path> #eye"
    int line = 0;                ///< in the file, 1-based
    std::vector<Path> subpaths;  ///< at least one, each with at least one segment
    FillRule fill_rule = FillRule::nonzero;
    std::optional<Paint> fill, stroke;
    double stroke_width = 1;  ///< user units of the root: own width x mean scale of the transforms
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
};

/// The whole file. width, height: the root's size in user units after viewBox (the viewBox's own size, or
/// width and height in px at 96 dpi). Shapes are in painting order.
struct Document {
    Box view;  ///< what is visible, user units (viewBox, or 0 0 width height, or the bounds of the shapes)
    std::optional<Point>
        size_metres;  ///< physical size when width and height have units or px (96 dpi); absent for % or none
    std::vector<Shape> shapes;
    std::vector<double> rake_sizes;  ///< root attribute of 2014; empty when absent
    Warnings warnings;
};

struct Limits {
    std::size_t bytes = 256u << 20;
    int depth = 512;  ///< nested elements
    std::size_t elements = 1'000'000;
    std::size_t segments = 10'000'000;
};

/// Reads SVG. Error: empty, not XML (with line and column), no <svg> root, over a limit, entity bomb. Numbers
/// that are not finite, or over 1e15, are errors with their place when they are part of geometry. O(bytes).
Outcome<Document> read(std::string_view text, const Limits& limits = {}, const Progress& progress = {});

/// The d attribute alone, as subpaths (also for tests and tools). On bad syntax: everything up to it (as SVG
/// 2, 9.5.4 asks) and a message; `message` is empty when all was well.
struct PathData {
    std::vector<Path> subpaths;
    std::string message;
};
PathData parse_path_data(std::string_view d);

}  // namespace strandline::svg
