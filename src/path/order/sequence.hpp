#pragma once
// Private to the room: the row of groups, searched on driven metres and blemishes together.
#include <random>

#include "path/order/pairs.hpp"

namespace strandline::order {

/// Candidates (numbers of Pairs) in driving order.
using Row = std::vector<int>;

struct Annealing {
    double hot = 1.5;         ///< metres that a move may cost at first, about
    std::uint64_t work = 0;   ///< passages weighed, at most
    std::uint64_t least = 0;  ///< so many whatever progress says
    std::uint64_t seed = 1;
};
/// A row, and whether progress ended the search.
struct Annealed {
    Row row;
    bool stopped = false;
};
/// Simulated annealing (Kirkpatrick, Gelatt, Vecchi 1983): parts of the row are moved
/// beside a neighbour, or turned about, and groups are gone through another way. What is fixed, tied, ordered
/// or in batches stays so. Deterministic for the seed, unless stopped. Never worse than the row given.
Annealed annealed(Row row, const Job& job, Pairs& pairs, const Annealing& options, const Progress& progress);

}  // namespace strandline::order
