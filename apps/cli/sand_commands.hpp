#pragma once
#include <functional>

#include "commands.hpp"

namespace CLI {
class App;
}

namespace strandline::cli {

/// simulate, resume and split: each sets `chosen` to what it does with its arguments.
void add_sand(CLI::App& app, SimulateArguments& simulate, ResumeArguments& resume, SplitArguments& split,
              const Common& common, std::function<int()>& chosen);

}  // namespace strandline::cli
