#pragma once
#include <functional>

#include "commands.hpp"

namespace CLI {
class App;
}

namespace strandline::cli {

/// tour, fill, connect and convert: each sets `chosen` to what it does with its arguments.
void add_stages(CLI::App& app, TourArguments& t, FillArguments& f, ConnectArguments& c, ConvertArguments& v,
                const Common& common, std::function<int()>& chosen);

}  // namespace strandline::cli
