// Uncovered pieces, and how far sand is raked outside.
#include "path/rake/gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace strandline::rake {
namespace {

struct Offset {
    int x = 0, y = 0;
    int squared() const { return x * x + y * y; }
};
struct BareCell {
    int column, row;
    Offset out;  // to the nearest cell that is not bare, as far as is known
    int piece;   // union-find
};

/// Bare cells by row, then column, and where each row's begin.
struct Bare {
    std::vector<BareCell> cells;
    std::vector<std::size_t> rows;
    /// The number of a cell among them, or none. The rows are short: what is bare is little.
    std::optional<std::size_t> find(int column, int row) const {
        if (row < 0 || row + 1 >= std::ssize(rows)) return {};
        const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(rows[static_cast<std::size_t>(row)]);
        const auto end = cells.begin() + static_cast<std::ptrdiff_t>(rows[static_cast<std::size_t>(row) + 1]);
        const auto at = std::lower_bound(begin, end, column,
                                         [](const BareCell& c, int wanted) { return c.column < wanted; });
        if (at == end || at->column != column) return {};
        return static_cast<std::size_t>(at - cells.begin());
    }
};

Bare bare_cells(const Raster& raster, std::span<const Run> inside, std::span<const std::uint8_t> passes) {
    Bare bare;
    bare.rows.assign(static_cast<std::size_t>(raster.rows) + 1, 0);
    for (const Run& run : inside)
        for (int column = run.first; column < run.end; ++column)
            if (passes[raster.index(column, run.row)] == 0) {
                bare.cells.push_back({column, run.row, {}, static_cast<int>(bare.cells.size())});
                ++bare.rows[static_cast<std::size_t>(run.row) + 1];
            }
    std::partial_sum(bare.rows.begin(), bare.rows.end(), bare.rows.begin());
    return bare;
}

/// Vector distance transform of P.-E. Danielsson (Computer Graphics and Image Processing 14, 1980), over the
/// bare cells alone: a neighbour that is not bare is at its own place. Forwards over the neighbours already
/// met, then backwards. Its error is under a tenth of a cell.
void measure(Bare& bare) {
    constexpr std::array<Offset, 4> met{{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    constexpr int far = 1 << 14;
    for (BareCell& cell : bare.cells) cell.out = {far, far};
    const auto look = [&](BareCell& cell, Offset to) {
        const auto other = bare.find(cell.column + to.x, cell.row + to.y);
        Offset out = to;
        if (other) out = {to.x + bare.cells[*other].out.x, to.y + bare.cells[*other].out.y};
        if (out.squared() < cell.out.squared()) cell.out = out;
        return other;
    };
    const auto root = [&](int i) {
        while (bare.cells[static_cast<std::size_t>(i)].piece != i) {
            int& above = bare.cells[static_cast<std::size_t>(i)].piece;
            above = bare.cells[static_cast<std::size_t>(above)].piece;
            i = above;
        }
        return i;
    };
    for (BareCell& cell : bare.cells)
        for (const Offset to : met)
            if (const auto other = look(cell, to)) {
                const int a = root(cell.piece), b = root(static_cast<int>(*other));
                bare.cells[static_cast<std::size_t>(std::max(a, b))].piece = std::min(a, b);
            }
    for (auto cell = bare.cells.rbegin(); cell != bare.cells.rend(); ++cell) {
        for (const Offset to : met) look(*cell, {-to.x, -to.y});
        look(*cell, {-1, 0});
    }
    for (std::size_t i = 0; i < bare.cells.size(); ++i) {
        look(bare.cells[i], {1, 0});
        bare.cells[i].piece = root(static_cast<int>(i));
    }
}

}  // namespace

std::vector<Gap> gaps_of(const Raster& raster, std::span<const Run> inside,
                         std::span<const std::uint8_t> passes, double least) {
    Bare bare = bare_cells(raster, inside, passes);
    measure(bare);
    struct Piece {
        double cells = 0;
        int reach = 0;  // squared
        Offset at;
    };
    std::vector<Piece> pieces(bare.cells.size());
    for (const BareCell& cell : bare.cells) {
        Piece& piece = pieces[static_cast<std::size_t>(cell.piece)];
        ++piece.cells;
        if (cell.out.squared() > piece.reach) {
            piece.reach = cell.out.squared();
            piece.at = {cell.column, cell.row};
        }
    }
    std::vector<Gap> gaps;
    for (const Piece& piece : pieces) {
        // From its centre to that of the first cell that is not bare: half a cell too much each way.
        const double disc = raster.cell * (2 * std::sqrt(static_cast<double>(piece.reach)) - 1);
        if (piece.cells > 0 && disc > least)
            gaps.push_back(
                {raster.in_metres({static_cast<double>(piece.at.x), static_cast<double>(piece.at.y)}),
                 piece.cells * raster.cell * raster.cell, disc});
    }
    std::ranges::stable_sort(gaps, std::greater{}, &Gap::area);
    return gaps;
}

double farthest_outside(const Raster& raster, std::span<const Run> inside,
                        std::span<const std::uint8_t> passes) {
    std::vector<std::size_t> rows(static_cast<std::size_t>(raster.rows) + 1, 0);
    for (const Run& run : inside) ++rows[static_cast<std::size_t>(run.row) + 1];
    std::partial_sum(rows.begin(), rows.end(), rows.begin());
    const auto of_row = [&](int row) {
        const auto i = static_cast<std::size_t>(row);
        return inside.subspan(rows[i], rows[i + 1] - rows[i]);
    };
    const auto away_in_row = [&](int column, int row) {
        const auto runs = of_row(row);
        const auto next = std::ranges::lower_bound(runs, column, std::less_equal{}, &Run::end);
        double away = std::numeric_limits<double>::infinity();
        if (next != runs.end()) away = std::max(0, next->first - column);
        if (next != runs.begin()) away = std::min<double>(away, column - ((next - 1)->end - 1));
        return away;
    };
    if (inside.empty()) return 0;
    double farthest = 0;
    for (int row = 0; row < raster.rows; ++row) {
        int column = 0;
        const auto look_until = [&](int end) {
            for (; column < end; ++column) {
                if (passes[raster.index(column, row)] == 0) continue;
                double nearest = away_in_row(column, row);
                for (int dy = 1; dy < nearest && (row - dy >= 0 || row + dy < raster.rows); ++dy)
                    for (const int other : {row - dy, row + dy})
                        if (other >= 0 && other < raster.rows)
                            nearest = std::min(nearest, std::hypot(away_in_row(column, other), dy));
                farthest = std::max(farthest, nearest);
                // It changes by at most a cell from one to the next: those that stay nearer are passed over.
                column += std::max(0, static_cast<int>(farthest - nearest) - 1);
            }
        };
        for (const Run& run : of_row(row)) {
            look_until(run.first);
            column = run.end;
        }
        look_until(raster.columns);
    }
    return farthest;
}

}  // namespace strandline::rake
