#pragma once
// Speeds along a row of states between two stands.
#include <vector>

#include "machine/robot/robot.hpp"

namespace strandline::trajectory {

/// States of one go from stand to stand: arc length and curvature at each, the speed limit on each interval
/// (n - 1).
struct Course {
    std::vector<double> s, curvature, limit;
};
/// Speed at each state: 0 at both ends, the largest within the robot's limits between. Equal s are not
/// allowed. O(n).
std::vector<double> speeds_along(const Course& run, const Robot& robot);

}  // namespace strandline::trajectory
