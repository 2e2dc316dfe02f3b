// The backward pass. Notation: phi tangent of the rake path, theta heading of the robot, delta = theta - phi,
// k curvature of the rake path, L rake offset, s arc length of the rake, z arc length of the robot.
#include "machine/follow/follow.hpp"

#include <algorithm>
#include <cmath>

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
// Curvatures (1/m), headings (rad) and places (m) nearer than this are one: rounding at the joints of pieces.
constexpr double rounding = 1e-9;

/// A place on the rake path, both sides of a corner apart.
struct Node {
    double s = 0;
    Pose rake;             ///< heading unwrapped along the path
    double curvature = 0;  ///< of the rake path, just after the node; the last node of a piece: just before
    double step = 0;       ///< to the next node; 0: a joint or a corner, the next node is at the same place
    double next_curvature = 0;  ///< at the far end of the step
};

std::vector<Node> nodes_of(const std::vector<Curve>& rake_path, double step) {
    std::vector<Node> nodes;
    double s = 0, heading_before = 0;
    for (const Curve& curve : rake_path) {
        Pose at = curve.start;
        at.heading = nodes.empty() ? at.heading : heading_before + wrap_angle(at.heading - heading_before);
        for (const Clothoid& piece : curve.pieces) {
            if (piece.length <= rounding) continue;
            const double steps = std::max(1.0, std::ceil(piece.length / step - 1e-9));
            const double h = piece.length / steps;
            for (double i = 0; i <= steps; ++i) {
                const double local = i < steps ? i * h : piece.length;
                nodes.push_back({s + local, advanced(at, piece, local),
                                 piece.curvature + piece.sharpness * local, i < steps ? h : 0,
                                 piece.curvature + piece.sharpness * std::min(local + h, piece.length)});
            }
            at = advanced(at, piece, piece.length);
            s += piece.length;
            heading_before = at.heading;
        }
    }
    return nodes;
}

/// delta, and the robot's arc length from here to the place before.
struct Carried {
    double delta, robot_step;
};

/// One step of the rake back over a stretch of length h where its curvature runs from k_here to k_next.
Carried carried_back(double delta, double offset, double h, double k_here, double k_next) {
    const double substeps = std::ceil(h / (stiffest_step * offset));
    if (substeps > most_substeps) {
        const double steady = std::asin(std::clamp(k_here * offset, -1.0, 1.0));
        return {steady, h * std::cos((steady + delta) / 2)};
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
        length -= g / 6 * (std::cos(delta) + 2 * std::cos(d2) + 2 * std::cos(d3) + std::cos(d4));
        delta += g / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return {delta, length};
}

/// A step cut into equal parts, from its end to its start; the step's own end is not among them.
struct Stretch {
    std::vector<Carried> parts;
    double heading_error = 0;  ///< of a robot that takes its curvature as linear between the parts (rad)
};
Stretch stretch_back(double delta, double offset, const Node& here, double count) {
    Stretch stretch;
    const double h = here.step / count, slope = (here.next_curvature - here.curvature) / here.step;
    for (double i = count; i-- > 0;) {
        const double k0 = here.curvature + slope * i * h, k1 = k0 + slope * h;
        const Carried back = carried_back(delta, offset, h, k0, k1);
        const double turned = h * (k0 + k1) / 2 + delta - back.delta;
        const double linear = back.robot_step * (std::tan(delta) + std::tan(back.delta)) / (2 * offset);
        stretch.heading_error += std::abs(turned - linear);
        stretch.parts.push_back(back);
        delta = back.delta;
    }
    return stretch;
}

/// The step in as few parts as keep the heading error small: it falls with the square of their number.
Stretch fine_stretch_back(double delta, double offset, const Node& here) {
    Stretch stretch = stretch_back(delta, offset, here, 1);
    const double allowed = heading_drift * here.step;
    if (here.step > offset || stretch.heading_error <= allowed) return stretch;
    return stretch_back(delta, offset, here,
                        std::min(most_parts, std::ceil(std::sqrt(stretch.heading_error / allowed))));
}

void add_span(std::vector<Followed::Span>& spans, double from, double to) {
    // spans come from the path's end towards its start
    if (!spans.empty() && to >= spans.back().from - rounding)
        spans.back().from = from;
    else
        spans.push_back({from, to});
}

bool same_state(const RobotState& a, const RobotState& b) {
    return a.s == b.s && std::abs(a.pose.heading - b.pose.heading) < rounding &&
           std::abs(a.curvature - b.curvature) < rounding;
}

/// The rake is at the turning point: its path is the robot's.
Followed path_itself(const std::vector<Node>& nodes) {
    Followed result;
    for (const Node& node : nodes) {
        const RobotState state{node.s, node.rake, node.curvature};
        if (!result.path.empty() && same_state(result.path.back(), state)) continue;
        result.path.push_back(state);
        result.rake_s.push_back(node.s);
    }
    return result;
}

}  // namespace

