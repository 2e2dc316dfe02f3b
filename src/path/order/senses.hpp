#pragma once
// Entries and senses along a fixed order.
#include "path/order/candidates.hpp"

namespace strandline::order {

/// Chooses again, for a fixed order of groups, how each is gone through, so that the sum of Dubins lengths
/// between robot poses and of what is driven rake up within groups is least among the choices. Exact by
/// dynamic programming: O(groups x candidates^2).
std::vector<Going> with_driven_senses(const Job& job, const std::vector<tour::Step>& steps,
                                      const Choices& choices, const Robot& robot);

}  // namespace strandline::order
