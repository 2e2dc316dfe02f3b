#pragma once
// The ground as a tiled raster: for each cell when it was raked and when it was rolled over. Tiles are made
// when first touched, so memory follows the drawing, not the field.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
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

/// A raster with cells of `cell` metres; cell (i, j) covers [i, i+1) x [j, j+1) times `cell`.
class Ground {
  public:
    static constexpr int tile_size = 64;
    explicit Ground(double cell_size);
    double cell_size() const { return cell_; }
    Cell& at(int i, int j);                ///< makes the tile when missing; O(1), cheapest within one tile
    const Cell* find(int i, int j) const;  ///< nullptr where nothing was touched
    std::size_t tiles() const { return tiles_.size(); }  ///< made so far: the memory, for tests of it
    Point centre(int i, int j) const { return {(i + 0.5) * cell_, (j + 0.5) * cell_}; }
    int index(double coordinate) const;  ///< of the cell that holds it; clamped to +-2^30 cells
    /// The first cell whose centre is at or beyond a coordinate: ceil(x / cell - 1/2), clamped as index().
    int first_from(double coordinate) const { return -index(cell_ / 2 - coordinate); }
    /// Every touched tile's cells, in a fixed order (by row, then column).
    void visit(const std::function<void(int, int, const Cell&)>& what) const;

  private:
    double cell_;
    std::unordered_map<std::uint64_t, std::unique_ptr<Cell[]>> tiles_;
    std::uint64_t latest_key_ = 0;  // the tile of the last at(): neighbours mostly share it
    Cell* latest_ = nullptr;
};

/// Cells `first` to before `end` of a row or a column.
struct CellRun {
    int first, end;
};
/// The rows whose centre lines cut the convex polygon, and the cells of row j whose centres lie in it.
CellRun rows_in(const Ground& ground, std::span<const Point> convex);
CellRun row_in(const Ground& ground, std::span<const Point> convex, int j);

/// Calls what(i, j) with each cell whose centre lies in the convex polygon, by row, then column. Polygons
/// that share an edge share no cell: a centre on the edge belongs to the one above it, or to its right.
/// O(rows x corners + cells).
template <class What>
void for_cells_in(const Ground& ground, std::span<const Point> convex, What what) {
    const CellRun rows = rows_in(ground, convex);
    for (int j = rows.first; j < rows.end; ++j) {
        const CellRun row = row_in(ground, convex, j);
        for (int i = row.first; i < row.end; ++i) what(i, j);
    }
}

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
