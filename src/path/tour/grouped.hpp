#pragma once
// Tours whose groups are finished one after another.
#include "path/tour/tour.hpp"

namespace strandline::tour {

/// From steps that keep the problem's groups (every element is in one) to shorter ones that do: in turn,
/// groups as wholes are ordered anew (where their order is free) and each group is ordered anew between its
/// neighbours, until neither gains. Links across groups are not looked at: there must be none. Deterministic
/// for the seed.
std::vector<Step> improve_groups(const Problem& problem, std::vector<Step> steps, std::uint64_t seed,
                                 const Progress& progress);

}  // namespace strandline::tour
