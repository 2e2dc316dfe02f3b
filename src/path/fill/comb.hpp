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
/// May combs serve the sand better than rings one within another, that many `levels`, whose `waste` (square
/// metres, bare or raked twice) is known? To be asked before the axis, which costs most: not where rings
/// waste little along the outline, nor, with several rings, between outlines of short edges, where teeth end
/// slanted. Of 175 places in 53 areas it drops 60, none of the 21 that combs win. O(edges).
bool combs_may_pay(const Region& sand, int levels, double waste, double width);

}  // namespace strandline::fill
