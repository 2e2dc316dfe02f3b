// Bare sand in pieces.
#include <algorithm>
#include <numeric>

#include "result/sand/accounts.hpp"

namespace strandline::sand {

std::vector<Bare> bare_pieces(const std::vector<BareRun>& runs, const Ground& ground, double least,
                              int element) {
    std::vector<std::size_t> above(runs.size());  // union-find: the first run of a piece is its root
    std::iota(above.begin(), above.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (above[i] != i) i = above[i] = above[above[i]];
        return i;
    };
    for (std::size_t i = 0, below = 0; i < runs.size(); ++i) {
        const auto before = [&](const BareRun& run) {
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
        BareRun longest;
    };
    std::vector<Piece> pieces(runs.size());
    const auto cells_of = [](const BareRun& run) { return run.end - run.first; };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Piece& piece = pieces[root(i)];
        if (piece.cells == 0 || cells_of(runs[i]) > cells_of(piece.longest)) piece.longest = runs[i];
        piece.cells += cells_of(runs[i]);
        piece.last_row = runs[i].row;
    }
    const double cell = ground.cell_size();
    std::vector<Bare> bare;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto& [cells, last_row, longest] = pieces[i];
        if (cells == 0 || cells_of(longest) * cell < least || (last_row - runs[i].row + 1) * cell < least)
            continue;
        bare.push_back(
            {ground.centre((longest.first + longest.end) / 2, longest.row), cells * cell * cell, element});
    }
    return bare;
}

}  // namespace strandline::sand
