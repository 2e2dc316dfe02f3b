#pragma once
// Robot pose -> robot pose, rake up, with end curvatures: curvature and sharpness bounded, G2. Knows no
// order.
#include <string>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/robot/robot.hpp"
#include "math/curve/curve.hpp"

namespace strandline::connect {

enum class Style { bounded, straight };

struct Options {
    Style style = Style::bounded;
    CurveLimits limits{};
    /// May turn on the spot at both ends: for `straight` always; for `bounded` it serves where an end asks
    /// for a curvature above the limit, and where that is the shorter way.
    bool pivot = false;
    double turn_cost = 0.5;  ///< metres that a radian on the spot is worth: it takes as long
};
/// What is driven: pivot by `turn_before`, along the curve, pivot by `turn_after` (radians; 0 for a bounded
/// curve).
struct Connection {
    double turn_before = 0, turn_after = 0;
    Curve curve;
};
/// bounded never fails and never breaks the limits (continuous_curvature). A limits.radius of 0 means turns
/// on the spot. Poses at one point: a turn alone. O(1).
Connection connection(const CurvatureState& from, const CurvatureState& to, const Options& options);
CurveLimits limits_of(const Robot& robot);

}  // namespace strandline::connect
