#pragma once
// Private to the room: connections that a person has shaped.
#include "path/order/order.hpp"

namespace strandline::order {

/// What is driven from group a to group b as a shape of the job leads it, if one does. In `unshaped` stands
/// for that shape why it cannot be, or "".
std::optional<connect::Connection> shaped(const connect::Connection& plain, int a, int b, const Job& job,
                                          const connect::Options& options,
                                          std::vector<std::string>& unshaped);

}  // namespace strandline::order
