#pragma once
// Robot pose -> robot pose, rake up, with end curvatures, in several styles; all keep the limits of curvature
// and sharpness, or give way to the one that does. Knows no order.
#include <string>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/robot/robot.hpp"
#include "math/curve/curve.hpp"

namespace strandline::connect {

/// bounded: the shortest within the limits. fair: longer by a share, for less bending and sharpness. spiro,
/// bezier: splines, where they keep the limits. straight: turns on the spot at both ends.
enum class Style { bounded, fair, spiro, bezier, straight };
/// "bounded", ...: in the order of the enum.
const std::vector<std::string>& style_names();

struct Options {
    Style style = Style::bounded;
    CurveLimits limits{};
    /// May turn on the spot at both ends: for `straight` always; for the others it serves where an end asks
    /// for a curvature above the limit, and where that is the shorter way.
    bool pivot = false;
    /// May back up, where that is cheaper or there is no other way; `straight` never does.
    bool back_up = false;
    double stand_cost = 0.4;    ///< metres that stopping for it and setting off again is worth, each time
    double turn_cost = 0.5;     ///< metres that a radian on the spot is worth: it takes as long
    double turn_start = 0;      ///< metres that each turn on the spot costs besides: stopping, spinning up
    bool refined = true;        ///< bounded: search thoroughly (300 us instead of 10)
    double extra_length = 0.1;  ///< fair: share of the bounded curve's length that may be spent, 0 and above
};
/// What is driven: pivot by `turn_before`, along the curve, pivot by `turn_after` (radians; 0 for a bounded
/// curve).
struct Connection {
    double turn_before = 0, turn_after = 0;
    Curve curve;
    /// The style that was asked for breaks a limit here: which one. The curve is bounded.
    std::string broken = {};
};
/// Never fails and never breaks the limits, backed parts included (docs/connect.md). A limits.radius of 0
/// means turns on the spot. Poses at one point: a turn alone where turns are allowed. O(1): docs/connect.md
/// has the times.
Connection connection(const CurvatureState& from, const CurvatureState& to, const Options& options);

/// The same, led through poses in this order, with the curvature there chosen so that the whole is short.
/// Error: what makes it impossible, with the pose's number. O(poses).
Outcome<Connection> connection(const CurvatureState& from, const std::vector<Pose>& through,
                               const CurvatureState& to, const Options& options);

/// A connection between the same states, with the same turns on the spot, led through poses. Error: as above.
Outcome<Connection> led_through(const Connection& plain, const std::vector<Pose>& poses,
                                const Options& options);

CurveLimits limits_of(const Robot& robot);
/// Integral of the curvature's square, 1/m.
double bending(const Curve& curve);

}  // namespace strandline::connect