double connectable_delta(const Robot& robot) {
    return robot.min_radius > 0 ? std::atan(robot.rake_offset / robot.min_radius) : pi / 2;
}

double steady_delta(const Robot& robot, double rake_curvature, double most) {
    return std::clamp(std::asin(std::clamp(rake_curvature * robot.rake_offset, -1.0, 1.0)), -most, most);
}

Followed robot_path_for(const std::vector<Curve>& rake_path, const Robot& robot,
                        const FollowOptions& options) {
    const std::vector<Node> nodes = nodes_of(rake_path, options.step);
    const double offset = robot.rake_offset;
    if (nodes.empty()) return {};
    if (offset == 0) return path_itself(nodes);

    Followed result;
    const auto limited = [&](double delta, double from, double to) {
        if (!(std::abs(delta) <= options.max_delta)) {
            add_span(result.undrivable, from, to);
            delta = std::copysign(options.max_delta, delta);
        }
        result.max_delta = std::max(result.max_delta, std::abs(delta));
        return delta;
    };
    const double end = nodes.back().s;
    double delta =
        limited(options.steady_end ? steady_delta(robot, nodes.back().curvature,
                                                  std::min(options.max_delta, connectable_delta(robot)))
                                   : options.end_delta,
                end, end);
    // from the end to the start; `s` of a state is, until the path is turned about, the robot's length from
    // there to the end
    double to_end = 0;
    const auto arrive = [&](double s, Pose rake) {
        result.path.push_back(
            {to_end, robot_at(robot, rake.at, rake.heading + delta), std::tan(delta) / offset});
        result.rake_s.push_back(s);
    };
    arrive(end, nodes.back().rake);
    for (std::size_t i = nodes.size() - 1; i-- > 0;) {
        const Node &here = nodes[i], &next = nodes[i + 1];
        if (here.step == 0) {
            const double before = limited(delta + next.rake.heading - here.rake.heading, here.s, here.s);
            if (std::abs(before - delta) < rounding) continue;
            delta = before;
            arrive(here.s, here.rake);
            continue;
        }
        const Stretch stretch = fine_stretch_back(delta, offset, here);
        const double count = static_cast<double>(stretch.parts.size()), h = here.step / count;
        const Clothoid piece{here.step, here.curvature, (here.next_curvature - here.curvature) / here.step};
        double left = count;
        for (const Carried& part : stretch.parts) {
            const double local = --left * h;
            delta = limited(part.delta, here.s + local, here.s + local + h);
            to_end += part.robot_step;
            arrive(here.s + local, left > 0 ? advanced(here.rake, piece, local) : here.rake);
        }
    }
    std::reverse(result.path.begin(), result.path.end());
    std::reverse(result.rake_s.begin(), result.rake_s.end());
    std::reverse(result.undrivable.begin(), result.undrivable.end());
    for (RobotState& state : result.path) state.s = to_end - state.s;
    return result;
}

}  // namespace strandline
