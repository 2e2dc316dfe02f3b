#include "path/connect/connect.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::connect {
namespace {

/// A curvature is above the limit when it is so by more than this share.
constexpr double rounding = 1e-9;

Connection straight_with_turns(Pose from, Pose to) {
    const double d = distance(from.at, to.at);
    if (d == 0) return {wrap_angle(to.heading - from.heading), 0, {to, {}}};
    const double direction = heading(to.at - from.at);
    return {wrap_angle(direction - from.heading), wrap_angle(to.heading - direction),
            straight({from.at, direction}, d)};
}

}  // namespace

Connection connection(const CurvatureState& from, const CurvatureState& to, const Options& options) {
    const double radius = options.limits.radius;
    const bool too_tight = std::max(std::abs(from.curvature), std::abs(to.curvature)) * radius > 1 + rounding;
    if (options.style == Style::straight || radius <= 0 || (options.pivot && too_tight))
        return straight_with_turns(from.pose, to.pose);
    Connection bounded{0, 0, continuous_curvature(from, to, options.limits)};
    if (!options.pivot) return bounded;
    Connection turning = straight_with_turns(from.pose, to.pose);
    const double turns = std::abs(turning.turn_before) + std::abs(turning.turn_after);
    return length(turning.curve) + options.turn_cost * turns < length(bounded.curve) ? turning : bounded;
}

CurveLimits limits_of(const Robot& robot) { return {robot.min_radius, robot.sharpness}; }

}  // namespace strandline::connect
