#pragma once
// Private to the stages' bindings.
#include "bridge.hpp"
#include "cli/commands.hpp"

namespace strandline::python {

struct FillCall {
    cli::FillArguments arguments;
};
/// connect and convert.
void add_drives(py::module_& module);

}  // namespace strandline::python
