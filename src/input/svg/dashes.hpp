#pragma once
// Private to the room: stroke-dasharray as the lines it leaves.
#include <cstddef>
#include <optional>
#include <vector>

#include "math/curve/curve.hpp"

namespace strandline::svg {

/// Dash, gap, dash ... in the path's units, each >= 0, their sum above 0; an odd count is gone through twice.
struct DashPattern {
    std::vector<double> lengths;
    double offset = 0;  ///< where in the pattern the path starts
    bool dots = false;  ///< dashes of no length are kept, as lines of no length (they show under round caps)
};
/// The dashes of the path, exact, in order along it; over the start of a closed path in one piece. Nothing
/// when they would be more than `most`. SVG 2, 13.5.6.
std::optional<std::vector<Path>> dashed(const Path& path, const DashPattern& pattern, std::size_t most);

}  // namespace strandline::svg
