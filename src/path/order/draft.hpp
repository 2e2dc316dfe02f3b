#pragma once
// Private to the room: an order, driven.
#include "path/order/detours.hpp"
#include "path/order/memory.hpp"

namespace strandline::order {

struct Draft {
    Ordered ordered;       ///< all but the tour
    bool stopped = false;  ///< progress ended the search: not reproducible
    double cost =
        0;  ///< metres: what lies between groups, turns, blemishes, loops, and what variants are longer
    std::vector<Going> goings = {};  ///< the row
};
/// What a search knows and learns: the candidates taken, what was driven between candidates.
struct Search {
    Pairs& pairs;
    Made& made;
    const std::vector<int>& row;
    bool mends = false;  ///< what was connected before is taken as it was
};
/// Drives groups in this order: strokes that nearly touch as one, connections between. Within a search: round
/// what is finished.
Draft drafted(const Job& job, const std::vector<Going>& goings, const Robot& robot, const Options& options,
              const Search* search, Memory::Kept& kept, const Progress& progress);

/// The draft that no other order, found by annealing on what was driven, is cheaper than.
/// `keep_row`: that of these goings, driven once.
Draft searched(const Job& job, const std::vector<Going>& goings, const Choices& choices, const Robot& robot,
               const Options& options, bool keep_row, Memory::Kept& kept, const Progress& progress);

}  // namespace strandline::order
