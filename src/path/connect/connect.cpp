#include "path/connect/connect.hpp"

namespace strandline::connect {
namespace {

Connection straight_with_turns(Pose from, Pose to) {
    const double d = distance(from.at, to.at);
    if (d == 0) return {wrap_angle(to.heading - from.heading), 0, {to, {}}};
    const double direction = heading(to.at - from.at);
    return {wrap_angle(direction - from.heading), wrap_angle(to.heading - direction),
            straight({from.at, direction}, d)};
}

}  // namespace

Connection connection(const CurvatureState& from, const CurvatureState& to, const Options& options) {
    if (options.style == Style::straight || options.pivot || options.limits.radius <= 0)
        return straight_with_turns(from.pose, to.pose);
    return {0, 0, continuous_curvature(from, to, options.limits)};
}

CurveLimits limits_of(const Robot& robot) { return {robot.min_radius, robot.sharpness}; }

}  // namespace strandline::connect
