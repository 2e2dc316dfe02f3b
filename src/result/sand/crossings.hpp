#pragma once
// The lines already drawn, so that a move can be asked which of them it crosses.
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "math/geometry/geometry.hpp"

namespace strandline::sand {

/// A piece of a line's rake path, rake down.
struct DrawnPiece {
    Point from, to;
    int element = -1;
};
struct LineCrossing {
    Point at;
    int element = -1;
};

/// Pieces by squares of a grid. Pieces and moves are short (a sample's step), so each meets a few squares:
/// O(1) typical.
class DrawnLines {
  public:
    void add(const DrawnPiece& piece);
    /// Crossings of the half-open segment [a, b) with half-open pieces, in the order in which the pieces were
    /// drawn: a path through a joint of two pieces crosses once.
    std::vector<LineCrossing> crossed(Point a, Point b) const;

  private:
    std::vector<DrawnPiece> pieces_;
    std::unordered_map<std::uint64_t, std::vector<int>> squares_;
};

}  // namespace strandline::sand
