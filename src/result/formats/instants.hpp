#pragma once
// Instants between samples, for texts that want points closer together than the plan has them.
#include <vector>

#include "machine/follow/follow.hpp"

namespace strandline::formats {

/// The pose of P and where the rake is at one instant.
struct Instant {
    Pose pose;
    Point rake;
};
/// Instants strictly between two neighbouring samples, `parts` - 1 of them: P on the cubic Hermite piece
/// through both poses; a turn on the spot in equal angles. Empty for parts <= 1.
std::vector<Instant> instants_between(const Robot& robot, const Sample& a, const Sample& b, double parts);
/// How far the farther of P and the rake goes in a straight line between the two.
double farthest_move(const Sample& a, const Sample& b);

}  // namespace strandline::formats
