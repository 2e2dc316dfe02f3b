#pragma once
// Private to the room: which strokes of a fill must wait for which.
#include <utility>
#include <vector>

#include "path/fill/fill.hpp"

namespace strandline::fill {

/// Pairs of strokes, the first raked before the second: those whose swaths meet, in the order given, and
/// every one before the last. Ascending. Among the others any order rakes the same. O(length / width).
std::vector<std::pair<int, int>> precedence(const std::vector<Stroke>& strokes, double width);

}  // namespace strandline::fill
