#pragma once
// Private to the room: what each kind of detail is found by.
#include "result/legibility/legibility.hpp"

namespace strandline::legibility {

/// Metres of a curved medial axis that one chord stands for, in pins.
constexpr double step_in_pins = 0.5;
/// What is thinner than this share of a pin is a flaw of the outline, not a detail.
constexpr double least_share = 0.02;
/// Towards a corner of angle a the medial axis's radius falls by sin(a / 2) a metre. Where it falls by more
/// than this, the area runs out in a tip (6 degrees or more): no canvas is large enough for a point.
constexpr double tip_slope = 0.05;

/// Sharp ends of an area, by its medial axis: those that are narrower than a pin for a pin or more, and at a
/// third of their length.
void find_horns(const MedialAxis& axis, int element, double pin, std::vector<Detail>& details);

/// Clean sand between two elements that lie side by side for a pin or more, narrower than a pin once the
/// grooves of lines have taken their halves. False: it was too much to look at all.
bool find_gaps(const Drawing& drawing, const Robot& robot, std::vector<Detail>& details);

}  // namespace strandline::legibility
