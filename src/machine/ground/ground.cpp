#include "machine/ground/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace strandline {
namespace {

constexpr int tile_bits = 6;
static_assert(1 << tile_bits == Ground::tile_size);
constexpr int cells_per_tile = Ground::tile_size * Ground::tile_size;
/// Farther out a cell number would not fit an int with room for tile arithmetic.
constexpr double farthest_cell = 1 << 30;

// Row in the high half, so that sorted keys run by row, then column. The offset keeps negative tiles in
// order.
std::uint64_t key_of(int i, int j) {
    const auto half = [](int cell) { return static_cast<std::uint32_t>(cell >> tile_bits) ^ 0x80000000U; };
    return (static_cast<std::uint64_t>(half(j)) << 32) | half(i);
}
int column_of(std::uint64_t key) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(key) ^ 0x80000000U);
}
int row_of(std::uint64_t key) { return column_of(key >> 32); }
std::size_t place_in_tile(int i, int j) {
    constexpr int mask = Ground::tile_size - 1;
    return static_cast<std::size_t>((j & mask) * Ground::tile_size + (i & mask));
}

}  // namespace

Ground::Ground(double cell_size) : cell_(cell_size) {}

int Ground::index(double coordinate) const {
    return static_cast<int>(std::clamp(std::floor(coordinate / cell_), -farthest_cell, farthest_cell));
}

Cell& Ground::at(int i, int j) {
    const std::uint64_t key = key_of(i, j);
    if (latest_ == nullptr || key != latest_key_) {
        std::unique_ptr<Cell[]>& tile = tiles_[key];
        if (!tile) tile = std::make_unique<Cell[]>(cells_per_tile);
        latest_key_ = key;
        latest_ = tile.get();
    }
    return latest_[place_in_tile(i, j)];
}

const Cell* Ground::find(int i, int j) const {
    const auto tile = tiles_.find(key_of(i, j));
    return tile == tiles_.end() ? nullptr : &tile->second[place_in_tile(i, j)];
}

void Ground::visit(const std::function<void(int, int, const Cell&)>& what) const {
    std::vector<std::pair<std::uint64_t, const Cell*>> sorted;
    sorted.reserve(tiles_.size());
    for (const auto& [key, tile] : tiles_) sorted.emplace_back(key, tile.get());
    std::ranges::sort(sorted, {}, &std::pair<std::uint64_t, const Cell*>::first);
    for (auto first = sorted.begin(); first != sorted.end();) {
        const int row = row_of(first->first);
        const auto last =
            std::find_if(first, sorted.end(), [&](const auto& t) { return row_of(t.first) != row; });
        for (int j = 0; j < tile_size; ++j)
            for (auto tile = first; tile != last; ++tile)
                for (int i = 0; i < tile_size; ++i)
                    what(column_of(tile->first) * tile_size + i, row * tile_size + j,
                         tile->second[j * tile_size + i]);
        first = last;
    }
}

CellRun rows_in(const Ground& ground, std::span<const Point> convex) {
    if (convex.size() < 3) return {0, 0};
    double low = convex.front().y, high = low;
    for (Point p : convex) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    return {ground.first_from(low), ground.first_from(high)};
}

CellRun row_in(const Ground& ground, std::span<const Point> convex, int j) {
    const double y = (j + 0.5) * ground.cell_size();
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
    return {ground.first_from(left), ground.first_from(right)};
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
