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
std::optional<Leg> lead_in(const Robot& robot, const RobotState& first, double step);
std::optional<Leg> run_out(const Robot& robot, const RobotState& last, double step);

/// Rake up from one state to the other by the shortest curve within the robot's limits.
Leg loop(const Robot& robot, const RobotState& from, const RobotState& to, double step);
/// From one state to the other turning on the spot: turn, straight, turn; only one turn where both are at one
/// place.
std::vector<Leg> pivot(Pose from, Pose to);

}  // namespace strandline::drive
