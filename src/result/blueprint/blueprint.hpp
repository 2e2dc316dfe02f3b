#pragma once
// A machine as a drawing to scale, seen from above: what a profile says, to be looked at.
#include <string>

#include "machine/robot/robot.hpp"

namespace strandline::blueprint {

/// SVG, ahead is up: footprint, wheels, the arm to the rake, its pins with the groove of each, how tightly it
/// turns to either side, and the figures in words. Figures are rounded to three digits. O(pins + wheels).
std::string write_svg(const Robot& robot);

}  // namespace strandline::blueprint
