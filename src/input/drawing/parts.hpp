#pragma once
// What make_drawing is put together from; private to this room. User units until `placed`, metres on the
// canvas after it.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/drawing/drawing.hpp"

namespace strandline::drawing_parts {

/// A shape of which something is drawn, or that hides what lies under it.
struct Inked {
    const svg::Shape* shape;
    bool fill = false, stroke = false;              ///< ink
    bool fill_hides = false, stroke_hides = false;  ///< bare paint
    int pins = 0;                                   ///< of the stroke
    bool pinned = false;                            ///< a hint says with how many: it is a line, however wide
    std::vector<svg::Hint> hints = {};
    int section = 0;  ///< of those that pauses part the drawing into
    bool drawn() const { return fill || stroke; }
};

/// A shape that is not drawn: it says where the robot may drive, or must not.
struct Fence {
    const svg::Shape* shape;
    bool border;  ///< else a keep-out
};

/// What of the document is ink, and what hides ink (no ground shows through it; only with occlusion on); bare
/// paint is counted, the start mark (stroke #00ff00) taken out. Order kept.
struct Ink {
    std::vector<Inked> shapes;
    std::vector<Fence> fences;
    std::optional<Point> start;  ///< user units
    int bare = 0, unchosen = 0;
    Warnings warnings;
};
/// Error: a layer that is asked for and is not there, with the names of those that are.
Outcome<Ink> ink_of(const svg::Document& document, const Robot& robot, const DrawingOptions& options);

/// Does this stroke, `scale` metres a user unit, become an area by itself or grow its shape's area?
bool stroke_is_area(const Inked& inked, const Robot& robot, double scale);

/// What rules and file ask for each shape.
class Choices {
  public:
    Choices(const svg::Document& document, const DrawingOptions& options);
    /// False: its layer is not drawn (a name with %, or another was asked for).
    bool chosen(const svg::Shape& shape) const;
    bool applies(const InkRule& rule, const svg::Shape& shape) const;
    /// Sorted by name, each name once.
    std::vector<svg::Hint> hints_of(const svg::Shape& shape) const;
    /// "border" or "keep-out" by the hint field, or by the name of a layer round it; "": it is to be drawn.
    /// Whatever layers are drawn, but for those that are never.
    std::string fence_of(const svg::Shape& shape) const;

  private:
    /// Of the innermost layer outwards.
    std::vector<std::string> layers_of(const svg::Shape& shape) const;
    /// What tells its tool from others: its layer, or the colour of its stroke, or else of its fill.
    std::string tool_key(const svg::Shape& shape) const;
    const svg::Document& document_;
    const DrawingOptions& options_;
    std::vector<std::string> tool_keys_;  ///< in painting order
};
/// A layer that is never drawn: its name begins with %.
bool is_left_out(std::string_view layer);
/// `*` stands for any letters.
bool matches(std::string_view pattern, std::string_view text);

struct Placement {
    Affine to_canvas;
    double scale = 1;
    std::optional<double> scale_denominator;
    Warnings warnings;
};
Outcome<Placement> placed(const svg::Document& document, const std::vector<Inked>& shapes, const Robot& robot,
                          const DrawingOptions& options);

/// What the border and the keep-outs come to on the canvas. Warnings: those that bound no area, a second
/// border.
void place_fences(Drawing& drawing, const std::vector<Fence>& fences, const Placement& placement,
                  double tolerance);

/// A line of a shape, or what is left of it.
struct InkLine {
    std::size_t subpath;
    Path path;
};
/// A shape on the canvas: its lines, and its area with its stroke, one or the other; the area that it hides.
struct Painted {
    const svg::Shape* shape;
    int pins;
    std::vector<svg::Hint> hints = {};  ///< areas of different hints do not become one: the later cuts
    int section = 0;                    ///< nor do those on two sides of a pause
    std::vector<InkLine> lines = {};
    Regions area = {}, hides = {};
};
/// What is seen when each shape is painted over those before it: ink that a later shape hides goes, areas
/// that overlap become one (of the earliest), lines under an area are cut. See docs/drawing.md. O(v log v log
/// n) for n shapes of v corners in all, where most overlap few others.
void occlude(std::vector<Painted>& shapes, double tolerance, DrawingCounts& counts, const Progress& progress);

/// Elements in painting order, ids unique, `inside` not yet known. Warnings: areas whose outlines touch or
/// cross, where the fill rule decides what is inside; the first few by place.
std::vector<Element> elements_of(const std::vector<Inked>& shapes, const Placement& placement,
                                 const Robot& robot, const DrawingOptions& options, DrawingCounts& counts,
                                 Warnings& warnings, const Progress& progress);

/// Lines that are one line or whose ends meet become one; see docs/drawing.md. The element keeps the place
/// and the id of its first piece.
void join_lines(std::vector<Element>& elements, double tolerance, DrawingCounts& counts);
/// Of elements that are the same within the tolerance the first stays, with the most pins of them.
void drop_duplicates(std::vector<Element>& elements, double tolerance, DrawingCounts& counts);
/// The line through fewer of its points, or as smooth curves with corners only where it turns by 60 degrees
/// within the tolerance; either way within the tolerance of its points. O(n log n) typical.
Path simplified(const Path& path, double tolerance);
Path smoothed(const Path& path, double tolerance);
void drop_short(std::vector<Element>& elements, double min_length, DrawingCounts& counts);
/// Sets `inside` of every element.
void find_enclosures(std::vector<Element>& elements, double tolerance);

/// Finds points near a point: cells of the tolerance's size, sorted. Build O(n log n), a visit O(log n +
/// points near).
class NearIndex {
  public:
    NearIndex(const std::vector<Point>& points, double tolerance);
    /// visit(i) for every point i within the tolerance of p, in rising cell order, until it says false.
    template <class Visit>
    void visit_near(Point p, Visit visit) const {
        const Cell middle = cell(p);
        for (long long dx = -1; dx <= 1; ++dx)
            for (long long dy = -1; dy <= 1; ++dy) {
                const Cell wanted{middle.x + dx, middle.y + dy, -1};
                for (auto at = lower(wanted); at != cells_.end() && at->x == wanted.x && at->y == wanted.y;
                     ++at)
                    if (distance(points_[static_cast<std::size_t>(at->point)], p) <= tolerance_ &&
                        !visit(at->point))
                        return;
            }
    }

  private:
    struct Cell {
        long long x, y;
        int point;
        auto operator<=>(const Cell&) const = default;
    };
    Cell cell(Point p) const;
    std::vector<Cell>::const_iterator lower(const Cell& wanted) const;
    std::vector<Point> points_;
    std::vector<Cell> cells_;
    double tolerance_;
};

}  // namespace strandline::drawing_parts
