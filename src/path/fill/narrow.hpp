#pragma once
// Private to the room: parts of an area that are narrower than the rake, and the single passes that serve
// them.
#include "path/fill/passes.hpp"
#include "path/fill/trails.hpp"

namespace strandline::fill {

/// A pass along the middle of a part that is narrower than the rake. Its ends rest on something that is raked
/// later, or are free.
struct Arm {
    static constexpr int free = -1;
    Polyline line;  ///< empty: not served
    /// At the line's start and at its end: a body (its number in `Narrow::bodies`), an arm (the number of
    /// bodies and its number), or free.
    int start = free, end = free;
    double least = 0, most = 0;  ///< metres: how wide the part is
    /// Metres left of the line that the rake's middle is driven: half a pitch where pins between the part's
    /// borders are an even number of an odd one, or the other way round.
    double aside = 0;
};
struct NarrowParts {
    Regions bodies;             ///< where the rake's centre fits, coarse: tolerance width/50
    std::vector<bool> crossed;  ///< bodies at bends and crossings of arms, hardly larger than a point
    std::vector<bool> raked;    ///< of those, the ones that the arms rake: their own passes go
    std::vector<Arm> arms;
    Regions bare;  ///< what no disc as wide as the rake reaches: tips and arms
};
/// Nothing when no stretch of the area with sides less than 15 degrees apart is narrower than the rake for a
/// third of its width: corners, however sharp, are none. From the medial axis, so that arms may branch and
/// close. Cost: an inset of the thinned area, and its medial axis if anything is bare.
NarrowParts narrow_parts(const Region& region, const Options& options);

/// Arm::aside of a part along these nodes of the axis: not 0 where pins are lifted one by one and leave less
/// bare, and rake less outside, half a pitch beside the middle. O(nodes).
double aside_of(const Axis& axis, const std::vector<int>& nodes, const Options& options);

/// The passes of the bodies (as a style gives them) and of the arms in one order: seen from the largest body,
/// what is farther comes first, so that arms are raked towards sand that is still to be raked, and the job
/// ends on the largest body's border.
std::vector<Pass> with_arms(std::vector<Pass> passes, const NarrowParts& narrow, const Options& options);

}  // namespace strandline::fill
