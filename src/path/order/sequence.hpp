#pragma once
// Private to the room: the row of groups, searched on driven metres and blemishes together.
#include <random>

#include "path/order/pairs.hpp"

namespace strandline::order {

/// Candidates (numbers of Pairs) in driving order.
using Row = std::vector<int>;

/// What a row costs: passages by what is finished before them, and what candidates are longer.
double cost_of(const Row& row, const Job& job, Pairs& pairs);

/// Simulated annealing (Kirkpatrick, Gelatt, Vecchi 1983) from `hot` metres down: parts of the row are moved
/// beside a neighbour, or turned about, and groups are gone through another way. What is fixed, tied, ordered
/// or in batches stays so. `work`: passages weighed, at most. Deterministic for the seed. Never worse than
/// the row given.
Row annealed(Row row, const Job& job, Pairs& pairs, double hot, std::uint64_t work, std::uint64_t seed,
             const Progress& progress);

}  // namespace strandline::order
