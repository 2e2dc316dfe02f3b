#pragma once
// Rake path <-> robot path. The rake's centre Q trails the turning point P and lies w to its left:
// Q = P - L e(theta) + w n(theta). On a rake path with tangent phi and curvature k, delta = theta - phi obeys
// d delta / ds = sin(delta)/L - k; the robot's curvature is tan(delta)/(L + w tan(delta)) and its arc length
// grows by cos(delta) + w/L sin(delta) per metre of rake. Forward that is unstable, backward contracting: one
// backward pass gives the robot path. Exact while |k| < 1/L, to the side away from the rake 1/hypot(L, w)
// (see docs/follow.md for the derivation).
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/robot/robot.hpp"
#include "math/curve/curve.hpp"

namespace strandline {

/// The turning point at one place of its path. s: the robot's own arc length from the path's start.
struct RobotState {
    double s = 0;
    Pose pose;
    double curvature = 0;
    bool operator==(const RobotState&) const = default;
};
/// States in order, s not decreasing. Between two states curvature is taken as linear in s. Two states with
/// the same s are a jump: of curvature or sense (same pose): the robot stops there; of heading too where it
/// turns on the spot. Headings are not wrapped. A state that lies behind the one before it is backed up to.
using RobotPath = std::vector<RobotState>;

Point rake_at(const Robot& robot, Pose robot_pose);
Pose robot_at(const Robot& robot, Point rake, double robot_heading);
double length(const RobotPath& path);
/// Interpolated by cubic Hermite in position and heading: error O(step^4). s is clamped. At a jump: the state
/// after it. O(log n).
RobotState state_at(const RobotPath& path, double s);
/// A clothoid curve as states, at steps of at most `step`.
RobotPath states_along(const Curve& curve, double step);

/// What came of a rake path.
struct Followed {
    RobotPath path;              ///< robot states from the rake path's start to its end
    std::vector<double> rake_s;  ///< rake arc length of each state
    struct Span {
        double from, to;
    };  ///< rake arc lengths
    std::vector<Span>
        undrivable;        ///< where delta would leave drivable_deltas(): the rake leaves its path there
    double max_delta = 0;  ///< largest |delta| met
    double max_error = 0;  ///< metres: how far the rake gets off its path in undrivable spans
};
struct FollowOptions {
    double step = 0.01;       ///< metres of rake arc between states, at most
    double max_delta = 1.45;  ///< rad: beyond this the rake cannot follow without sliding (83 degrees)
    double end_delta = 0;     ///< delta at the rake path's end: free to choose; 0 = straight behind
    bool steady_end = true;   ///< true: ignore end_delta, take the steady state of the end's curvature,
                              ///< limited to what min_radius allows
};
/// The robot path that makes the rake follow smooth curves laid end to end; at corners (heading jumps between
/// curves) theta is continuous and delta jumps. One backward pass, Runge-Kutta 4, O(length / step). For
/// rake_offset 0: the path itself. Where delta would pass max_delta the rake leaves its path: the robot,
/// still rolling, brings it back as soon as it can, and the span is listed. Steps end on every joint of
/// pieces.
Followed robot_path_for(const std::vector<Curve>& rake_path, const Robot& robot,
                        const FollowOptions& options = {});
/// sin(delta) = curvature x rake_offset, where delta comes to rest on an endless arc; limited to |delta| <=
/// most (radians).
double steady_delta(const Robot& robot, double rake_curvature, double most);
/// The robot's curvature while its heading is delta ahead of the rake's way, and back; L above 0.
double robot_curvature(const Robot& robot, double delta);
double delta_for(const Robot& robot, double robot_curvature);
/// The deltas up to `most` at which the robot rolls forward. With a rake beside the axis it stands, and turns
/// on the spot, at tan(delta) = -L/w; beyond it would have to back up. L above 0.
struct DeltaRange {
    double low, high;
    bool hold(double delta) const { return delta >= low && delta <= high; }  ///< no NaN
};
DeltaRange drivable_deltas(const Robot& robot, double most);
/// The largest |delta| of that sign at which the robot's own curvature is within its limit to that side:
/// atan(L / (R - w)) to the left, atan(L / (R + w)) to the right; pi/2 where that side's limit is never met.
double connectable_delta(const Robot& robot, double side);

/// What the robot is told at one instant.
enum class Motion { draw, lead, loop, connect, pivot };
/// draw: rake down. lead: rake up before or after a stroke, on its extension. loop: rake up round a corner.
/// connect: between strokes. pivot: turning on the spot.
struct Sample {
    double t = 0;                     ///< s from the start
    Pose pose;                        ///< of P
    double curvature = 0;             ///< of P's path, signed
    double speed = 0;                 ///< m/s; below 0: backing up
    double turn_rate = 0;             ///< rad/s
    Point rake;                       ///< Q
    unsigned mask = 0;                ///< pins down from this sample to the next
    Motion motion = Motion::connect;  ///< from this sample to the next
    int stroke = -1;  ///< index of the stroke drawn from here to the next sample, -1 between strokes
    bool operator==(const Sample&) const = default;
};
/// Where a line is drawn with these pins at the sample: the middle of them, beside Q where they are not those
/// in the rake's middle.
Point drawn_at(const Robot& robot, const Sample& sample, unsigned mask);
const char* name_of(Motion motion);
/// Whether the robot backs up from one sample to the next.
bool backs(const Sample& from, const Sample& to);

}  // namespace strandline
