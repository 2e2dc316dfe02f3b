#pragma once
// How long a search may take: in steps, the same everywhere, or in a share of a time limit.
#include <cstdint>

#include "base/outcome/outcome.hpp"

namespace strandline::tour {

/// A *move*, the unit people give, is about one kick and its repair: so many nodes looked at.
inline constexpr std::uint64_t steps_per_move = 30;

struct Budget {
    const Progress& progress;
    std::uint64_t moves = 0;        ///< allowed, where the progress has no time limit
    std::uint64_t most_visits = 0;  ///< read to see whether rules are kept, at most
    std::uint64_t steps = 0;        ///< nodes looked at
    bool stopped = false;           ///< by the caller

    /// 0 at the beginning, 1 when all is used up.
    double used() const {
        if (progress.time_used) return progress.time_used();
        return static_cast<double>(steps) / static_cast<double>(moves * steps_per_move + 1);
    }
};

/// A part of it: from one share to another.
struct Span {
    double begin = 0, end = 1;
    /// How much of the span is gone, 0 to 1 and beyond.
    double gone(const Budget& budget) const {
        return end > begin ? (budget.used() - begin) / (end - begin) : 1;
    }
    Span part(double from, double to) const {
        return {begin + from * (end - begin), begin + to * (end - begin)};
    }
};

}  // namespace strandline::tour
