// Insets, swept areas and simplifying.
#include <algorithm>

#include "math/region/grid.hpp"

namespace strandline {
namespace {

constexpr double arc_share = 500;  // default chord error of arcs: the offset / 500, invisible in sand
constexpr double rounding =
    2.25;  // Clipper rounds the number of chords: one may be 1.5 times as long as asked
constexpr double coarsest_arc = 0.25;  // of the offset: beyond that an arc is no arc

using ClipperLib::ClipperOffset;
using ClipperLib::PolyTree;

double arc_error(double radius, double asked) {
    const double r = std::abs(radius);
    return (asked > 0 ? std::min(asked, coarsest_arc * r) : r / arc_share) / rounding;
}

}  // namespace

Regions inset(const Regions& regions, double by, double arc_tolerance) {
    if (by == 0 || regions.empty()) return regions;
    if (const Box box = bounds(regions); 2 * by >= std::min(box.width(), box.height())) return {};
    const grid::Grid on_grid = grid::fitted_to(grown(bounds(regions), std::max(0.0, -by)));
    ClipperLib::Paths paths;
    grid::add(paths, on_grid, regions);
    ClipperOffset offset(2, arc_error(by, arc_tolerance) * on_grid.scale);
    offset.AddPaths(paths, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    PolyTree tree;
    offset.Execute(tree, -by * on_grid.scale);
    return grid::regions_of(tree, on_grid);
}

Regions simplified(const Regions& regions, double tolerance) {
    if (tolerance <= 0) return regions;
    std::vector<Polygon> outlines;
    for (const Region& region : regions) {
        if (area(region.outer) < tolerance * tolerance) continue;
        outlines.push_back(thinned_outline(region.outer, tolerance));
        for (const Polygon& hole : region.holes)
            if (area(hole) >= tolerance * tolerance) outlines.push_back(thinned_outline(hole, tolerance));
    }
    Regions rest = resolved(outlines, FillRule::nonzero);  // thinning may make outlines touch or cross
    std::erase_if(rest, [&](const Region& region) { return area(region) < tolerance * tolerance; });
    return rest;
}

Regions swept(const std::vector<Polyline>& lines, bool closed, double radius, Cap cap) {
    if (radius <= 0) return {};
    Box box;
    for (const Polyline& line : lines) box = united(box, bounds(line));
    if (box.empty()) return {};
    const grid::Grid on_grid = grid::fitted_to(grown(box, 2 * radius));
    const ClipperLib::EndType end = closed              ? ClipperLib::etClosedLine
                                    : cap == Cap::flat  ? ClipperLib::etOpenButt
                                    : cap == Cap::round ? ClipperLib::etOpenRound
                                                        : ClipperLib::etOpenSquare;
    ClipperOffset offset(2, arc_error(radius, 0) * on_grid.scale);
    for (const Polyline& line : lines)
        if (!line.empty()) offset.AddPath(grid::on(on_grid, line), ClipperLib::jtRound, end);
    PolyTree tree;
    offset.Execute(tree, radius * on_grid.scale);
    return grid::regions_of(tree, on_grid);
}

}  // namespace strandline
