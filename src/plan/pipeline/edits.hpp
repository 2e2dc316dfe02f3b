#pragma once
// What people changed, and what encloses what -> constraints on the order.
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Edits put into the job. Those whose element or node is gone are returned as sentences and change nothing.
std::vector<std::string> apply_edits(order::Job& job, const std::vector<Edit>& edits);
/// Each element before the smallest one that encloses it.
std::vector<std::pair<int, int>> inner_before_outer(const std::vector<order::Group>& groups,
                                                    const Drawing& drawing);

/// Batches come one after the other: what should come first across them is out of the job's hands.
void keep_within_batches(order::Job& job);

}  // namespace strandline::pipeline
