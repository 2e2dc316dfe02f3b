#include "machine/ground/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace strandline {
namespace {

/// Farther out a cell number would not fit an int with room for tile arithmetic.
constexpr double farthest_cell = 1 << 30;

}  // namespace

int Grid::index(double coordinate) const {
    return static_cast<int>(std::clamp(std::floor(coordinate / cell_), -farthest_cell, farthest_cell));
}

void Ground::visit(const std::function<void(int, int, const Cell&)>& what) const {
    visit_cells([&](int i, int j, const std::array<Cell, cells_per_tile>& tile, std::size_t place) {
        what(i, j, tile[place]);
    });
}

CellRun rows_in(const Grid& grid, std::span<const Point> convex) {
    if (convex.size() < 3) return {0, 0};
    double low = convex.front().y, high = low;
    for (Point p : convex) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    return {grid.first_from(low), grid.first_from(high)};
}

CellRun row_in(const Grid& grid, std::span<const Point> convex, int j) {
    const double y = (j + 0.5) * grid.cell_size();
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t k = 0; k < convex.size(); ++k) {
        // Always from the lower end, so that neighbours that share the edge compute the same crossing.
        Point a = convex[k], b = convex[k + 1 == convex.size() ? 0 : k + 1];
        if (a.y > b.y) std::swap(a, b);
        if (y < a.y || y >= b.y) continue;
        const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
        left = std::min(left, x);
        right = std::max(right, x);
    }
    if (left > right) return {0, 0};
    return {grid.first_from(left), grid.first_from(right)};
}

Bar swept_bar(Point a0, Point b0, Point a1, Point b1) {
    // Monotone chain (Andrew 1979) on four points.
    std::array<Point, 4> points{a0, b0, a1, b1};
    std::ranges::sort(points, [](Point p, Point q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
    std::array<Point, 8> hull;  // four there, three back
    std::size_t count = 0;
    const auto add = [&](Point p, std::size_t kept) {
        while (count >= kept + 2 && cross(hull[count - 1] - hull[count - 2], p - hull[count - 1]) <= 0)
            --count;
        hull[count++] = p;
    };
    for (Point p : points) add(p, 0);
    const std::size_t lower = count - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
    Bar bar{.corners = {}, .count = std::min(count - 1, bar.corners.size())};
    std::copy_n(hull.begin(), bar.count, bar.corners.begin());
    return bar;
}

}  // namespace strandline
