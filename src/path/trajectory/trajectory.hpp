#pragma once
// Legs -> one trajectory: evenly spaced samples, timed with the robot's speeds and accelerations, with pin
// masks.
#include <vector>

#include "path/stroke/stroke.hpp"

namespace strandline::trajectory {

struct Options {
    double step = 0.02;  ///< metres of robot path between samples, at most
    double dwell = 0.1;  ///< s the robot stands where its curvature jumps (exact corners), to turn its wheels
};

/// Legs end to end, each starting where the one before ended. Equal steps within a leg, joints kept, divided
/// where the robot turns tightly; the robot stands at the start, the end, at turns on the spot and at jumps
/// of curvature. Speed is the largest that keeps speed, turn rate, acceleration and turn acceleration between
/// all samples: one forward and one backward pass over v^2 (after Bobrow, Dubowsky and Gibson, Int. J.
/// Robotics Research 1985, with the turn acceleration split conservatively: |k'| v^2 + |k| |a| <= limit).
/// O(samples). A drive that begins with a stroke first stands for the lift delay, until its pins are down.
std::vector<Sample> timed(const std::vector<Leg>& legs, const std::vector<Stroke>& strokes,
                          const Robot& robot, const Options& options = {});

/// A piece of such a drive as one of its own: from rest to rest, by the same rules. Where it stood or turned
/// on the spot it does so as long. Times begin at 0. O(samples).
std::vector<Sample> retimed(std::vector<Sample> samples, const Robot& robot);

}  // namespace strandline::trajectory
