#pragma once
// Private to the room: an order, driven.
#include "path/order/pairs.hpp"

namespace strandline::order {

struct Draft {
    Ordered ordered;  ///< all but the tour
    double cost = 0;  ///< metres: what lies between groups, turns, blemishes, and what variants are longer
};
/// Drives groups in this order: strokes that nearly touch as one, connections between. With `pairs`: round
/// what is finished, and they learn what was driven from candidate to candidate of `row`.
Draft drafted(const Job& job, const std::vector<Going>& goings, const Robot& robot, const Options& options,
              Pairs* pairs, const std::vector<int>& row, const Progress& progress);

/// The draft that no other order, found by annealing on what was driven, is cheaper than.
Draft searched(const Job& job, const std::vector<Going>& goings, const Robot& robot, const Options& options,
               const Progress& progress);

}  // namespace strandline::order
