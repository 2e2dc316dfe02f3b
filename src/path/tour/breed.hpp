#pragma once
// A problem without parts: one tour, or many that learn from each other.
#include <vector>

#include "path/tour/budget.hpp"
#include "path/tour/near.hpp"
#include "path/tour/sequence.hpp"

namespace strandline::tour {

/// The best order found in the span of the budget, never longer than `first`. Up to a thousand pieces or so:
/// annealed again and again from the best, each result absorbed by all (assembly.hpp). More: many tours, each
/// kicked apart and descended, absorb each other until nothing gains, then annealing from the best. With
/// rules, or where there is time for little: annealed once. O(members x nodes) memory.
std::vector<Visit> bred(const Model& model, const Candidates& near, const std::vector<Visit>& first,
                        std::uint64_t seed, Budget& budget, Span span);

}  // namespace strandline::tour
