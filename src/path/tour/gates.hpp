#pragma once
// The rules as masks of pieces: at most 64 of them.
#include <cstdint>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

using Mask = std::uint64_t;
inline Mask bit(int i) { return Mask{1} << i; }

/// What must and must not have been passed before a piece is run one way or the other.
struct Gates {
    struct Way {
        Mask must = 0, must_not = 0;
        int entry_group = -1, exit_group = -1;
        bool open = true;
    };
    std::vector<Way> ways;  ///< 2 * piece + backward
    std::vector<Mask> groups;
    bool any = false;  ///< false: every way is let

    /// last_way: of the piece before, or -1. O(1).
    bool lets(Mask passed, int last_way, int way) const;
};

Gates build_gates(const Model& model);

}  // namespace strandline::tour
