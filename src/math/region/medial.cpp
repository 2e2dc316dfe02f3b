// The medial axis, from the Voronoi diagram of the outline's edges (Fortune's sweep, by Boost.Polygon).
#include <algorithm>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <unordered_map>

#include "math/region/exact.hpp"
#include "math/region/grid.hpp"

namespace strandline {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using GridPoint = boost::polygon::point_data<int>;
using GridSegment = boost::polygon::segment_data<int>;

/// Edges at most `step` apart on curved pieces: a cell's edge between a point and a segment is a parabola.
std::vector<Point> bent(Point focus, Point a, Point b, Point from, Point to, double step) {
    const Point u = normalized(b - a), n = left_normal(u);
    const double height = dot(focus - a, n);
    if (std::abs(height) < 1e-9 * step) return {};
    const double x0 = dot(from - focus, u), x1 = dot(to - focus, u);
    const int parts = static_cast<int>(std::ceil(distance(from, to) / step));
    std::vector<Point> points;
    for (int k = 1; k < parts; ++k) {
        const double x = x0 + (x1 - x0) * k / parts;
        // Equally far from the focus and from the directrix, in the segment's own frame.
        const double y = (x * x + height * height) / (2 * height);
        points.push_back(a + dot(focus - a, u) * u + x * u + y * n);
    }
    return points;
}

bool any_overlaps(const std::vector<Box>& boxes, Box box, double margin) {
    return std::ranges::any_of(boxes, [&](const Box& one) { return overlaps(grown(one, margin), box); });
}

}  // namespace

MedialAxis medial_axis(const Region& region, double step) {
    return medial_axis(region, step, {grown(bounds(region), step)}, 0);
}

MedialAxis medial_axis(const Region& region, double step, const std::vector<Box>& near, double reach) {
    const grid::Grid on_grid = grid::fitted_to(bounds(region));
    std::vector<GridSegment> segments;
    const auto add = [&](const Polygon& ring) {
        const ClipperLib::Path path = grid::on(on_grid, ring);
        for (std::size_t i = 0, j = path.size() - 1; i < path.size(); j = i++)
            if (path[j] != path[i] && any_overlaps(near, including(including({}, ring[j]), ring[i]), reach))
                segments.emplace_back(GridPoint(static_cast<int>(path[j].X), static_cast<int>(path[j].Y)),
                                      GridPoint(static_cast<int>(path[i].X), static_cast<int>(path[i].Y)));
    };
    add(region.outer);
    for (const Polygon& hole : region.holes) add(hole);
    Diagram diagram;
    boost::polygon::voronoi_builder<int, exact::Arithmetic> builder;
    boost::polygon::insert(segments.begin(), segments.end(), &builder);
    builder.construct(&diagram);

    const auto metres = [&](double x, double y) {
        return Point{on_grid.origin.x + x / on_grid.scale, on_grid.origin.y + y / on_grid.scale};
    };
    const auto low = [&](const GridSegment& s) { return metres(s.low().x(), s.low().y()); };
    const auto high = [&](const GridSegment& s) { return metres(s.high().x(), s.high().y()); };
    const auto focus_of = [&](const Diagram::cell_type& cell) {
        const GridSegment& s = segments[cell.source_index()];
        return cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT ? low(s)
                                                                                             : high(s);
    };
    const auto radius_at = [&](const Diagram::edge_type& edge, Point p) {
        const Diagram::cell_type& cell = *edge.cell();
        const GridSegment& s = segments[cell.source_index()];
        return cell.contains_point() ? distance(focus_of(cell), p) : distance_to_segment(p, low(s), high(s));
    };

    const AreaIndex inside({region});
    const Box whole = grown(bounds(region), step);
    MedialAxis axis;
    std::unordered_map<const Diagram::vertex_type*, int> numbers;
    const auto number = [&](const Diagram::vertex_type* v, const Diagram::edge_type& edge) {
        const auto [at, fresh] = numbers.emplace(v, static_cast<int>(axis.nodes.size()));
        if (fresh) {
            const Point p = metres(v->x(), v->y());
            axis.nodes.push_back({p, radius_at(edge, p)});
        }
        return at->second;
    };
    for (const Diagram::edge_type& edge : diagram.edges()) {
        if (!edge.is_primary() || !edge.is_finite() || &edge > edge.twin()) continue;
        const Point from = metres(edge.vertex0()->x(), edge.vertex0()->y());
        const Point to = metres(edge.vertex1()->x(), edge.vertex1()->y());
        // Outside the area edges may be as long as the grid is fine.
        if (!contains(whole, from) || !contains(whole, to)) continue;
        if (!any_overlaps(near, including({}, from), 0) && !any_overlaps(near, including({}, to), 0))
            continue;
        std::vector<Point> between_ends;
        if (edge.is_curved()) {
            const bool mine = edge.cell()->contains_point();
            const Diagram::cell_type& point = mine ? *edge.cell() : *edge.twin()->cell();
            const GridSegment& s = segments[(mine ? *edge.twin()->cell() : *edge.cell()).source_index()];
            between_ends = bent(focus_of(point), low(s), high(s), from, to, step);
        }
        const Point middle =
            between_ends.empty() ? between(from, to, 0.5) : between_ends[between_ends.size() / 2];
        if (!inside.contains(middle)) continue;
        int last = number(edge.vertex0(), edge);
        for (Point p : between_ends) {
            axis.nodes.push_back({p, radius_at(edge, p)});
            axis.edges.push_back({last, static_cast<int>(axis.nodes.size()) - 1});
            last = axis.edges.back().to;
        }
        axis.edges.push_back({last, number(edge.vertex1(), edge)});
    }
    return axis;
}

}  // namespace strandline
