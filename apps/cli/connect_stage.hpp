#pragma once
// The stage `connect` by itself, for the program and the Python module.
#include <optional>
#include <string>

#include "result/stages/stages.hpp"

namespace strandline::cli {

/// Error: the names that there are.
Outcome<connect::Style> style_of(const std::string& name);

/// A pair's own curve, or one round its obstacles where that one comes too near to them.
struct Led {
    connect::Connection connection;
    bool round = false;
    std::optional<std::string> failure = {};  ///< still too near
};
Led led_round(const stages::Pair& pair, connect::Connection direct);

}  // namespace strandline::cli
