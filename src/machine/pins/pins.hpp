#pragma once
// Pins that take time: what they are told, and what they do. A plan's masks say what the pins do; a machine
// whose pins move `lift_delay` after the command is told so much earlier, which is delay x speed before the
// place.
#include <vector>

#include "machine/follow/follow.hpp"
#include "machine/robot/robot.hpp"

namespace strandline::pins {

/// The drive at time t between two neighbouring samples: speed, or the rate of a turn on the spot, is linear
/// in time, position and heading are cubic Hermite. What holds from `a` on holds there too.
Sample between(const Robot& robot, const Sample& a, const Sample& b, double t);

/// The same drive with the masks that the pins are told: each change `lift_delay` earlier, with a sample of
/// its own where none is. Changes before the start are told at the start. O(samples).
std::vector<Sample> told(const Robot& robot, const std::vector<Sample>& done);
/// The opposite: what pins do that are told the masks of the samples. Changes after the end are lost.
std::vector<Sample> done(const Robot& robot, const std::vector<Sample>& told);

/// Neighbouring pins that are down: they rake from `left` to `right` of the rake's centre, metres, left
/// positive.
struct Comb {
    double left, right;
};
/// Of a mask, from left to right; its highest bit is the leftmost pin. O(pins).
std::vector<Comb> combs_of(const Robot& robot, unsigned mask);

}  // namespace strandline::pins
