#pragma once
// Private to the room: points numbered so that near ones have near numbers.
#include <vector>

#include "math/geometry/geometry.hpp"

namespace strandline::tour {

/// Indices of the points in the order in which Hilbert's curve (Math. Ann. 38, 1891) meets them, on a grid of
/// 2^16 x 2^16 cells; within a cell as given. O(n log n).
std::vector<int> along_hilbert_curve(const std::vector<Point>& points);

}  // namespace strandline::tour
