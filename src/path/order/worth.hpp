#pragma once
// Private to the room: what a drive rake up is worth.
#include "path/order/order.hpp"

namespace strandline::order {

/// Metres: the curve's length; where bends are slow (Options::slow_bends), what is driven at travel speed in
/// the time that the curve takes; besides what stands to back up cost. Never less than the length. O(pieces).
double worth(const Curve& curve, const Options& options);

}  // namespace strandline::order
