#pragma once
// Which pins are down in areas, decided on the finished drive.
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Whether the robot's pins lift one by one in an area with these settings.
bool lifts_pins(const Options& options, const Robot& robot);
/// Whether the area is small enough for it.
bool sees_pins(const Region& region, const Robot& robot);

/// In the strokes of areas, the pins over raked sand and outside are lifted, by the true tracks of the pins.
/// In areas that are too large for it all pins stay down.
Warnings lift_pins(std::vector<Sample>& samples, const std::vector<Stroke>& strokes, const Drawing& drawing,
                   const Robot& robot, const Options& options);

}  // namespace strandline::pipeline
