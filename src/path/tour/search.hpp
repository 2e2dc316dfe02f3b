#pragma once
// The search as a whole: a descent, then what the budget has room for, in parts where the problem is large.
#include <cstdint>
#include <limits>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

struct Searched {
    std::vector<Visit> order;
    std::uint64_t moves = 0;
    bool stopped = false;
};
/// Never longer than `first`; keeps the rules if `first` does. Without one (and without rules) it begins with
/// the greedy order. Deterministic for seed and moves, unless stopped or within a time limit. It also ends,
/// with what it has, when it has read `most_visits` visits to see whether rules are kept. O(n) memory.
Searched improve(const Model& model, const std::vector<Visit>& first, std::uint64_t seed, std::uint64_t moves,
                 const Progress& progress,
                 std::uint64_t most_visits = std::numeric_limits<std::uint64_t>::max());
/// Moves when none are asked for, by the number of pieces.
std::uint64_t default_moves(int pieces);
/// Each candidate of a problem with rules is tried by reading the whole order: so many visits take about half
/// a second.
inline constexpr std::uint64_t default_visits = 40'000'000;

}  // namespace strandline::tour
