// What follows from a plan: figures, proof, pictures, exports.
#include <pybind11/stl.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/export_formats.hpp"
#include "planned.hpp"
#include "result/check/check.hpp"
#include "result/fidelity/fidelity.hpp"
#include "result/formats/formats.hpp"
#include "result/picture/picture.hpp"

namespace strandline::python {
namespace {

std::string check_json(const Planned& planned, const py::object& callback) {
    const Plan& plan = *planned.plan;
    return watched(callback, [&](const Progress& progress) {
        const check::Report report = check::prove(plan, {}, progress);
        const bool readable = report.faults.empty() || report.faults.front().law > check::Law::finite;
        const fidelity::Report fidelity =
            readable ? fidelity::judged(plan.drawing, fidelity::drive_of(plan), {}, progress).report
                     : fidelity::Report{};
        return formats::write_report(report, &fidelity);
    });
}

/// What all of it that needs no search is made like: off the GIL.
template <class Make>
py::bytes bytes_of(const Make& make) {
    auto bytes = [&] {
        const py::gil_scoped_release released;
        return make();
    }();
    return py::bytes(value(std::move(bytes)));
}

const exports::Format& format_named(const std::string& name) {
    const auto& formats = cli::export_formats();
    const auto found = std::ranges::find(formats, name, &exports::Format::name);
    if (found != formats.end()) return *found;
    std::string names;
    for (const exports::Format& f : formats) names += (names.empty() ? "" : ", ") + f.name;
    throw Refused{{"format " + name, "is not known", "use one of " + names}};
}

/// (files, warnings): suffix and bytes of each where `path` is empty, else the names that were written.
py::tuple exported(const Planned& planned, const std::string& format_name, const std::string& path,
                   bool robot_path, const std::vector<std::string>& configs,
                   const std::vector<std::string>& settings) {
    const exports::Format& format = format_named(format_name);
    auto written = [&]() -> Outcome<exports::Written> {
        const py::gil_scoped_release released;
        Plan plan = *planned.plan;
        if (auto set = cli::set_options(plan.options, configs, settings); !set)
            return tl::unexpected(set.error());
        auto result = format.write(plan, {.robot_path = robot_path});
        if (result && !format.stops)
            for (const Stop& stop : plan.stops)
                result->warnings.push_back({"stop for " + stop.why, format.name + " has no word for it"});
        return result;
    }();
    const exports::Written done = value(std::move(written));
    py::list files;
    if (path.empty())
        for (const exports::File& file : done.files)
            files.append(py::make_tuple(file.suffix, py::bytes(file.bytes)));
    else
        for (const std::string& name : value(cli::write_files(done.files, path))) files.append(name);
    return py::make_tuple(files, pairs_of(done.warnings));
}

py::dict settings_of(const Planned& planned) {
    py::dict all;
    for (const Setting& s : settings()) all[py::str(s.key)] = get(planned.plan->options, s.key);
    return all;
}

}  // namespace

void add_results(py::class_<Planned>& type) {
    using py::arg;
    type.def_property_readonly("title", [](const Planned& p) { return p.plan->title; })
        .def_property_readonly("warnings", [](const Planned& p) { return pairs_of(p.plan->warnings); })
        .def_property_readonly("idle_edits", [](const Planned& p) { return p.plan->idle_edits; })
        .def_property_readonly("canvas",
                               [](const Planned& p) {
                                   const Canvas& c = p.plan->drawing.canvas;
                                   return py::make_tuple(c.width, c.height);
                               })
        .def("settings", &settings_of)
        .def("figures_json", [](const Planned& p) { return formats::write_figures(*p.plan); })
        .def("robot_json", [](const Planned& p) { return formats::write_robot_json(p.plan->robot); })
        .def("edits_json", [](const Planned& p) { return formats::write_edits(p.plan->edits); })
        .def("check_json", &check_json, arg("progress"))
        .def("exported", &exported, arg("format"), arg("path"), arg("robot_path"), arg("configs"),
             arg("settings"))
        .def("plan_text",
             [](const Planned& p) {
                 return bytes_of([&] { return Outcome<std::string>(formats::write_plan(*p.plan)); });
             })
        .def("svg",
             [](const Planned& p) {
                 return bytes_of([&] { return Outcome<std::string>(formats::write_svg(*p.plan)); });
             })
        .def(
            "png",
            [](const Planned& p, int pixels) {
                return bytes_of([&] { return picture::png(*p.plan, {.pixels = pixels}); });
            },
            arg("pixels"));
}

}  // namespace strandline::python
