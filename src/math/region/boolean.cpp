// Boolean operations and cuts: Vatti's sweep as Clipper has it.
#include <algorithm>

#include "math/region/grid.hpp"

namespace strandline {
namespace {

using ClipperLib::Clipper;
using ClipperLib::ClipType;
using ClipperLib::Paths;
using ClipperLib::PolyFillType;
using ClipperLib::PolyTree;

Regions clipped(const Paths& subject, const Paths& clip, ClipType type, PolyFillType rule,
                const grid::Grid& on_grid) {
    Clipper clipper;
    clipper.AddPaths(subject, ClipperLib::ptSubject, true);
    clipper.AddPaths(clip, ClipperLib::ptClip, true);
    PolyTree tree;
    clipper.Execute(type, tree, rule, ClipperLib::pftNonZero);
    return grid::regions_of(tree, on_grid);
}

Regions combined(const Regions& a, const Regions& b, ClipType type) {
    const grid::Grid on_grid = grid::fitted_to(united(bounds(a), bounds(b)));
    Paths subject, clip;
    grid::add(subject, on_grid, a);
    grid::add(clip, on_grid, b);
    return clipped(subject, clip, type, ClipperLib::pftNonZero, on_grid);
}

bool is_finite(const Polygon& polygon) {
    return std::ranges::all_of(polygon, [](Point p) { return strandline::is_finite(p); });
}

Box finite_bounds(const std::vector<Polygon>& outlines) {
    Box box;
    for (const Polygon& outline : outlines)
        if (is_finite(outline)) box = united(box, bounds(outline));
    return box;
}

Paths finite_paths(const std::vector<Polygon>& outlines, const grid::Grid& on_grid) {
    Paths paths;
    for (const Polygon& outline : outlines)
        if (is_finite(outline) && outline.size() >= 3) paths.push_back(grid::on(on_grid, outline));
    return paths;
}

PolyFillType fill_type(FillRule rule) {
    return rule == FillRule::even_odd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
}

}  // namespace

Regions resolved(const std::vector<Polygon>& outlines, FillRule rule) {
    const auto on_grid = grid::fitted_to(finite_bounds(outlines));
    return clipped(finite_paths(outlines, on_grid), {}, ClipperLib::ctUnion, fill_type(rule), on_grid);
}

Regions resolved_within(const std::vector<Polygon>& outlines, FillRule rule, const Regions& area) {
    const auto on_grid = grid::fitted_to(united(finite_bounds(outlines), bounds(area)));
    Paths clip;
    grid::add(clip, on_grid, area);
    return clipped(finite_paths(outlines, on_grid), clip, ClipperLib::ctIntersection, fill_type(rule),
                   on_grid);
}

Regions united(const Regions& a, const Regions& b) { return combined(a, b, ClipperLib::ctUnion); }
Regions intersected(const Regions& a, const Regions& b) { return combined(a, b, ClipperLib::ctIntersection); }
Regions subtracted(const Regions& from, const Regions& what) {
    return combined(from, what, ClipperLib::ctDifference);
}

Halves cut(const Regions& regions, Point a, Point b) {
    const Box box = bounds(regions);
    const Point along = normalized(b - a);
    if (box.empty() || length(along) == 0) return {regions, {}};
    // A square on the left of the line, large enough to hold whatever of the box lies there.
    const Point middle = between(box.low, box.high, 0.5);
    const double reach =
        1.01 * distance(box.low, box.high);  // a little more than any point is from the middle
    const double offset = std::clamp(cross(along, middle - a), -reach, reach);
    const Point foot = middle - offset * left_normal(along), far = 2 * reach * left_normal(along);
    const Polygon left{foot - reach * along, foot + reach * along, foot + reach * along + far,
                       foot - reach * along + far};
    const grid::Grid on_grid = grid::fitted_to(united(box, bounds(left)));
    Paths subject;
    grid::add(subject, on_grid, regions);
    const Paths clip{grid::on(on_grid, left)};
    return {clipped(subject, clip, ClipperLib::ctIntersection, ClipperLib::pftNonZero, on_grid),
            clipped(subject, clip, ClipperLib::ctDifference, ClipperLib::pftNonZero, on_grid)};
}

double area(const Regions& regions) {
    double sum = 0;
    for (const Region& region : regions) sum += area(region);
    return sum;
}

Box bounds(const Regions& regions) {
    Box box;
    for (const Region& region : regions) box = united(box, bounds(region));
    return box;
}

bool contains(const Regions& regions, Point p) {
    return std::ranges::any_of(regions, [&](const Region& region) { return contains(region, p); });
}

Point point_inside(const Region& region) {
    const Box box = bounds(region.outer);
    const double y = (box.low.y + box.high.y) / 2;
    std::vector<double> cuts;
    const auto add = [&](const Polygon& outline) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point a = outline[i], b = outline[i + 1 == outline.size() ? 0 : i + 1];
            if ((a.y > y) != (b.y > y)) cuts.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    };
    add(region.outer);
    for (const Polygon& hole : region.holes) add(hole);
    std::ranges::sort(cuts);
    Point widest{(box.low.x + box.high.x) / 2, y};
    double width = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
        if (cuts[i + 1] - cuts[i] > width) {
            width = cuts[i + 1] - cuts[i];
            widest.x = (cuts[i] + cuts[i + 1]) / 2;
        }
    return widest;
}

}  // namespace strandline
