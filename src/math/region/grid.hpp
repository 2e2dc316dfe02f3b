#pragma once
// Private to the room: metres <-> the integers that Clipper works on.
#include <polyclipping/clipper.hpp>

#include "math/region/region.hpp"

namespace strandline::grid {

/// Integer = (metre - origin) x scale. The scale is a power of two and the origin a multiple of the grid's
/// step, so numbers that are short in binary survive exactly, and a coarser grid's points lie on every finer
/// one.
struct Grid {
    Point origin;
    double scale = 1;
};
/// A grid that holds the box: coordinates stay below 2^30, where Clipper multiplies in 64 bits; beyond that
/// it needs 128 and is 2-3 times slower.
Grid fitted_to(Box box);

ClipperLib::Path on(const Grid& grid, const std::vector<Point>& points);
void add(ClipperLib::Paths& paths, const Grid& grid, const Regions& regions);
Regions regions_of(const ClipperLib::PolyTree& tree, const Grid& grid);

}  // namespace strandline::grid
