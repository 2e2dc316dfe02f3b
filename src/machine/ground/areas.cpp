// Regions as cells, and cells in pieces.
#include <algorithm>
#include <numeric>

#include "machine/ground/ground.hpp"

namespace strandline {

std::vector<RowRun> runs_in(const Grid& grid, const Region& region, Box within) {
    struct Edge {
        Point low, high;
    };
    std::vector<Edge> edges;
    const auto add = [&](const Polygon& outline) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Point a = outline[k], b = outline[k + 1 == outline.size() ? 0 : k + 1];
            if (a.y != b.y) edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
        }
    };
    add(region.outer);
    for (const Polygon& hole : region.holes) add(hole);
    std::ranges::sort(edges, {}, [](const Edge& e) { return e.low.y; });
    const Box box = bounds(region);
    const double low = std::max(box.low.y, within.low.y), high = std::min(box.high.y, within.high.y);
    const double cell = grid.cell_size();
    std::vector<RowRun> runs;
    std::vector<Edge> active;
    std::vector<double> cuts;
    auto next = edges.begin();
    for (int row = grid.first_from(low), end = grid.first_from(high); row < end; ++row) {
        const double y = (row + 0.5) * cell;
        for (; next != edges.end() && next->low.y <= y; ++next) active.push_back(*next);
        std::erase_if(active, [&](const Edge& e) { return e.high.y <= y; });
        cuts.clear();
        for (const Edge& e : active)
            cuts.push_back(e.low.x + (e.high.x - e.low.x) * ((y - e.low.y) / (e.high.y - e.low.y)));
        std::ranges::sort(cuts);
        for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
            const int first = grid.first_from(cuts[k]), last = grid.first_from(cuts[k + 1]);
            if (first < last) runs.push_back({row, first, last});
        }
    }
    return runs;
}

std::vector<Patch> patches(const Grid& grid, const std::vector<RowRun>& runs) {
    std::vector<std::size_t> above(runs.size());  // union-find: the first run of a piece is its root
    std::iota(above.begin(), above.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (above[i] != i) i = above[i] = above[above[i]];
        return i;
    };
    for (std::size_t i = 0, below = 0; i < runs.size(); ++i) {
        const auto before = [&](const RowRun& run) {
            return run.row < runs[i].row - 1 || (run.row == runs[i].row - 1 && run.end <= runs[i].first);
        };
        while (before(runs[below])) ++below;
        for (std::size_t k = below; runs[k].row < runs[i].row && runs[k].first < runs[i].end; ++k) {
            const std::size_t a = root(i), b = root(k);
            above[std::max(a, b)] = std::min(a, b);
        }
    }
    struct Piece {
        int cells = 0, last_row = 0;
        RowRun longest;
    };
    std::vector<Piece> pieces(runs.size());
    const auto cells_of = [](const RowRun& run) { return run.end - run.first; };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Piece& piece = pieces[root(i)];
        if (piece.cells == 0 || cells_of(runs[i]) > cells_of(piece.longest)) piece.longest = runs[i];
        piece.cells += cells_of(runs[i]);
        piece.last_row = runs[i].row;
    }
    const double cell = grid.cell_size();
    std::vector<Patch> list;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto& [cells, last_row, longest] = pieces[i];
        if (cells == 0) continue;
        list.push_back({grid.centre((longest.first + longest.end) / 2, longest.row), cells * cell * cell,
                        cells_of(longest) * cell, (last_row - runs[i].row + 1) * cell});
    }
    return list;
}

}  // namespace strandline
