#pragma once
// The controller that drives in a simulation.
#include "commands.hpp"
#include "machine/robot/robot.hpp"
#include "result/tracking/tracking.hpp"

namespace strandline::cli {

/// What --noise, --wander, --delay, --seed and --late-pins ask for. Error: by option, with its range.
Outcome<tracking::Options> controller(const SimulateArguments& arguments, const Robot& robot);

}  // namespace strandline::cli
