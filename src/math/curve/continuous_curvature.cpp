// The shortest of all families that meets the end when it is driven.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/curve/families.hpp"

namespace strandline {
namespace {

/// What a curve may miss its end by, in radii and radians.
constexpr double end_accuracy = 1e-10;

bool arrives(const std::vector<Clothoid>& pieces, Pose to) {
    const Pose end = end_pose({{}, pieces});
    return distance(end.at, to.at) <= end_accuracy * (1 + length(to.at)) &&
           std::abs(wrap_angle(end.heading - to.heading)) <= end_accuracy;
}

}  // namespace

Curve continuous_curvature(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits) {
    const double radius = limits.radius;
    assert(radius > 0 && limits.sharpness > 0);
    assert(std::abs(from.curvature) * radius < 1 + 1e-6 && std::abs(to.curvature) * radius < 1 + 1e-6);
    const Point chord = (1 / radius) * (to.pose.at - from.pose.at);
    const Pose end{turns::rotated(unit(-from.pose.heading), chord),
                   wrap_angle(to.pose.heading - from.pose.heading)};
    const turns::Task task(end, std::clamp(from.curvature * radius, -1.0, 1.0),
                           std::clamp(to.curvature * radius, -1.0, 1.0), limits.sharpness * radius * radius);
    std::vector<turns::Found> found{turns::same_side(task, 1), turns::same_side(task, -1)};
    turns::add_turn_straight_turn(task, found);
    turns::add_three_turns(task, found);
    std::ranges::sort(found, {}, &turns::Found::length);
    std::vector<Clothoid> pieces;
    for (const turns::Found& f : found) {
        pieces = turns::pieces(task, f);
        if (arrives(pieces, end)) break;
    }
    for (Clothoid& piece : pieces)
        piece = {piece.length * radius, piece.curvature / radius, piece.sharpness / (radius * radius)};
    return {from.pose, pieces};
}

}  // namespace strandline
