#pragma once
// Private to the room: a narrow area raked across, tooth beside tooth, along its middle line.
#include "path/fill/axis.hpp"

namespace strandline::fill {

/// Parallel strokes side by side, all pointing to the left of the middle line; neighbours' ends are at most a
/// width apart, so a vehicle that turns on the spot goes through them to and fro without a hop.
struct Comb {
    Polyline spine;
    std::vector<Polyline> teeth;
};
/// One comb a path of the area's middle line. Teeth reach as far as any of the sand before them does. O(teeth
/// x corners).
std::vector<Comb> combs_of(const Region& area, const std::vector<AxisPath>& paths, const Options& options);

}  // namespace strandline::fill
