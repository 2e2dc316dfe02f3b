#include "math/raster/raster.hpp"

#include <cmath>

namespace strandline {
namespace {

constexpr double most_cells = 8e6;  // some 100 MB of account, a second of work

struct Crossed {
    int row;
    double x;
};

}  // namespace

Raster raster_over(Box box, double cell) {
    const double width = std::max(box.width(), cell), height = std::max(box.height(), cell);
    const double least =
        std::max(std::sqrt(width * height / most_cells), std::max(width, height) / most_cells);
    Raster raster{box.low, std::max(cell, least), 0, 0};
    raster.columns = static_cast<int>(width / raster.cell) + 1;
    raster.rows = static_cast<int>(height / raster.cell) + 1;
    return raster;
}

std::vector<Run> runs_inside(const Raster& raster, const Regions& regions) {
    std::vector<Crossed> crossed;
    const auto add = [&](const Polygon& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point a = raster.in_cells(ring[i]), b = raster.in_cells(ring[(i + 1) % ring.size()]);
            if (a.y > b.y) std::swap(a, b);
            const int end = ceiled(b.y, raster.rows);
            for (int row = ceiled(a.y, raster.rows); row < end; ++row)
                crossed.push_back({row, a.x + (b.x - a.x) * (row - a.y) / (b.y - a.y)});
        }
    };
    for (const Region& region : regions) {
        add(region.outer);
        for (const Polygon& hole : region.holes) add(hole);
    }
    // By row (counted), then by place.
    std::vector<std::size_t> starts(static_cast<std::size_t>(raster.rows) + 1, 0);
    for (const Crossed& c : crossed) ++starts[static_cast<std::size_t>(c.row) + 1];
    for (std::size_t row = 1; row < starts.size(); ++row) starts[row] += starts[row - 1];
    std::vector<double> places(crossed.size());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (const Crossed& c : crossed) places[next[static_cast<std::size_t>(c.row)]++] = c.x;
    std::vector<Run> runs;
    for (int row = 0; row < raster.rows; ++row) {
        const auto begin =
            places.begin() + static_cast<std::ptrdiff_t>(starts[static_cast<std::size_t>(row)]);
        const auto end =
            places.begin() + static_cast<std::ptrdiff_t>(starts[static_cast<std::size_t>(row) + 1]);
        std::sort(begin, end);
        for (auto x = begin; x != end && x + 1 != end; x += 2) {
            const Run run{row, ceiled(*x, raster.columns), ceiled(*(x + 1), raster.columns)};
            if (run.first < run.end) runs.push_back(run);
        }
    }
    return runs;
}

}  // namespace strandline
