#pragma once
// What a call of plan asks for.
#include <optional>
#include <string>

#include "bridge.hpp"
#include "cli/arguments.hpp"

namespace strandline::python {

struct Call {
    cli::PlanArguments arguments;
    std::optional<std::string> profile = {};  ///< the robot as TOML, in the place of its name
};
struct Asked {
    cli::Wishes wishes;
    Robot robot;
};
/// Refused as the command line refuses.
Asked asked(const Call& call);
/// By its name or the name of its file; or from a profile's text.
Robot robot_of(const std::string& name, const std::optional<std::string>& profile);

}  // namespace strandline::python
