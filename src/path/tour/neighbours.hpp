#pragma once
// A drawing that grows part by part: which elements are finished together.
#include <vector>

#include "path/tour/tour.hpp"

namespace strandline::tour {

/// The elements in parts of neighbours, by halving where they lie widest until a part has no more than
/// 1.5 sqrt(n) of them (4 to 40). Linked elements share a part; parts that would have to be begun twice by
/// `before` are one. Where the problem has groups of its own (all elements, in a kept order) they are cut
/// into parts. In the order of `steps`, as far as `before` allows. O(n log n + parts x rules).
std::vector<std::vector<int>> neighbours(const Problem& problem, const std::vector<Step>& steps);

}  // namespace strandline::tour
