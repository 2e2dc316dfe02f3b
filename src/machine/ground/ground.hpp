#pragma once
// The ground as a tiled raster: for each cell when it was raked and when it was rolled over. Tiles are made
// when first touched, so memory follows the drawing, not the field.
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "math/geometry/geometry.hpp"

namespace strandline {

/// One cell's history. Times are any increasing count (metres driven, sample index); `never` until touched.
struct Cell {
    static constexpr float never = -1;
    float first_raked = never, last_raked = never, last_rolled = never;
    std::uint16_t passes = 0;   ///< rakings more than `pass_gap` apart
    std::int32_t element = -1;  ///< element of the last raking
};

/// Where cells are: cell (i, j) covers [i, i+1) x [j, j+1) times `cell` metres.
class Grid {
  public:
    explicit Grid(double cell_size) : cell_(cell_size) {}
    double cell_size() const { return cell_; }
    Point centre(int i, int j) const { return {(i + 0.5) * cell_, (j + 0.5) * cell_}; }
    int index(double coordinate) const;  ///< of the cell that holds it; clamped to +-2^30 cells
    /// The first cell whose centre is at or beyond a coordinate: ceil(x / cell - 1/2), clamped as index().
    int first_from(double coordinate) const { return -index(cell_ / 2 - coordinate); }

  private:
    double cell_;
};

/// A grid whose cells' values live in tiles that are made when first touched. `Tile` is made empty and holds
/// the values of 64 x 64 cells, at place_in_tile.
template <class Tile>
class Tiled : public Grid {
  public:
    static constexpr int tile_bits = 6, tile_size = 1 << tile_bits, cells_per_tile = tile_size * tile_size;
    using Grid::Grid;
    static std::size_t place_in_tile(int i, int j) {
        constexpr int mask = tile_size - 1;
        return static_cast<std::size_t>((j & mask) * tile_size + (i & mask));
    }
    std::size_t tiles() const { return tiles_.size(); }  ///< made so far: the memory, for tests of it
    Tile& tile_at(int i, int j) {  ///< makes it when missing; O(1), cheapest within one tile
        const std::uint64_t key = key_of(i, j);
        if (latest_ == nullptr || key != latest_key_) {
            std::unique_ptr<Tile>& tile = tiles_[key];
            if (!tile) tile = std::make_unique<Tile>();
            latest_key_ = key;
            latest_ = tile.get();
        }
        return *latest_;
    }
    const Tile* find_tile(int i, int j) const {  ///< nullptr where nothing was touched
        const auto tile = tiles_.find(key_of(i, j));
        return tile == tiles_.end() ? nullptr : tile->second.get();
    }
    /// Calls what(i, j, tile, place in the tile) with every touched tile's cells, by row, then column.
    template <class What>
    void visit_cells(What what) const {
        std::vector<std::pair<std::uint64_t, const Tile*>> sorted;
        sorted.reserve(tiles_.size());
        for (const auto& [key, tile] : tiles_) sorted.emplace_back(key, tile.get());
        std::sort(sorted.begin(), sorted.end());
        for (auto first = sorted.begin(); first != sorted.end();) {
            const int row = row_of(first->first);
            const auto last =
                std::find_if(first, sorted.end(), [&](const auto& t) { return row_of(t.first) != row; });
            for (int j = 0; j < tile_size; ++j)
                for (auto tile = first; tile != last; ++tile)
                    for (int i = 0; i < tile_size; ++i)
                        what(column_of(tile->first) * tile_size + i, row * tile_size + j, *tile->second,
                             place_in_tile(i, j));
            first = last;
        }
    }

  private:
    // Row in the high half, so that sorted keys run by row, then column. The offset keeps negative tiles in
    // order.
    static std::uint64_t key_of(int i, int j) {
        const auto half = [](int cell) {
            return static_cast<std::uint32_t>(cell >> tile_bits) ^ 0x80000000U;
        };
        return (static_cast<std::uint64_t>(half(j)) << 32) | half(i);
    }
    static int column_of(std::uint64_t key) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(key) ^ 0x80000000U);
    }
    static int row_of(std::uint64_t key) { return column_of(key >> 32); }

    std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
    std::uint64_t latest_key_ = 0;  // the tile of the last tile_at(): neighbours mostly share it
    Tile* latest_ = nullptr;
};

/// Histories of cells: 20 bytes each.
class Ground : public Tiled<std::array<Cell, 64 * 64>> {
  public:
    using Tiled::Tiled;
    Cell& at(int i, int j) { return tile_at(i, j)[place_in_tile(i, j)]; }
    const Cell* find(int i, int j) const {
        const auto* tile = find_tile(i, j);
        return tile == nullptr ? nullptr : &(*tile)[place_in_tile(i, j)];
    }
    /// Every touched tile's cells, in a fixed order (by row, then column).
    void visit(const std::function<void(int, int, const Cell&)>& what) const;
};

/// Cells `first` to before `end` of a row or a column.
struct CellRun {
    int first, end;
};
/// The rows whose centre lines cut the convex polygon, and the cells of row j whose centres lie in it.
CellRun rows_in(const Grid& grid, std::span<const Point> convex);
CellRun row_in(const Grid& grid, std::span<const Point> convex, int j);

/// Calls what(i, j) with each cell whose centre lies in the convex polygon, by row, then column. Polygons
/// that share an edge share no cell: a centre on the edge belongs to the one above it, or to its right.
/// O(rows x corners + cells).
template <class What>
void for_cells_in(const Grid& grid, std::span<const Point> convex, What what) {
    const CellRun rows = rows_in(grid, convex);
    for (int j = rows.first; j < rows.end; ++j) {
        const CellRun row = row_in(grid, convex, j);
        for (int i = row.first; i < row.end; ++i) what(i, j);
    }
}

/// Cells first .. end - 1 of one row.
struct RowRun {
    int row, first, end;
};
/// The cells whose centres lie in the region, even-odd over all its outlines, between the rows of `within`:
/// by row, then column. O(corners log corners + rows met + runs).
std::vector<RowRun> runs_in(const Grid& grid, const Region& region, Box within);

/// Cells that hang together by edges.
struct Patch {
    Point at;  ///< the middle of its longest row of cells
    double area = 0;
    double width = 0, height = 0;  ///< metres: of its longest row, and of all its rows
};
/// Runs, by row and then by cell, in pieces. O(runs log runs).
std::vector<Patch> patches(const Grid& grid, const std::vector<RowRun>& runs);

/// A convex polygon of at most four corners, counter-clockwise. It lives on the stack: there is one for each
/// wheel and each step of a drive.
struct Bar {
    std::array<Point, 4> corners;
    std::size_t count = 0;
    std::span<const Point> outline() const { return {corners.data(), count}; }
};
/// What a bar sweeps from segment a0-b0 to a1-b1: their convex hull.
Bar swept_bar(Point a0, Point b0, Point a1, Point b1);

}  // namespace strandline
