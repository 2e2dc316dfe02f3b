#pragma once
// Private to the room: the moves a corner is made of. L rake offset, R least radius, delta = robot heading -
// rake path's tangent.
#include <optional>

#include "path/drive/drive.hpp"

namespace strandline::drive {

/// Turns on the spot whenever asked.
bool turns_on_spot(const Robot& robot);
/// delta at the end of a curve that a connection is to leave: steady, and within what 1/R allows.
double leaving_delta(const Robot& robot, const Curve& edge);

/// An arc (a clothoid where the edges are curved) that leaves `before` a distance `cut` from its end and
/// joins `after` a distance `cut` from its start. nullopt: the edges leave no room.
struct Rounding {
    double cut;
    Curve arc;
};
std::optional<Rounding> rounded(const Curve& before, const Curve& after, double turn, double radius,
                                double room_before, double room_after);

/// Rake up, straight on along the tangent, until the robot's curvature is within 1/R: before a drawn leg that
/// starts with `first` (nullopt: it is already), or after one that ends with `last`.
std::optional<Leg> lead_in(const Robot& robot, const RobotState& first, double step, double extra = 0);
std::optional<Leg> run_out(const Robot& robot, const RobotState& last, double step);

/// The robot where it leaves the edge with that delta, after a run-out if one is needed.
struct Leaving {
    RobotState state;
    double delta;
    std::optional<Leg> run_out = {};
};
Leaving leaving(const Robot& robot, const Curve& edge, double delta, double step);

/// Rake up round a corner: from the end of `before` to the drawn leg that starts with `first`. The lead-in's
/// length and the delta at the end of `before` are free, and the bounded curves between them are not
/// continuous in either: a few are tried, the shortest whole is taken. Where the options let the robot back
/// up: or the cheapest way that does.
struct Loop {
    Leaving from;
    Leg curve;
    std::optional<Leg> lead;
};
Loop loop_round(const Robot& robot, const Curve& before, const RobotState& first, const Options& options);
/// From one state to the other turning on the spot: turn, straight, turn; only one turn where both are at one
/// place.
std::vector<Leg> pivot(Pose from, Pose to);

}  // namespace strandline::drive
