#pragma once
// The local search: descent over a work queue, then kicks with an undo log.
#include <cstdint>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

struct Searched {
    std::vector<Visit> order;
    std::uint64_t moves = 0;
    bool stopped = false;
};
/// Never longer than `first`; keeps the rules if `first` does. Deterministic for seed and kicks unless
/// stopped.
Searched improve(const Model& model, const std::vector<Visit>& first, std::uint64_t seed, std::uint64_t kicks,
                 const Progress& progress);
/// Kicks when none are asked for, by the number of pieces.
std::uint64_t default_kicks(int pieces);

}  // namespace strandline::tour
