// Single stages on NumPy arrays: fill and tour. What they are given comes as the stage commands' JSON, so
// that it is judged by the same readers.
#include <pybind11/stl.h>

#include <optional>

#include "calls.hpp"
#include "cli/console.hpp"
#include "cli/fill_stage.hpp"
#include "stage_parts.hpp"

namespace strandline::python {
namespace {

std::optional<Robot> vehicle_of(const std::string& name, const std::optional<std::string>& profile) {
    if (!profile && name == "free") return {};
    return robot_of(name, profile);
}

struct FillAnswer {
    cli::Filled filled;
    std::string account;
    Warnings warnings;
};

py::tuple fill(const std::string& polygon, const FillCall& call, const std::string& vehicle,
               const std::optional<std::string>& profile, const py::object& callback) {
    const stages::FillTask task = value(stages::read_polygon(polygon, "polygon"));
    const cli::FillAsked asked = value(cli::fill_asked(call.arguments, vehicle_of(vehicle, profile)));
    const FillAnswer answer = value(watched(callback, [&](const Progress& progress) -> Outcome<FillAnswer> {
        FillAnswer made{{}, {}, task.warnings};
        auto filled = cli::filled(asked, task, "polygon", made.warnings, progress);
        if (!filled) return tl::unexpected(filled.error());
        made.filled = std::move(*filled);
        made.account = stages::write_account(cli::account_of(made.filled, task));
        return made;
    }));
    py::list moves;
    for (const rake::Move& move : answer.filled.moves)
        moves.append(py::make_tuple(array_of(move.line), move.mask));
    return py::make_tuple(moves, answer.account, pairs_of(answer.warnings));
}

struct TourAnswer {
    tour::Tour tour;
    std::optional<tour::Entries> entries;
};

py::dict tour(const std::string& instance_text, const std::string& method, bool grouped, bool on_edges,
              int threads, std::uint64_t seed, std::uint64_t moves, double time_limit,
              const py::object& callback) {
    const auto known = tour::method_named(method);
    if (!known) throw Refused{{"method", "is \"" + method + "\"", "use best, exact, nearest or file"}};
    const stages::Instance instance = value(stages::read_instance(instance_text, "tour"));
    const tour::Options options{
        .method = *known, .grouped = grouped, .threads = threads, .seed = seed, .moves = moves};
    const TourAnswer answer = value(watched(callback, [&](const Progress& progress) -> Outcome<TourAnswer> {
        auto tour =
            tour::solve(instance.problem, options, cli::limited(progress, time_limit * threads, threads));
        if (!tour) return tl::unexpected(tour.error());
        TourAnswer found{std::move(*tour), {}};
        if (on_edges) found.entries = tour::entered_on_edges(instance.problem, found.tour.steps);
        return found;
    }));
    const tour::Tour& found = answer.tour;
    py::dict result;
    using tour::Step;
    result["order"] = column<std::int32_t>(found.steps, [](const Step& s) { return s.element; });
    result["entry"] = column<std::int32_t>(found.steps, [](const Step& s) { return s.entry; });
    result["reversed"] = column<bool>(found.steps, [](const Step& s) { return s.reversed; });
    result["length"] = found.length;
    result["proven_optimal"] = found.proven_optimal;
    result["reproducible"] = !found.stopped;
    result["moves"] = found.moves;
    result["at"] = answer.entries ? py::object(array_of(answer.entries->at)) : py::none();
    result["length_on_edges"] = answer.entries ? py::object(py::float_(answer.entries->length)) : py::none();
    return result;
}

}  // namespace

void add_stages(py::module_& module) {
    using py::arg;
    py::class_<FillCall> type(module, "FillCall",
                              "How an area is to be raked: texts as on the command line.");
    type.def(py::init<>());
    const auto text = [&](const char* name, std::string cli::FillArguments::*field) {
        type.def_property(
            name, [field](const FillCall& call) { return call.arguments.*field; },
            [field](FillCall& call, std::string given) { call.arguments.*field = std::move(given); });
    };
    text("width", &cli::FillArguments::width);
    text("style", &cli::FillArguments::style);
    text("spacing", &cli::FillArguments::spacing);
    text("inset", &cli::FillArguments::inset);
    text("join", &cli::FillArguments::join);
    text("direction", &cli::FillArguments::direction);
    text("partition", &cli::FillArguments::partition);
    text("cuts", &cli::FillArguments::cuts);
    text("segments", &cli::FillArguments::segments);
    text("narrow", &cli::FillArguments::narrow);
    type.def_property(
            "shift", [](const FillCall& c) { return c.arguments.shift; },
            [](FillCall& c, double given) { c.arguments.shift = given; })
        .def_property(
            "one_stroke", [](const FillCall& c) { return c.arguments.one_stroke; },
            [](FillCall& c, bool given) { c.arguments.one_stroke = given; })
        .def_property(
            "pins", [](const FillCall& c) { return c.arguments.pins; },
            [](FillCall& c, std::optional<int> given) { c.arguments.pins = given; });
    module.def("fill", &fill, arg("polygon"), arg("call"), arg("vehicle"), arg("profile"), arg("progress"));
    module.def("tour", &tour, arg("instance"), arg("method"), arg("grouped"), arg("on_edges"), arg("threads"),
               arg("seed"), arg("moves"), arg("time_limit"), arg("progress"));
    add_drives(module);
}

}  // namespace strandline::python
