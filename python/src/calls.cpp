// What a call of plan asks for, as the command line has it: Call and Wishes.
#include "calls.hpp"

#include <pybind11/stl.h>

namespace strandline::python {

Robot robot_of(const std::string& name, const std::optional<std::string>& profile) {
    return profile ? value(read_robot(*profile, "robot")) : value(cli::robot_named(name));
}

Asked asked(const Call& call) {
    Asked asked{value(cli::gathered(call.arguments)), {}};
    if (call.profile) asked.wishes.profile = call.profile;
    asked.robot = value(cli::robot_of(asked.wishes));
    return asked;
}

void add_calls(py::module_& module) {
    py::class_<Call> type(module, "Call", "What a call asks for: texts as on the command line.");
    type.def(py::init<>());
    const auto text = [&](const char* name, std::string cli::PlanArguments::*field) {
        type.def_property(
            name, [field](const Call& call) { return call.arguments.*field; },
            [field](Call& call, std::string given) { call.arguments.*field = std::move(given); });
    };
    using Texts = std::vector<std::string>;
    const auto texts = [&](const char* name, Texts cli::PlanArguments::*field) {
        type.def_property(
            name, [field](const Call& call) { return call.arguments.*field; },
            [field](Call& call, Texts given) { call.arguments.*field = std::move(given); });
    };
    text("robot", &cli::PlanArguments::robot);
    text("canvas", &cli::PlanArguments::canvas);
    text("place", &cli::PlanArguments::place);
    text("margin", &cli::PlanArguments::margin);
    text("start", &cli::PlanArguments::start);
    text("end", &cli::PlanArguments::end);
    text("park", &cli::PlanArguments::park);
    text("exit", &cli::PlanArguments::exit);
    text("border", &cli::PlanArguments::border);
    texts("keep_outs", &cli::PlanArguments::keep_outs);
    texts("configs", &cli::PlanArguments::configs);
    texts("settings", &cli::PlanArguments::settings);
    type.def_readwrite("profile", &Call::profile);
}

}  // namespace strandline::python
