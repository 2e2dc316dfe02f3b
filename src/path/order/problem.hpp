#pragma once
// Private to the room: a job as the tour sees it.
#include "path/order/order.hpp"

namespace strandline::order {

/// A closed group is its nodes, every other its two ends; poses are places.
tour::Problem problem_of(const Job& job);

}  // namespace strandline::order
