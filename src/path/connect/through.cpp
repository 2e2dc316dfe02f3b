// A connection led through poses: the curvature at each is chosen among a few by dynamic programming on quick
// curves, then every part is made in its style.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>

#include "path/connect/connect.hpp"

namespace strandline::connect {
namespace {

/// Shares of the limits that are tried as curvature at a pose.
constexpr std::array<double, 7> shares{-1, -0.6, -0.3, 0, 0.3, 0.6, 1};
/// Poses farther than this from their neighbour (radii) are a slip of the pen.
constexpr double farthest = 1e5;

/// The curvatures at the poses for which the sum of quick curves is least.
std::vector<CurvatureState> states(const CurvatureState& from, const std::vector<Pose>& through,
                                   const CurvatureState& to, const CurveLimits& limits) {
    const double right = limits.right_radius > 0 ? limits.right_radius : limits.radius;
    std::vector<std::vector<CurvatureState>> choices{{from}};
    for (const Pose& pose : through) {
        choices.emplace_back();
        for (const double share : shares)
            choices.back().push_back({pose, share / (share > 0 ? limits.radius : right)});
    }
    choices.push_back({to});
    std::vector<std::vector<std::size_t>> came_from(choices.size());
    std::vector<double> best{0};
    for (std::size_t k = 1; k < choices.size(); ++k) {
        std::vector<double> next(choices[k].size(), std::numeric_limits<double>::infinity());
        came_from[k].assign(next.size(), 0);
        for (std::size_t j = 0; j < next.size(); ++j)
            for (std::size_t i = 0; i < best.size(); ++i) {
                const double sum =
                    best[i] + length(continuous_curvature(choices[k - 1][i], choices[k][j], limits));
                // a gain of less than rounding changes nothing
                if (sum >= next[j] * (1 - 1e-9)) continue;
                next[j] = sum;
                came_from[k][j] = i;
            }
        best = std::move(next);
    }
    std::vector<CurvatureState> chosen(choices.size());
    for (std::size_t k = choices.size(), at = 0; k-- > 0;) {
        chosen[k] = choices[k][at];
        if (k > 0) at = came_from[k][at];
    }
    return chosen;
}

}  // namespace

Outcome<Connection> connection(const CurvatureState& from, const std::vector<Pose>& through,
                               const CurvatureState& to, const Options& options) {
    if (through.empty()) return connection(from, to, options);
    const double radius = options.limits.radius;
    if (options.style == Style::straight || radius <= 0)
        return fail("a connection through poses",
                    "is asked of a style that turns on the spot at its ends alone",
                    "use another style, or a robot with a turning radius");
    Point before = from.pose.at;
    for (std::size_t i = 0; i <= through.size(); ++i) {
        const Pose& pose = i < through.size() ? through[i] : to.pose;
        const std::string place = i < through.size() ? fmt::format("pose {}", i + 1) : "the end";
        if (!is_finite(pose.at) || !std::isfinite(pose.heading))
            return fail(place, "is not finite", "write x, y and heading as numbers");
        if (distance(before, pose.at) > farthest * radius)
            return fail(place, "is more than 100,000 radii from the one before", "check the units");
        before = pose.at;
    }
    const double right = options.limits.right_radius > 0 ? options.limits.right_radius : radius;
    for (const auto& [place, state] : {std::pair{"the start", &from}, std::pair{"the end", &to}})
        if (std::max(state->curvature * radius, -state->curvature * right) > 1 + 1e-6)
            return fail(place,
                        fmt::format("asks for curvature {:.3g} 1/m, and the limit is {:.3g} 1/m",
                                    state->curvature, 1 / (state->curvature > 0 ? radius : right)),
                        "no curve within the limits leaves or meets it: give it a lead");
    Options parts = options;
    parts.pivot = false;
    Connection whole{0, 0, {from.pose, {}}};
    const std::vector<CurvatureState> stops = states(from, through, to, options.limits);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        Connection part = connection(stops[i], stops[i + 1], parts);
        whole.curve = joined(std::move(whole.curve), part.curve);
        if (whole.broken.empty()) whole.broken = std::move(part.broken);
    }
    return whole;
}

Outcome<Connection> led_through(const Connection& plain, const std::vector<Pose>& poses,
                                const Options& options) {
    const std::vector<Clothoid>& pieces = plain.curve.pieces;
    const CurvatureState from{plain.curve.start, pieces.empty() ? 0 : pieces.front().curvature};
    const CurvatureState to{end_pose(plain.curve), pieces.empty() ? 0 : pieces.back().end_curvature()};
    Outcome<Connection> led = connection(from, poses, to, options);
    if (!led) return led;
    led->turn_before = plain.turn_before;
    led->turn_after = plain.turn_after;
    return led;
}

}  // namespace strandline::connect
