#pragma once
// Assembly: what is good in one tour is built into another.
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "path/tour/descent.hpp"

namespace strandline::tour {

/// How often circles were tried and gained nothing, by a number of their links: not tried for ever.
using Vain = std::unordered_map<std::uint64_t, int>;

/// Where another tour's links and choices differ from ours, they form circles of links that alternate between
/// the two; as every node has one link, the circles are unique and have no node in common. Each circle is
/// tried by itself, in random order: its links are put in, rings that this leaves are joined again where that
/// costs least, and the tour descends from there; what gains stays. (Edge assembly crossover, Nagata and
/// Kobayashi, INFORMS Journal on Computing 25, 2013, single circles.) Returns the gain. O(circle + smaller
/// rings) a circle and the nodes moved.
double absorb(Search& search, Descent& descent, const Sequence& other, Vain& vain);

}  // namespace strandline::tour
