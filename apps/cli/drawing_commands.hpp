#pragma once
#include <functional>

#include "commands.hpp"

namespace CLI {
class App;
}

namespace strandline::cli {

/// plan (one drawing or a batch), text and trace: each sets `chosen` to what it does with its arguments.
void add_drawings(CLI::App& app, PlanArguments& plan, BatchArguments& batch, TextArguments& text,
                  TraceArguments& trace, const Common& common, std::function<int()>& chosen);

}  // namespace strandline::cli
