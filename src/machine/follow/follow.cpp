// The backward pass. Notation: phi tangent of the rake path, theta heading of the robot, delta = theta - phi,
// k curvature of the rake path, L rake offset, w rake side, s arc length of the rake, z arc length of the
// robot.
#include "machine/follow/follow.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "machine/follow/nodes.hpp"

namespace strandline {
namespace {

// Runge-Kutta 4 on d delta / ds = sin(delta)/L - k errs by about (h/L)^5/120 a step: 3e-6 rad at a fifth.
constexpr double stiffest_step = 0.2;
// Below L = step/60 the transient dies within one step (e^-60): delta is its steady state, and no step would
// be small enough.
constexpr double most_substeps = 300;
// A robot that takes the curvature between states as linear turns wrong by at most this many radians per
// metre of rake.
constexpr double heading_drift = 2e-5;
constexpr double most_parts = 64;
// Radians short of where a robot with its rake beside it would stand: there its curvature has no bound.
constexpr double rolling_margin = 0.02;

/// delta, and the robot's arc length from here to the place before.
struct Carried {
    double delta, robot_step;
};

/// One step of the rake back over a stretch of length h where its curvature runs from k_here to k_next.
Carried carried_back(double delta, const Robot& robot, double h, double k_here, double k_next) {
    const double offset = robot.rake_offset;
    const double substeps = std::ceil(h / (stiffest_step * offset));
    if (substeps > most_substeps) {
        const double steady = std::asin(std::clamp(k_here * offset, -1.0, 1.0));
        return {steady, h * rolled(robot, (steady + delta) / 2)};
    }
    const double g = -h / substeps;
    const auto slope = [&](double s, double d) {
        return std::sin(d) / offset - (k_here + (k_next - k_here) * s / h);
    };
    double s = h, length = 0;
    for (double i = 0; i < substeps; ++i, s += g) {
        const double k1 = slope(s, delta);
        const double d2 = delta + g / 2 * k1, k2 = slope(s + g / 2, d2);
        const double d3 = delta + g / 2 * k2, k3 = slope(s + g / 2, d3);
        const double d4 = delta + g * k3, k4 = slope(s + g, d4);
        length -= g / 6 *
                  (rolled(robot, delta) + 2 * rolled(robot, d2) + 2 * rolled(robot, d3) + rolled(robot, d4));
        delta += g / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return {delta, length};
}

/// A step cut into equal parts, from its end to its start; the step's own end is not among them. Returns the
/// heading error of a robot that takes its curvature as linear between the parts (rad).
double stretch_back(double delta, const Robot& robot, const RakeNode& here, double count,
                    std::vector<Carried>& parts) {
    parts.clear();
    double heading_error = 0, bend = robot_curvature(robot, delta);
    const double h = here.step / count, slope = (here.next_curvature - here.curvature) / here.step;
    for (double i = count; i-- > 0;) {
        const double k0 = here.curvature + slope * i * h, k1 = k0 + slope * h;
        const Carried back = carried_back(delta, robot, h, k0, k1);
        const double turned = h * (k0 + k1) / 2 + delta - back.delta;
        const double bend_before = robot_curvature(robot, back.delta);
        heading_error += std::abs(turned - back.robot_step * (bend + bend_before) / 2);
        parts.push_back(back);
        delta = back.delta;
        bend = bend_before;
    }
    return heading_error;
}

/// The step in as few parts as keep the heading error small: it falls with the square of their number.
void fine_stretch_back(double delta, const Robot& robot, const RakeNode& here, std::vector<Carried>& parts) {
    const double heading_error = stretch_back(delta, robot, here, 1, parts);
    const double allowed = heading_drift * here.step;
    if (here.step > robot.rake_offset || heading_error <= allowed) return;
    const double count = std::min(most_parts, std::ceil(std::sqrt(heading_error / allowed)));
    stretch_back(delta, robot, here, count, parts);
}

bool same_state(const RobotState& a, const RobotState& b) {
    return a.s == b.s && std::abs(a.pose.heading - b.pose.heading) < rounding &&
           std::abs(a.curvature - b.curvature) < rounding;
}

/// The pass: from the end to the start. `s` of a state is, until the path is turned about, the robot's length
/// from it to the end.
struct Pass {
    const std::vector<RakeNode>& nodes;
    const Robot& robot;
    const FollowOptions& options;
    DeltaRange drivable;
    double delta;
    double turns = 0;  ///< whole turns by which the robot's heading has left the rake path's (after straying)
    double to_end = 0;  ///< the robot's length from here to the end
    Followed result = {};
    std::vector<Carried> parts = {};  ///< of the step that is gone back over

    void arrive(double s, Pose rake) {
        result.path.push_back(
            {to_end, robot_at(robot, rake.at, rake.heading + delta + turns), robot_curvature(robot, delta)});
        result.rake_s.push_back(s);
        result.max_delta = std::max(result.max_delta, std::abs(delta));
    }
    /// Where the rake is lost, if it is.
    std::optional<double> over_corner(const RakeNode& before, const RakeNode& after) {
        const double next = delta + after.rake.heading - before.rake.heading;
        if (!drivable.hold(next)) return before.s;
        if (std::abs(next - delta) < rounding) return std::nullopt;
        delta = next;
        arrive(before.s, before.rake);
        return std::nullopt;
    }
    std::optional<double> back_over(const RakeNode& here) {
        fine_stretch_back(delta, robot, here, parts);
        double left = static_cast<double>(parts.size());
        const double h = here.step / left;
        for (const Carried& part : parts) {
            if (!drivable.hold(part.delta)) return here.s + left * h;
            delta = part.delta;
            to_end += part.robot_step;
            const double local = --left * h;
            arrive(here.s + local, left > 0 ? rake_at(here, local) : here.rake);
        }
        return std::nullopt;
    }
    /// Off the path from there until the robot has got the rake back on it; i: the step it is lost in, then
    /// the one it is back in, driven to its start. Where the rake is lost again.
    std::optional<double> go_astray(std::size_t& i, double lost) {
        const WayBack back = stray(nodes, i, lost, robot, options, result, to_end);
        i = back.step;
        if (!back.rejoined) return std::nullopt;
        const Pose rake = rake_at(nodes[i], back.s - nodes[i].s);
        const double heading = result.path.back().pose.heading;
        delta = wrap_angle(heading - rake.heading);
        turns = heading - rake.heading - delta;
        RakeNode part = nodes[i];
        part.step = back.s - part.s;
        part.next_curvature = curvature_at(nodes[i], part.step);
        return part.step > rounding ? back_over(part) : std::nullopt;
    }
    Followed turned_about() {
        std::reverse(result.path.begin(), result.path.end());
        std::reverse(result.rake_s.begin(), result.rake_s.end());
        std::reverse(result.undrivable.begin(), result.undrivable.end());
        for (RobotState& state : result.path) state.s = to_end - state.s;
        return std::move(result);
    }
};

/// The rake is at the turning point: its path is the robot's.
Followed path_itself(const std::vector<RakeNode>& nodes) {
    Followed result;
    for (const RakeNode& node : nodes) {
        const RobotState state{node.s, node.rake, node.curvature};
        if (!result.path.empty() && same_state(result.path.back(), state)) continue;
        result.path.push_back(state);
        result.rake_s.push_back(node.s);
    }
    return result;
}

}  // namespace

double connectable_delta(const Robot& robot, double side) {
    if (robot.min_radius <= 0) return pi / 2;
    const double radius = least_radius(robot, side) - (side > 0 ? robot.rake_side : -robot.rake_side);
    return radius > 0 ? std::atan(robot.rake_offset / radius) : pi / 2;
}

double robot_curvature(const Robot& robot, double delta) {
    return std::tan(delta) / (robot.rake_offset + robot.rake_side * std::tan(delta));
}

double delta_for(const Robot& robot, double robot_curvature) {
    return std::atan(robot_curvature * robot.rake_offset / (1 - robot_curvature * robot.rake_side));
}

DeltaRange drivable_deltas(const Robot& robot, double most) {
    DeltaRange range{-most, most};
    if (robot.rake_side == 0) return range;
    const double standing = std::atan(robot.rake_offset / std::abs(robot.rake_side)) - rolling_margin;
    (robot.rake_side > 0 ? range.low : range.high) =
        robot.rake_side > 0 ? std::max(range.low, -standing) : std::min(range.high, standing);
    return range;
}

double steady_delta(const Robot& robot, double rake_curvature, double most) {
    return std::clamp(std::asin(std::clamp(rake_curvature * robot.rake_offset, -1.0, 1.0)), -most, most);
}

double rolled(const Robot& robot, double delta) {
    return std::cos(delta) + robot.rake_side / robot.rake_offset * std::sin(delta);
}

Followed robot_path_for(const std::vector<Curve>& rake_path, const Robot& robot,
                        const FollowOptions& options) {
    const std::vector<RakeNode> nodes = nodes_of(rake_path, options.step);
    const double offset = robot.rake_offset;
    if (nodes.empty()) return {};
    if (offset == 0) return path_itself(nodes);

    const double end_curvature = nodes.back().curvature;
    const double end = options.steady_end
                           ? steady_delta(robot, end_curvature, connectable_delta(robot, end_curvature))
                           : options.end_delta;
    const DeltaRange drivable = drivable_deltas(robot, options.max_delta);
    Pass pass{nodes, robot, options, drivable, std::clamp(end, drivable.low, drivable.high)};
    if (!drivable.hold(end)) pass.result.undrivable.push_back({nodes.back().s, nodes.back().s});
    pass.result.path.reserve(nodes.size());
    pass.result.rake_s.reserve(nodes.size());
    pass.arrive(nodes.back().s, nodes.back().rake);
    for (std::size_t i = nodes.size() - 1; i > 0;) {
        --i;
        std::optional<double> lost =
            nodes[i].step == 0 ? pass.over_corner(nodes[i], nodes[i + 1]) : pass.back_over(nodes[i]);
        while (lost) lost = pass.go_astray(i, *lost);
    }
    return pass.turned_about();
}

}  // namespace strandline
