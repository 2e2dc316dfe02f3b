#include "path/stroke/stroke.hpp"

namespace strandline {

std::vector<Leg> legs_of(const std::vector<Stretch>& stretches) {
    std::vector<Leg> legs;
    for (const Stretch& stretch : stretches)
        for (const Leg& leg : *stretch.legs) {
            legs.push_back(leg);
            if (leg.stroke >= 0) legs.back().stroke += stretch.stroke;
        }
    return legs;
}

}  // namespace strandline
