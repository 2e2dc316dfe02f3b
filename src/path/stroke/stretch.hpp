#pragma once
// A drive in pieces that stay the same objects from one plan to the next while they are driven the same way.
#include <memory>
#include <vector>

#include "path/stroke/stroke.hpp"

namespace strandline {

/// Legs end to end: of strokes that are driven in one go, or what is driven between two. The same object
/// means the same legs. Their strokes count from `stroke`.
struct Stretch {
    std::shared_ptr<const std::vector<Leg>> legs;
    int stroke = 0;
};
/// All of their legs, with the strokes of the whole drive. O(states).
std::vector<Leg> legs_of(const std::vector<Stretch>& stretches);

}  // namespace strandline
