#pragma once
// What hints ask of elements -> settings of fills, entries, batches, stops.
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Whether the settings of fills can be read, and suit the robot.
Outcome<void> valid_fill(const Options& options, const Robot& robot);
/// The same of one hint; others than fill-*: whether there is such a hint.
Outcome<void> valid_for(const svg::Hint& hint, const Robot& robot);
/// Takes out the hints that cannot be obeyed, with a warning for each name and value.
Warnings drop_wrong_hints(svg::Document& document, const Robot& robot);
/// The settings with the element's fill-* hints over them.
Options options_for(const Element& element, const Options& options);
/// The hints "start": where lines are entered.
std::vector<Edit> entries_asked(const Drawing& drawing);
/// Groups that are drawn one batch after the other, by pause (in painting order), tool, order; empty where
/// nothing of that is asked for.
std::vector<std::vector<int>> batches_of(const std::vector<order::Group>& groups, const Drawing& drawing);
/// Where tools change and layers wait.
std::vector<Stop> stops_of(const Plan& plan);

}  // namespace strandline::pipeline
