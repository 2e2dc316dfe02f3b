#pragma once
// A stroke -> its robot path for one entry and sense: lead-in, corners (rounded inside, loop outside,
// stop-and-turn, exact), run-out.
#include <vector>

#include "base/outcome/outcome.hpp"
#include "path/stroke/stroke.hpp"

namespace strandline::drive {

enum class Below { exact, round };        ///< corners that turn less than the threshold
enum class Above { loop, pivot, round };  ///< corners that turn as much or more

struct Options {
    double corner_threshold = pi / 2;  ///< rad
    double fill_radius = 0.1;  ///< metres, of rounding inside in fills: small, so that ring corners are raked
    double corner_radius = 0.5;  ///< metres, of rounding inside (as large as the neighbouring edges allow)
    Below below = Below::exact;
    Above above = Above::loop;
    bool back_up = false;     ///< loops may back up where that is cheaper
    double stand_cost = 0.4;  ///< metres that stopping for it and setting off again is worth, each time
    double step = 0.01;       ///< metres between robot states, at most
    double max_delta = 1.45;  ///< rad between robot heading and rake path, at most
};

/// A place where the rake cannot follow.
struct Span {
    Point at;
    double length;  ///< metres of rake path
};
/// The robot path of one stroke.
struct Drive {
    std::vector<Leg> legs = {};              ///< lead, draw, loop or pivot, draw, ..., lead: end to end
    CurvatureState start, end;               ///< of the whole, |curvature| <= 1/min_radius
    std::vector<Span> undrivable = {};       ///< named in the plan
    int rounded = 0, loops = 0, pivots = 0;  ///< corners by treatment
    int exact = 0;
};
/// Never fails: what cannot be driven is listed. Consecutive legs meet in position and heading (not wrapped).
/// What each corner becomes, first that the robot can do (docs/drive.md):
///   a rake at the turning point of a robot that turns on the spot: pivot, always;
///   a fill's corner: round, exact, pivot, loop;
///   below the threshold: as `below` says, exact, then as `above` says;   from the threshold: as `above`
///   says, then loop.
/// The middle of the stroke's pins is driven along the rake path, not the rake's own (steered()).
/// O(length / step).
Drive drive(const Stroke& stroke, int stroke_index, int node, bool reversed, const Robot& robot,
            const Options& options);

}  // namespace strandline::drive
