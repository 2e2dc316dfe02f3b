#include "path/connect/connect.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "path/connect/styles.hpp"

namespace strandline::connect {
namespace {

/// A curvature is above the limit when it is so by more than this share.
constexpr double rounding = 1e-9;
/// What a spline may miss its ends by: metres in radii, radians.
constexpr double end_slack = 1e-6;
/// What a spline's curvature may jump by within it and miss at its ends (1/R): rounding of its pieces.
constexpr double jump_slack = 1e-3;

Connection straight_with_turns(Pose from, Pose to) {
    const double d = distance(from.at, to.at);
    if (d == 0) return {wrap_angle(to.heading - from.heading), 0, {to, {}}};
    const double direction = heading(to.at - from.at);
    return {wrap_angle(direction - from.heading), wrap_angle(to.heading - direction),
            straight({from.at, direction}, d)};
}

bool above_limit(double curvature, const CurveLimits& limits) {
    const double right = limits.right_radius > 0 ? limits.right_radius : limits.radius;
    return std::max(curvature * limits.radius, -curvature * right) > 1 + rounding;
}

Curve bounded(const CurvatureState& from, const CurvatureState& to, const Options& options) {
    return options.refined ? refined_continuous_curvature(from, to, options.limits)
                           : continuous_curvature(from, to, options.limits);
}

/// Within the limits, without turns on the spot.
Connection curved(const CurvatureState& from, const CurvatureState& to, const Options& options) {
    if (options.style == Style::fair)
        return {0, 0, fair(from, to, options.limits, bounded(from, to, options), options.extra_length)};
    if (options.style != Style::spiro && options.style != Style::bezier)
        return {0, 0, bounded(from, to, options)};
    auto spline = options.style == Style::spiro ? spiro(from, to, options.limits) : bezier(from, to);
    std::string broken = spline ? broken_limit(*spline, from, to, options.limits) : "no such curve";
    if (broken.empty()) return {0, 0, std::move(*spline)};
    return {0, 0, bounded(from, to, options), std::move(broken)};
}

}  // namespace

const std::vector<std::string>& style_names() {
    static const std::vector<std::string> names{"bounded", "fair", "spiro", "bezier", "straight"};
    return names;
}

std::string broken_limit(const Curve& curve, const CurvatureState& from, const CurvatureState& to,
                         const CurveLimits& limits) {
    const double r = limits.radius, k = 1 / r;
    for (const Clothoid& piece : curve.pieces)
        for (const double curvature : {piece.curvature, piece.end_curvature()})
            if (above_limit(curvature, limits)) return "curvature";
    if (max_sharpness(curve) > limits.sharpness * (1 + rounding)) return "sharpness";
    if (max_curvature_jump(curve) > jump_slack * k) return "curvature jumps";
    const Pose end = end_pose(curve);
    if (distance(curve.start.at, from.pose.at) + distance(end.at, to.pose.at) > end_slack * r ||
        std::abs(wrap_angle(curve.start.heading - from.pose.heading)) > end_slack ||
        std::abs(wrap_angle(end.heading - to.pose.heading)) > end_slack)
        return "the end's pose";
    if (curve.pieces.empty() || std::abs(curve.pieces.front().curvature - from.curvature) > jump_slack * k ||
        std::abs(curve.pieces.back().end_curvature() - to.curvature) > jump_slack * k)
        return "the end's curvature";
    return "";
}

Connection connection(const CurvatureState& from, const CurvatureState& to, const Options& options) {
    const CurveLimits& limits = options.limits;
    const bool too_tight = above_limit(from.curvature, limits) || above_limit(to.curvature, limits);
    if (options.style == Style::straight || limits.radius <= 0 || (options.pivot && too_tight))
        return straight_with_turns(from.pose, to.pose);
    Connection curve = curved(from, to, options);
    if (options.back_up)
        if (auto backed = backing_curve(from, to, limits, options.stand_cost, length(curve.curve)))
            curve = {0, 0, std::move(*backed)};
    if (!options.pivot) return curve;
    Connection turning = straight_with_turns(from.pose, to.pose);
    const auto cost = [&](double turn) {
        return turn == 0 ? 0 : options.turn_start + options.turn_cost * std::abs(turn);
    };
    const double turns = cost(turning.turn_before) + cost(turning.turn_after);
    const double stood = options.back_up ? options.stand_cost * stands(curve.curve) : 0;
    return length(turning.curve) + turns < length(curve.curve) + stood ? turning : curve;
}

CurveLimits limits_of(const Robot& robot) {
    return {least_radius(robot, 1), robot.sharpness, least_radius(robot, -1)};
}

}  // namespace strandline::connect
