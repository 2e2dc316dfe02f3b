#pragma once
// Assembly: what is good in one tour is built into another.
#include <vector>

#include "path/tour/descent.hpp"

namespace strandline::tour {

/// Where another tour's links and choices differ from ours, they form circles of links that alternate between
/// the two; as every node has one link, the circles are unique and have no node in common. Each circle is
/// tried by itself, in random order: its links are put in, rings that this leaves are joined again where that
/// costs least, and the tour descends from there; what gains stays. (Edge assembly crossover, Nagata and
/// Kobayashi, INFORMS Journal on Computing 25, 2013, single circles.) Returns the gain. O(circle + smaller
/// rings) a circle and the nodes moved.
double absorb(Search& search, Descent& descent, const Sequence& other);

}  // namespace strandline::tour
