#pragma once
// What people changed, and what encloses what -> constraints on the order.
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Lines drawn by hand put in, what was asked of single elements put over their hints, erased elements taken
/// out. Edits whose element is gone, and hints that the
/// robot cannot obey, are returned as sentences and change nothing. O(elements x edits).
std::vector<std::string> apply_to_drawing(Drawing& drawing, const std::vector<Edit>& edits,
                                          const Robot& robot);
/// The other edits put into the job: of the order, of connections, entries and directions. Those whose
/// element or node is gone are returned as sentences and change nothing.
std::vector<std::string> apply_edits(order::Job& job, const std::vector<Edit>& edits);
/// Each element before the smallest one that encloses it.
std::vector<std::pair<int, int>> inner_before_outer(const std::vector<order::Group>& groups,
                                                    const Drawing& drawing);

/// Batches come one after the other: what should come first across them is out of the job's hands.
void keep_within_batches(order::Job& job);

}  // namespace strandline::pipeline
