#pragma once
// Rake paths to follow, and the law that every followed path must keep.
#include <algorithm>
#include <random>

#include "machine/follow/follow.hpp"

namespace strandline::follow_tests {

inline Robot beachbot() { return *builtin_robot("beachbot"); }
inline Curve arc(double radius, double turn, Pose start = {}) {
    return {start, {{std::abs(turn) * radius, (turn > 0 ? 1 : -1) / radius, 0}}};
}
inline double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}
/// Clothoids with |curvature| <= most, continuous or with jumps, turned and moved at random.
inline Curve wavy(std::mt19937_64& random, double most, bool jumps) {
    Curve curve{{{uniform(random, -5, 5), uniform(random, -5, 5)}, uniform(random, -pi, pi)}, {}};
    double k = uniform(random, -most, most);
    for (int i = 0; i < 12; ++i) {
        const double length = uniform(random, 0.03, 0.8), end = uniform(random, -most, most);
        curve.pieces.push_back({length, k, (end - k) / length});
        k = jumps ? uniform(random, -most, most) : end;
    }
    return curve;
}
/// Edges with the given turns between them.
inline std::vector<Curve> zigzag(const std::vector<double>& turns, double edge, Pose at = {}) {
    std::vector<Curve> path{straight(at, edge)};
    for (const double turn : turns) {
        Pose next = end_pose(path.back());
        next.heading += turn;
        path.push_back(straight(next, edge));
    }
    return path;
}
inline CurvePoint on_rake_path(const std::vector<Curve>& path, double s) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double here = length(path[i]);
        if (s <= here) return point_at(path[i], s);
        s -= here;
    }
    return point_at(path.back(), s);
}
/// The robot is integrated from its first pose by its curvature alone, linear between states, as a machine
/// would do it. The largest distance of its rake from the rake path where it should be.
inline double resimulated_error(const Robot& robot, const std::vector<Curve>& path,
                                const Followed& followed) {
    double worst = 0;
    Pose pose = followed.path.front().pose;
    for (std::size_t i = 0; i < followed.path.size(); ++i) {
        if (i > 0) {
            const RobotState &a = followed.path[i - 1], &b = followed.path[i];
            const double h = b.s - a.s;
            if (h > 0) pose = advanced(pose, {h, a.curvature, (b.curvature - a.curvature) / h}, h);
        }
        worst =
            std::max(worst, distance(rake_at(robot, pose), on_rake_path(path, followed.rake_s[i]).pose.at));
    }
    return worst;
}

}  // namespace strandline::follow_tests
