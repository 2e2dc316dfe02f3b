// Reading robot paths: states between states, rake and pins.
#include <algorithm>
#include <cmath>

#include "machine/follow/follow.hpp"

namespace strandline {
namespace {

/// Cubic through two values with their slopes per step, at share t.
template <class Value>
Value hermite(const Value& a, const Value& slope_a, const Value& b, const Value& slope_b, double t) {
    const double u = 1 - t;
    return (1 + 2 * t) * u * u * a + t * u * u * slope_a + t * t * (3 - 2 * t) * b - t * t * u * slope_b;
}

}  // namespace

Point rake_at(const Robot& robot, Pose robot_pose) {
    const Point ahead = unit(robot_pose.heading);
    return robot_pose.at - robot.rake_offset * ahead + robot.rake_side * left_normal(ahead);
}

Pose robot_at(const Robot& robot, Point rake, double robot_heading) {
    const Point ahead = unit(robot_heading);
    return {rake + robot.rake_offset * ahead - robot.rake_side * left_normal(ahead), robot_heading};
}

Point drawn_at(const Robot& robot, const Sample& sample, unsigned mask) {
    const double aside = middle_of(robot, mask);
    return aside == 0 ? sample.rake : sample.rake + aside * left_normal(unit(sample.pose.heading));
}

double length(const RobotPath& path) { return path.empty() ? 0 : path.back().s - path.front().s; }

RobotState state_at(const RobotPath& path, double s) {
    if (path.empty()) return {};
    const auto after = std::upper_bound(path.begin(), path.end(), s,
                                        [](double v, const RobotState& state) { return v < state.s; });
    if (after == path.begin()) return path.front();
    if (after == path.end()) return path.back();
    const RobotState &a = *(after - 1), &b = *after;
    const double h = b.s - a.s, t = (s - a.s) / h;
    const bool back = dot(b.pose.at - a.pose.at, unit((a.pose.heading + b.pose.heading) / 2)) < 0;
    const double way = back ? -h : h;
    return {s,
            {hermite(a.pose.at, way * unit(a.pose.heading), b.pose.at, way * unit(b.pose.heading), t),
             hermite(a.pose.heading, way * a.curvature, b.pose.heading, way * b.curvature, t)},
            a.curvature + t * (b.curvature - a.curvature)};
}

RobotPath states_along(const Curve& curve, double step) {
    RobotPath path;
    double s = 0;
    bool back = false;
    Pose at = curve.start;
    for (const Clothoid& piece : curve.pieces) {
        if (piece.length == 0) continue;
        const double far = std::abs(piece.length), steps = std::max(1.0, std::ceil(far / step - 1e-9));
        // the joint is there already, unless curvature jumps or the robot turns back
        const bool jump = !path.empty() && (path.back().curvature != piece.curvature || backs(piece) != back);
        back = backs(piece);
        for (double i = path.empty() || jump ? 0 : 1; i <= steps; ++i) {
            const double local = i / steps * piece.length;
            path.push_back(
                {s + std::abs(local), advanced(at, piece, local), piece.curvature + piece.sharpness * local});
        }
        at = advanced(at, piece, piece.length);
        s += far;
    }
    if (path.empty()) path.push_back({0, curve.start, 0});
    return path;
}

bool backs(const Sample& from, const Sample& to) { return from.speed + to.speed < 0; }

const char* name_of(Motion motion) {
    switch (motion) {
        case Motion::draw:
            return "draw";
        case Motion::lead:
            return "lead";
        case Motion::loop:
            return "loop";
        case Motion::connect:
            return "connect";
        case Motion::pivot:
            return "pivot";
    }
    return "";
}

}  // namespace strandline
