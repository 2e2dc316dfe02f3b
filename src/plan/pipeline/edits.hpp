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

}  // namespace strandline::pipeline
