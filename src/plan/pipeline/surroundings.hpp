#pragma once
// What the drive has to do with besides the drawing: the field, keep-outs, where it begins and ends.
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Whether there is a place to go back to, where that is asked for.
Outcome<void> valid_surroundings(const Options& options);
/// Metres that the turning point keeps from finished areas.
double clearance_of(const Options& options, const Robot& robot);
/// Fills the job's field, keep_out, parked and exits.
void add_surroundings(order::Job& job, const Drawing& drawing, const Options& options, const Robot& robot);
/// Whether the footprint stays where it must with all of these samples.
bool stays_within(const std::vector<Sample>& samples, const DriveArea& area, const Robot& robot);
/// Where the footprint is in a keep-out or over the border after all, by samples: a warning for each stroke
/// and each drive between two, and a spot among the blemishes. Lengths driven before the first stroke and
/// after the last are taken too.
void take_surroundings(Plan& plan);

}  // namespace strandline::pipeline
