#pragma once
// Private to the room: what timing a whole drive and timing it piece by piece share.
#include <optional>
#include <vector>

#include "path/trajectory/trajectory.hpp"

namespace strandline::trajectory {

/// Curvature that differs less than this between two legs is the same number after rounding, not a jump.
inline constexpr double same_curvature = 1e-6;

/// A part of a leg without a jump of curvature inside.
struct Part {
    const Leg* leg;
    std::vector<RobotState> states;  ///< evenly spaced; s from 0
    bool back = false;               ///< driven backwards
};
/// Whether the robot must stand, its wheels to be turned, between one part and the next.
bool stands_between(const Part& last, const Part& next);
/// Of a sample: below 0 where the robot backs up, and 0, not -0, where it stands.
inline double signed_speed(double speed, bool back) { return back && speed > 0 ? -speed : speed; }
/// Cuts a leg where its curvature jumps or it turns back. The states next to a jump carry the curvature of
/// their own side.
std::vector<Part> parts_of(const Leg& leg, double step);

/// Turning on the spot takes a trapezoid of turn rate; the samples are spaced in angle. `t` becomes its end.
void add_pivot(std::vector<Sample>& samples, const Leg& leg, const Robot& robot, double& t);
/// Whether a leg of that motion turns at all.
bool turns(const Leg& leg);
/// `pins`: down in a draw.
Sample sample_at(const Robot& robot, const RobotState& state, double t, Motion motion, int stroke, int pins,
                 double speed);
/// What a drive that begins with `first` begins with instead where the pins take time: standing until they
/// are down.
std::optional<Sample> waiting_before(const Sample& first, const Robot& robot);

}  // namespace strandline::trajectory
