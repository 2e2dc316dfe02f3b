#pragma once
// A problem without parts: one tour, or many that learn from each other.
#include <vector>

#include "path/tour/budget.hpp"
#include "path/tour/near.hpp"
#include "path/tour/sequence.hpp"

namespace strandline::tour {

/// The best order found in the span of the budget, never longer than `first`. Up to a thousand pieces or so:
/// annealed again and again from the best, each result absorbed by all (assembly.hpp). More: one annealed
/// tour and many that are kicked apart and descended absorb each other until nothing gains; annealing from
/// the best takes what is left. With rules, or where there is room for few members: annealed once. member:
/// share of the budget that one takes, about. O(members x nodes) memory.
std::vector<Visit> bred(const Model& model, const Candidates& near, const std::vector<Visit>& first,
                        std::uint64_t seed, Budget& budget, Span span, double member);

}  // namespace strandline::tour
