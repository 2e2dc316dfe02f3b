// Where the rake cannot follow, the robot still rolls: driven backward, the rake leads, and is steered
// towards its path: psi, the direction in which it moves, is the path's tangent turned by atan(error /
// reach), so that the error dies as e^(-u/reach) once delta = theta - psi is within its limit again. u:
// length of the rake's own track.
#include <algorithm>
#include <cmath>

#include "machine/follow/nodes.hpp"

namespace strandline {
namespace {

// Shares of L: the reach of the steering, and the longest step.
constexpr double reach_share = 0.2, step_share = 0.01;
// Metres: the rake is back on its path; is off it visibly.
constexpr double back_on_path = 1e-6, visibly_off = 1e-3;
// The rake is back only with that share of max_delta, so that it is not lost again at once.
constexpr double settled_share = 0.9;
// However the rake moves, its place on the path goes back by this share of its own way at least: the pass
// ends.
constexpr double least_progress = 0.2, most_progress = 3;
// 1 - curvature x error, kept off its pole.
constexpr double least_closeness = 0.3;

// The path lies behind the robot (radians): either side would do, so it keeps to the one it is turning to.
constexpr double turned_away = 2.2;

/// What steering sees at one moment.
struct Sight {
    double aside, ahead;  ///< the rake from its place on the path: to the left, forward
    double delta;         ///< to steer with
    double progress;      ///< of the place along the path, per metre of rake
    double on_path;       ///< delta if the rake were on its path
    double error() const { return std::hypot(aside, ahead); }
};

/// steered: delta until now.
Sight look(const RakeNode& node, double s, const Robot& robot, const Pose& pose, const DeltaRange& drivable,
           double steered) {
    const Pose place = rake_at(node, s - node.s);
    const double reach = reach_share * robot.rake_offset;
    const Point off = rake_at(robot, pose) - place.at, tangent = unit(place.heading);
    Sight sight{cross(tangent, off), dot(tangent, off), 0, 0, wrap_angle(pose.heading - place.heading)};
    const double aim = std::atan(sight.aside / reach);
    const double wanted = wrap_angle(sight.on_path - aim);
    sight.delta = std::abs(wanted) > turned_away ? (std::signbit(steered) ? drivable.low : drivable.high)
                                                 : std::clamp(wanted, drivable.low, drivable.high);
    const double along = std::cos(sight.on_path - sight.delta) - sight.ahead / reach;
    const double closeness = std::max(least_closeness, 1 - curvature_at(node, s - node.s) * sight.aside);
    sight.progress = std::clamp(along / closeness, least_progress, most_progress);
    return sight;
}

}  // namespace

WayBack stray(const std::vector<RakeNode>& nodes, std::size_t step, double s, const Robot& robot,
              const FollowOptions& options, Followed& result, double& to_end) {
    const double offset = robot.rake_offset, h = std::min(options.step, step_share * offset);
    const auto place_before = [&](std::size_t& i, double& at, double back) {
        at = std::max(0.0, at - back);
        while (i > 0 && at < nodes[i].s) --i;
    };
    const auto arrive = [&](Pose pose, double delta) {
        result.path.push_back({to_end, pose, robot_curvature(robot, delta)});
        result.rake_s.push_back(s);
        result.max_delta = std::max(result.max_delta, std::abs(delta));
    };
    const DeltaRange drivable = drivable_deltas(robot, options.max_delta);
    const double lost = s;
    double off_from = s;
    Pose pose = result.path.back().pose;
    const double before_straying = result.path.back().curvature;  // only its sign counts
    Sight sight = look(nodes[step], s, robot, pose, drivable, before_straying);
    double delta = sight.delta;
    arrive(pose, delta);  // the steering may jump here
    WayBack back{};
    while (s > 0) {
        // Heun: steered as the place before will want it
        double wanted = sight.delta, dz = 0;
        Pose before = pose;
        std::size_t i = step;
        double at = s;
        for (int round = 0; round < 2; ++round) {
            dz = h * rolled(robot, (delta + wanted) / 2);
            const double k = robot_curvature(robot, delta), k_before = robot_curvature(robot, wanted);
            before = advanced(pose, {dz, k, (k - k_before) / dz}, -dz);
            i = step;
            at = s;
            place_before(i, at, h * sight.progress);
            const Sight then = look(nodes[i], at, robot, before, drivable, delta);
            if (round == 0) wanted = then.delta;
            if (round == 1) sight = then;
        }
        pose = before;
        delta = wanted;
        step = i;
        s = at;
        to_end += dz;
        arrive(pose, delta);
        result.max_error = std::max(result.max_error, sight.error());
        if (sight.error() > visibly_off) off_from = s;
        if (s > 0 && sight.error() < back_on_path && sight.on_path > settled_share * drivable.low &&
            sight.on_path < settled_share * drivable.high) {
            back.rejoined = true;
            break;
        }
    }
    result.undrivable.push_back({off_from, lost});
    back.step = step;
    back.s = s;
    return back;
}

}  // namespace strandline
