#pragma once
// Areas as cells, and which cells a bar passes over. Everything is
// counted in cells: a place p in metres is (p - low) / cell - 1/2, so that cell (i, j) has its centre at
// (i, j); arc lengths are in cells too.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "math/region/region.hpp"

namespace strandline {

/// Where the cells are: row by row, `columns` a row.
struct Raster {
    Point low;
    double cell = 1;
    int columns = 0, rows = 0;
    Point in_cells(Point p) const { return {(p.x - low.x) / cell - 0.5, (p.y - low.y) / cell - 0.5}; }
    Point in_metres(Point p) const { return {low.x + (p.x + 0.5) * cell, low.y + (p.y + 0.5) * cell}; }
    std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};
/// Over the box, with cells of `cell` metres, or as much larger as keeps them below about eight million.
Raster raster_over(Box box, double cell);

/// Cells first to before end of a row.
struct Run {
    int row = 0, first = 0, end = 0;
};
/// The cells whose centres lie in the area, even-odd; by row, then column. O(edges + rows met + runs).
std::vector<Run> runs_inside(const Raster& raster, const Regions& regions);

/// Numbers that stay on the raster, without a call to the mathematics library for each row.
inline int ceiled(double x, int most) {
    const double within = std::clamp(x, 0.0, static_cast<double>(most));
    const int whole = static_cast<int>(within);
    return whole + (static_cast<double>(whole) < within ? 1 : 0);
}

/// A straight bar drawn along: from `from` along the unit vector `ahead` over `length`; it reaches `left` and
/// `right` of its path (one of them may be negative). In cells.
struct Swath {
    Point from, ahead;
    double length = 0, left = 0, right = 0;
};
/// Calls what(run) with the cells whose centres it passes, its edges included. Their way along the swath is
/// dot(centre - from, ahead). O(rows).
template <class What>
void for_runs_in(const Raster& raster, const Swath& swath, What what) {
    const auto sloped = [](double t) { return std::abs(t) < 1e-12 ? 1e-12 : t; };
    const Point t = swath.ahead;
    const double along = 1 / sloped(t.x), across = -1 / sloped(t.y);
    const double low =
        swath.from.y + std::min(0.0, swath.length * t.y) + std::min(swath.left * t.x, -swath.right * t.x);
    const double high =
        swath.from.y + std::max(0.0, swath.length * t.y) + std::max(swath.left * t.x, -swath.right * t.x);
    const int end = ceiled(high + 1, raster.rows);
    for (int row = ceiled(low - 1e-9, raster.rows); row < end; ++row) {
        const double dy = row - swath.from.y;
        // 0 <= x tx + dy ty <= length and -right <= dy tx - x ty <= left, solved for x.
        const double a = -dy * t.y * along, b = (swath.length - dy * t.y) * along;
        const double c = (-swath.right - dy * t.x) * across, d = (swath.left - dy * t.x) * across;
        const double from = swath.from.x + std::max(std::min(a, b), std::min(c, d));
        const double to = swath.from.x + std::min(std::max(a, b), std::max(c, d));
        if (!(from <= to)) continue;
        const int first = ceiled(from, raster.columns);
        int last = ceiled(to, raster.columns);  // the cell after the last one, or the last one itself
        if (last < raster.columns && static_cast<double>(last) <= to) ++last;
        if (first < last) what(Run{row, first, last});
    }
}

/// Corners in order; convex.
using Quad = std::array<Point, 4>;
/// Calls what(run) with the cells whose centres lie in it, its edges included. In cells. O(rows).
template <class What>
void for_runs_in(const Raster& raster, const Quad& quad, What what) {
    const auto [low, high] = std::ranges::minmax(quad, {}, &Point::y);
    const int end = ceiled(high.y + 1, raster.rows);
    for (int row = ceiled(low.y - 1e-9, raster.rows); row < end; ++row) {
        double from = std::numeric_limits<double>::infinity(), to = -from;
        for (std::size_t i = 0; i < quad.size(); ++i) {
            const Point a = quad[i], b = quad[(i + 1) % quad.size()];
            if (std::max(a.y, b.y) < row || std::min(a.y, b.y) > row) continue;
            const double x = a.y == b.y ? a.x : a.x + (row - a.y) / (b.y - a.y) * (b.x - a.x);
            from = std::min({from, x, a.y == b.y ? b.x : x});
            to = std::max({to, x, a.y == b.y ? b.x : x});
        }
        if (!(from <= to)) continue;
        const int first = ceiled(from, raster.columns);
        int last = ceiled(to, raster.columns);
        if (last < raster.columns && static_cast<double>(last) <= to) ++last;
        if (first < last) what(Run{row, first, last});
    }
}

/// What a bar sweeps that turns about `at` between `inner` and `outer` of it: the points that lie ahead of
/// the bar before the turn and behind the bar after it. In cells.
struct Wedge {
    Point at, before, after;  // unit vectors ahead
    double inner = 0, outer = 0;
};
/// Calls what(run) with the cells whose centres lie in it. O(rows).
template <class What>
void for_runs_in(const Raster& raster, const Wedge& wedge, What what) {
    const int end = ceiled(wedge.at.y + wedge.outer + 1, raster.rows);
    for (int row = ceiled(wedge.at.y - wedge.outer, raster.rows); row < end; ++row) {
        const double dy = row - wedge.at.y;
        const double reach = wedge.outer * wedge.outer - dy * dy;
        if (reach < 0) continue;
        double from = -std::sqrt(reach), to = -from;
        const auto keep = [&](Point normal) {  // of x: dot((x, dy), normal) >= 0
            const double offset = dy * normal.y;
            if (std::abs(normal.x) < 1e-12) {
                if (offset < 0) to = from - 1;
            } else if (normal.x > 0) {
                from = std::max(from, -offset / normal.x);
            } else {
                to = std::min(to, -offset / normal.x);
            }
        };
        keep(wedge.before);
        keep(-wedge.after);
        const double hole = wedge.inner * wedge.inner - dy * dy;
        const double bare = hole > 0 ? std::sqrt(hole) : 0;
        const auto run = [&](double low, double high) {
            if (!(low <= high)) return;
            const int first = ceiled(wedge.at.x + low, raster.columns);
            int last = ceiled(wedge.at.x + high, raster.columns);
            if (last < raster.columns && static_cast<double>(last) <= wedge.at.x + high) ++last;
            if (first < last) what(Run{row, first, last});
        };
        if (bare > 0) {
            run(from, std::min(to, -bare));
            run(std::max(from, bare), to);
        } else {
            run(from, to);
        }
    }
}

}  // namespace strandline
