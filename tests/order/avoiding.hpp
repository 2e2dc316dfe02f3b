#pragma once
// Options as the pipeline makes them of a robot, for tests of what is avoided.
#include "path/order/order.hpp"

namespace strandline::order {

inline Options options_for(const Robot& robot, bool avoid) {
    Options options;
    options.connect.limits = connect::limits_of(robot);
    options.avoid.on = avoid;
    options.avoid.clearance = wheel_reach(robot);
    options.avoid.radius = robot.min_radius;
    return options;
}

}  // namespace strandline::order
