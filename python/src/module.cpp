// strandline._core: what the package's Python files are built on. Its names and types are in _core.pyi.
#include "bridge.hpp"

PYBIND11_MODULE(_core, module) {
    module.doc() = "The library of Strandline for the Python package; use strandline itself.";
    strandline::python::add_errors();
    strandline::python::add_calls(module);
    strandline::python::add_lists(module);
    strandline::python::add_stages(module);
    strandline::python::add_plans(module);
    strandline::python::add_simulation(module);
    module.attr("version") = STRANDLINE_VERSION;
}
