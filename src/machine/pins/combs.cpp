#include <algorithm>

#include "machine/pins/pins.hpp"

namespace strandline::pins {
namespace {

/// Bits of a mask.
constexpr int most_pins = 32;

}  // namespace

std::vector<Comb> combs_of(const Robot& robot, unsigned mask) {
    std::vector<Comb> combs;
    const double edge = robot.pins * robot.pin_pitch / 2;
    for (int pin = 0; pin < std::min(robot.pins, most_pins); ++pin) {
        if ((mask >> (robot.pins - 1 - pin) & 1U) == 0) continue;
        const double left = edge - pin * robot.pin_pitch, right = left - robot.pin_pitch;
        if (!combs.empty() && combs.back().right <= left + robot.pin_pitch / 2)
            combs.back().right = right;
        else
            combs.push_back({left, right});
    }
    return combs;
}

}  // namespace strandline::pins
