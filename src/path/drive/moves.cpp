#include "path/drive/moves.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::drive {
namespace {

// Places nearer than this (metres) are one.
constexpr double same_place = 1e-9;
// Ends are kept this share inside 1/R, so that rounding never carries them over it.
constexpr double inside_limit = 1 - 1e-9;
// A hairpin (170 degrees and more) has no arc inside that is worth the name.
constexpr double sharpest_rounding = 170 * pi / 180;
// Less room than this (metres) is none.
constexpr double least_cut = 1e-4;
// What loop_round tries: deltas at the end as shares of what a connection takes up (0: the steady one), and
// metres of lead-in beyond what is needed as shares of R.
constexpr double ends_tried[] = {0, -1, -0.5, 0.5, 1};
constexpr double leads_tried[] = {0, 0.1, 0.25, 0.5, 1};

/// Of delta of that sign.
double connectable(const Robot& robot, double side) { return connectable_delta(robot, side) * inside_limit; }
/// Whether a connection can take up that curvature.
bool within(const Robot& robot, double curvature) {
    return robot.min_radius == 0 || std::abs(curvature) * least_radius(robot, curvature) <= 1;
}
Leg lead(RobotPath path) { return {.motion = Motion::lead, .path = std::move(path)}; }

}  // namespace

bool turns_on_spot(const Robot& robot) { return robot.can_pivot || robot.min_radius == 0; }

double leaving_delta(const Robot& robot, const Curve& edge) {
    const double curvature = edge.pieces.empty() ? 0 : edge.pieces.back().end_curvature();
    return steady_delta(robot, curvature, connectable(robot, curvature));
}

std::optional<Rounding> rounded(const Curve& before, const Curve& after, double turn, double radius,
                                double room_before, double room_after) {
    if (std::abs(turn) > sharpest_rounding) return std::nullopt;
    const double cut = std::min({radius * std::tan(std::abs(turn) / 2), room_before, room_after});
    if (cut < least_cut) return std::nullopt;
    const Pose from = point_at(before, length(before) - cut).pose, to = point_at(after, cut).pose;
    if (distance(from.at, to.at) < same_place) return std::nullopt;
    return Rounding{cut, hermite_clothoid(from, to)};
}

std::optional<Leg> lead_in(const Robot& robot, const RobotState& first, double step, double extra) {
    if (within(robot, first.curvature) && extra == 0) return std::nullopt;
    double back = step;  // a rake at the turning point: any straight piece ends with curvature 0
    double delta = 0;
    if (robot.rake_offset > 0) {
        // on a straight line d delta / ds = sin(delta)/L: tan(delta/2) grows as e^(s/L)
        delta = delta_for(robot, first.curvature);
        constexpr double margin = 1 - 1e-4;  // against the error of the numerical pass
        const double allowed = std::tan(connectable_delta(robot, delta) * margin / 2);
        back = robot.rake_offset * std::log(std::max(1.0, std::tan(std::abs(delta) / 2) / allowed));
    }
    back += extra;
    const double tangent = first.pose.heading - delta;
    const Point rake = rake_at(robot, first.pose);
    const Curve line = straight({rake - back * unit(tangent), tangent}, back);
    return lead(robot_path_for({line}, robot,
                               {.step = step, .max_delta = pi / 2, .end_delta = delta, .steady_end = false})
                    .path);
}

std::optional<Leg> run_out(const Robot& robot, const RobotState& last, double step) {
    // with an offset the end's delta was chosen within the limit
    if (robot.rake_offset > 0 || within(robot, last.curvature)) return std::nullopt;
    return lead(states_along(straight(last.pose, step), step));
}

Leaving leaving(const Robot& robot, const Curve& edge, double delta, double step) {
    const Pose end = end_pose(edge);
    const double curvature =
        robot.rake_offset > 0 ? robot_curvature(robot, delta) : edge.pieces.back().end_curvature();
    const RobotState state{0, robot_at(robot, end.at, end.heading + delta), curvature};
    auto out = run_out(robot, state, step);
    return out ? Leaving{out->path.back(), delta, out} : Leaving{state, delta};
}

Loop loop_round(const Robot& robot, const Curve& before, const RobotState& first, const Options& options) {
    const double step = options.step;
    std::vector<Leaving> ways_out;
    for (const double share : ends_tried) {
        const double delta = share == 0 ? leaving_delta(robot, before) : share * connectable(robot, share);
        ways_out.push_back(leaving(robot, before, delta, step));
        if (robot.rake_offset == 0) break;  // the end is what the edge makes it
    }
    const CurveLimits limits{least_radius(robot, 1), robot.sharpness, least_radius(robot, -1)};
    std::optional<Loop> best;
    double shortest = 0;
    for (const double share : leads_tried) {
        auto lead = lead_in(robot, first, step, share * robot.min_radius);
        const RobotState to = lead ? lead->path.front() : first;
        for (const Leaving& from : ways_out) {
            Curve curve = continuous_curvature({from.state.pose, from.state.curvature},
                                               {to.pose, to.curvature}, limits);
            const double whole = length(curve) + (lead ? length(lead->path) : 0);
            // a gain of less than rounding changes nothing, so that turned drawings are driven alike
            if (best && whole > shortest * (1 - 1e-6)) continue;
            shortest = whole;
            best = Loop{from, {.motion = Motion::loop, .curve = std::move(curve)}, lead};
        }
    }
    const RobotState to = best->lead ? best->lead->path.front() : first;
    best->curve.curve = refined_continuous_curvature({best->from.state.pose, best->from.state.curvature},
                                                     {to.pose, to.curvature}, limits);
    if (options.back_up) {
        // from a stand or to one any delta will do: no lead is longer than it must be
        auto lead = lead_in(robot, first, step);
        const RobotState behind = lead ? lead->path.front() : first;
        const double led = lead ? length(lead->path) : 0;
        double below = length(best->curve.curve) + (best->lead ? length(best->lead->path) : 0) - led;
        for (const Leaving& from : ways_out) {
            auto curve = backing_curve({from.state.pose, from.state.curvature},
                                       {behind.pose, behind.curvature}, limits, options.stand_cost, below);
            if (!curve) continue;
            below = length(*curve) + options.stand_cost * stands(*curve);
            best = Loop{from, {.motion = Motion::loop, .curve = std::move(*curve)}, lead};
        }
    }
    best->curve.path = states_along(best->curve.curve, step);
    return std::move(*best);
}

std::vector<Leg> pivot(Pose from, Pose to) {
    const auto turn = [](Pose at, double heading_after) {
        return Leg{
            .motion = Motion::pivot,
            .path = {{0, at, 0}, {0, {at.at, at.heading + wrap_angle(heading_after - at.heading)}, 0}}};
    };
    const Point way = to.at - from.at;
    const double far = length(way);
    if (far < same_place) return {turn(from, to.heading)};
    const Leg first = turn(from, heading(way));
    const Curve line = straight(first.path.back().pose, far);
    Leg straight_on{.motion = Motion::loop, .path = states_along(line, far), .curve = line};
    const Leg last = turn({to.at, first.path.back().pose.heading}, to.heading);
    return {first, std::move(straight_on), last};
}

}  // namespace strandline::drive
