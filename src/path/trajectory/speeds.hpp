#pragma once
// Speeds along a row of states between two stands.
#include <vector>

#include "machine/robot/robot.hpp"

namespace strandline::trajectory {

/// What bounds u = v^2 on one interval: k is the larger |curvature| of its ends, dk its slope.
struct Interval {
    double length, k, dk, limit;
};
Interval interval_of(double length, double curvature, double next_curvature, double limit);
/// Largest u that is allowed anywhere on the interval: speed, turn rate, and turn acceleration at constant
/// speed.
double cap(const Interval& at, const Robot& robot);
/// Largest u at the far end of an interval that began with `from`: acceleration, and what turning leaves of
/// the turn acceleration when taken at the far end (the faster one): k a <= alpha - dk u.
double reached(double from, const Interval& at, const Robot& robot);

/// States of one go from stand to stand: arc length and curvature at each, the speed limit on each interval
/// (n - 1).
struct Course {
    std::vector<double> s, curvature, limit;
};
/// Speed at each state: 0 at both ends, the largest within the robot's limits between. Equal s are not
/// allowed. O(n).
std::vector<double> speeds_along(const Course& run, const Robot& robot);

}  // namespace strandline::trajectory
