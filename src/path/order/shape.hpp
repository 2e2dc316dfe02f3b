#pragma once
// Private to the room: connections that a person has shaped.
#include "path/order/order.hpp"

namespace strandline::order {

/// The groups that a connection leads from and to, and where the rake is lifted and comes down.
struct Between {
    int a, b;
    Point from, to;
};
/// The connection as a shape of the job leads it, if one does. In `unshaped` stands for that shape why it
/// cannot be, or "".
std::optional<connect::Connection> shaped(const connect::Connection& plain, const Between& ends,
                                          const Job& job, const connect::Options& options,
                                          std::vector<std::string>& unshaped);

}  // namespace strandline::order
