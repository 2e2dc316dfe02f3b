#pragma once
// The shortest path through every stop, by dynamic programming over sets from coarse to fine.
#include <cstdint>
#include <optional>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "path/tour/bound.hpp"
#include "path/tour/gates.hpp"
#include "path/tour/model.hpp"

namespace strandline::tour {

/// What proofs may cost, counted in legs looked at; runs share it.
struct Work {
    std::uint64_t left;
    bool spent = false;
};

/// The shortest path of the route, if it is more than `slack` shorter than `upper`, which it lowers; empty
/// when there is none, or when the work was spent. `lead_way`: 2 * piece + backward of a piece passed
/// already, or -1.
///
/// States are (set passed, way of the last stop) (Bellman; Held and Karp, both 1962). The vertices of a
/// polygon are first one way, left wherever it suits: a relaxation whose states are few, cut by spanning
/// trees. Its costs from the start bound, state by state, a second programme from the end backwards over arcs
/// of vertices, whose costs bound a third over shorter arcs from the start, and so on down to single vertices
/// (coarse to fine: Raphael, IEEE PAMI 23(12), 2001). O(2^stops) in the worst case, so the work is limited.
std::vector<Visit> shortest(const Gates& gates, Route route, int lead_way, double& upper, double slack,
                            Work& work, const Progress& progress);

}  // namespace strandline::tour
