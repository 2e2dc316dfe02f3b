#pragma once
// Entries and senses along a fixed order.
#include "path/order/order.hpp"

namespace strandline::order {

/// How a group is gone through.
struct Going {
    tour::Step step;
    int variant = -1;  ///< of the group's; -1: its own strokes
    bool operator==(const Going&) const = default;
};
/// Chooses again, for a fixed order of groups, at which node and in which sense each is entered, so that the
/// sum of Dubins lengths between robot poses and of what variants are longer is least among the candidates
/// (both directions of open lines, at most `most_candidates` nodes of closed ones in both senses, all
/// variants). Fixed entries, directions, senses and ties are kept. The poses are those of a robot straight in
/// line with the rake path's end. Exact by dynamic programming: O(groups x candidates^2).
std::vector<Going> with_driven_senses(const Job& job, const std::vector<tour::Step>& steps,
                                      const Robot& robot);

}  // namespace strandline::order
