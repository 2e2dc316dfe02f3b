// The shortest of all families that meets the end when it is driven.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>

#include "math/curve/three_peaks.hpp"

namespace strandline {
namespace {

/// What a curve may miss its end by, in radii and radians.
constexpr double end_accuracy = 1e-10;

bool arrives(const std::vector<Clothoid>& pieces, Pose to) {
    const Pose end = end_pose({{}, pieces});
    return distance(end.at, to.at) <= end_accuracy * (1 + length(to.at)) &&
           std::abs(wrap_angle(end.heading - to.heading)) <= end_accuracy;
}

using Search = void (*)(const turns::Task&, std::vector<turns::Found>&);

Curve shortest(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits,
               std::initializer_list<Search> searches) {
    const double left = limits.radius, right = limits.right_radius > 0 ? limits.right_radius : left;
    const double radius = std::min(left, right);
    assert(radius > 0 && limits.sharpness > 0);
    const auto bounded = [&](double curvature) {
        assert(curvature * left < 1 + 1e-6 && -curvature * right < 1 + 1e-6);
        return std::clamp(curvature * radius, -radius / right, radius / left);
    };
    const Point chord = (1 / radius) * (to.pose.at - from.pose.at);
    const Pose end{turns::rotated(unit(-from.pose.heading), chord),
                   wrap_angle(to.pose.heading - from.pose.heading)};
    const turns::Task task(end, bounded(from.curvature), bounded(to.curvature),
                           limits.sharpness * radius * radius, radius / left, radius / right);
    std::vector<turns::Found> found{turns::same_side(task, 1), turns::same_side(task, -1)};
    for (const Search search : searches) search(task, found);
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

}  // namespace

Curve continuous_curvature(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits) {
    return shortest(from, to, limits, {turns::add_turn_straight_turn, turns::add_three_peaks});
}

Curve refined_continuous_curvature(const CurvatureState& from, const CurvatureState& to,
                                   const CurveLimits& limits) {
    return shortest(from, to, limits,
                    {turns::add_turn_straight_turn, turns::add_three_peaks, turns::add_all_three_peaks});
}

}  // namespace strandline
