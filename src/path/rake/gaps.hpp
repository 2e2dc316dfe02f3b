#pragma once
// Private to the room: distances on the raster of a fill.
#include <span>

#include "math/raster/raster.hpp"
#include "path/rake/rake.hpp"

namespace strandline::rake {

/// The connected pieces (cells that share a side or a corner) of the inside that no pass covers, with their
/// widest discs; those no wider than `least` metres left out. Largest area first. O(bare cells + cells / 64).
std::vector<Gap> gaps_of(const Raster& raster, std::span<const Run> inside,
                         std::span<const std::uint8_t> passes, double least);
/// The largest distance of a covered cell from the inside, in cells.
double farthest_outside(const Raster& raster, std::span<const Run> inside,
                        std::span<const std::uint8_t> passes);

}  // namespace strandline::rake
