#pragma once
// SVG text -> plain paths with their final paint, in user units of the root, y DOWN as SVG has it. What is
// not understood is a warning with its place; nothing is dropped silently. The contract of the tree that
// comes out is in docs/svg.md.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/curve/curve.hpp"
#include "math/region/region.hpp"

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

/// A data-strandline-NAME attribute of an element or of a group around it.
struct Hint {
    std::string name, value;  ///< the name without data-strandline-
    bool operator==(const Hint&) const = default;
};

/// A layer of Inkscape; in a file that marks none, the outermost named group, which is how other programs
/// write theirs.
struct Layer {
    std::string name, id;
    int parent = -1;      ///< in Document::layers; -1: none
    bool marked = false;  ///< Inkscape's
};

/// One shape element of the file that draws something: it has a fill or a stroke. Every path is in the root's
/// user units with all transforms, dashes and clips applied.
struct Shape {
    /// Unique: the element's id, "path@LINE:COLUMN" without one, "ID@LINE:COLUMN" when taken. Through <use>:
    /// the id of the <use>, and for parts of a group "USE/PART".
    std::string id;
    std::string layer;           ///< names of the Inkscape layers around it, joined by "/"; "" outside
    int layer_index = -1;        ///< the innermost layer in Document::layers; -1: in none
    std::string place;           ///< for messages: "line 12, <path> #eye"
    int line = 0;                ///< in the file, 1-based
    std::vector<Path> subpaths;  ///< at least one, each with at least one segment
    FillRule fill_rule = FillRule::nonzero;
    std::optional<Paint> fill, stroke;
    double stroke_width = 1;  ///< user units of the root: own width x mean scale of the transforms
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
    /// What the stroke follows where it is not the fill's outline: dashes, or what a clip left of it. Use
    /// stroked_paths().
    std::optional<std::vector<Path>> lines = {};
    /// What a clip leaves of the stroke's own area, root user units; absent: all. `lines` are cut to it
    /// already; whoever draws the stroke as wide as it is cuts its sides too.
    std::shared_ptr<const Regions> stroke_clip = {};
    std::vector<Hint> hints = {};  ///< sorted by name; the element's own before those of its groups
};
inline const std::vector<Path>& stroked_paths(const Shape& shape) {
    return shape.lines ? *shape.lines : shape.subpaths;
}

/// The whole file. Shapes are in painting order.
struct Document {
    /// What is visible, user units: viewBox, or 0 0 width height, or the bounds of the shapes. Where the root
    /// asks for slice, the part of the viewBox that shows; under none the units are made square.
    Box view;
    std::optional<Point>
        size_metres;  ///< physical size when width and height have units or px; absent for % or none
    std::vector<Shape> shapes;
    std::vector<Layer> layers;       ///< parents before their children
    std::vector<double> rake_sizes;  ///< root attribute of 2014; empty when absent
    double dpi = 96;                 ///< px to the inch that lengths were read with
    /// Why the physical size may be another than the artist saw; for whoever places the drawing by it.
    std::optional<Warning> size_doubt;
    Warnings warnings;
};

struct Limits {
    std::size_t bytes = 256u << 20;
    int depth = 512;                    ///< nested elements, <use> and clips included
    std::size_t elements = 1'000'000;   ///< in the file
    std::size_t expanded = 1'000'000;   ///< elements drawn once more by <use>, markers and clips
    std::size_t segments = 10'000'000;  ///< of all paths, dashes included
    std::size_t steps = 500'000'000;    ///< comparisons of style rules with elements, about 10 ns each
};

/// A piece of text with one look.
struct TextSpan {
    std::string text;  ///< UTF-8, white space collapsed unless xml:space asks for it
    /// Absolute places and shifts, user units, and turns, degrees, of its first characters; may be empty.
    /// Without x the span goes on where the one before it ended.
    std::vector<double> x, y, dx, dy, rotate;
    std::string family;  ///< as CSS lists them: "Arial, 'DejaVu Sans', sans-serif"; may be empty
    double size = 16;    ///< user units
    int weight = 400;    ///< 100 to 900
    bool italic = false;
    enum class Anchor { start, middle, end } anchor = Anchor::start;
    double letter_spacing = 0;  ///< user units
};
/// A <text> element.
struct Text {
    std::string id, place;
    std::vector<TextSpan> spans;
};
/// The outlines of each span, in the text's own user units (y down); an Error says what is missing, such as a
/// font by name. Called in painting order; the reader places, clips and paints what comes back.
using TextOutliner = std::function<Outcome<std::vector<std::vector<Path>>>(const Text&)>;

struct ReadOptions {
    Limits limits{};
    /// px to the inch, for every unit in the file. 0: 96, or 90 in files of Inkscape before 0.92.
    double dpi = 0;
    TextOutliner text_outlines = {};  ///< absent: text is left out with a warning that names its fonts
};

/// Reads SVG. Error: empty, not XML (with line and column), no <svg> root, over a limit, entity bomb. Numbers
/// that are not finite, or over 1e15, are errors with their place when they are part of geometry. O(bytes),
/// and the elements that <use> draws again.
Outcome<Document> read(std::string_view text, const ReadOptions& options = {}, const Progress& progress = {});

/// The d attribute alone, as subpaths (also for tests and tools). On bad syntax: everything up to it (as SVG
/// 2, 9.5.4 asks) and a message; `message` is empty when all was well.
struct PathData {
    std::vector<Path> subpaths;
    std::string message;
};
PathData parse_path_data(std::string_view d);

/// A Document as SVG text that reads back to the same view, size, paints, hints, layer names and ids; lines
/// and cubics bit for bit, elliptic arcs within rounding (one of more than 3 rad as two). A shape that is
/// filled and whose stroke has lines of its own (dashes, clips) is written as two, the second with "/stroke"
/// behind its id. Warnings, places and stroke_clip are not part of a file. O(segments).
std::string write(const Document& document);

}  // namespace strandline::svg
