// Plans: made, made again, cut, read and written.
#include <pybind11/stl.h>

#include "calls.hpp"
#include "cli/console.hpp"
#include "plan/parts/parts.hpp"
#include "planned.hpp"
#include "result/formats/formats.hpp"

namespace strandline::python {
namespace {

/// With the drawing's name in front of the place in it.
Error named(Error error, const Workshop& workshop) {
    if (error.place.empty() || error.place == workshop.title)
        error.place = workshop.place;
    else if (error.place != workshop.place)
        error.place = workshop.place + ", " + error.place;
    return error;
}

Planned made(const std::shared_ptr<Workshop>& workshop, const Options& options,
             const std::vector<Edit>& edits, bool draft, const py::object& callback) {
    value(valid(options, workshop->robot));
    auto plan = watched(callback, [&](const Progress& progress) {
        const std::lock_guard lock(workshop->mutex);
        const Source source{workshop->bytes, workshop->title};
        const Progress bounded = cli::limited(progress, options.tour.time_limit, options.tour.threads);
        if (!draft) return workshop->planner.plan(source, workshop->robot, options, edits, bounded);
        return workshop->planner.draft(source, workshop->robot, options, edits, bounded)
            .map([](Draft&& drafted) { return whole(std::move(drafted)); });
    });
    if (!plan) throw Refused{named(plan.error(), *workshop)};
    plan->program = "strandline " STRANDLINE_VERSION;
    plan->warnings.insert(plan->warnings.begin(), workshop->granted.begin(), workshop->granted.end());
    return {std::make_shared<const Plan>(std::move(*plan)), workshop};
}

Planned plan(const py::bytes& bytes, const std::string& title, const std::string& place, const Call& call,
             const std::string& edits, const py::object& callback) {
    Asked wanted = asked(call);
    auto workshop = std::make_shared<Workshop>();
    workshop->bytes = bytes;
    workshop->title = title;
    workshop->place = place;
    workshop->robot = std::move(wanted.robot);
    workshop->granted = std::move(wanted.wishes.warnings);
    std::vector<Edit> all = wanted.wishes.edits;
    for (Edit& edit : value(formats::read_edits(edits, "edits"))) all.push_back(std::move(edit));
    return made(workshop, wanted.wishes.options, all, false, callback);
}

Planned edited(const Planned& old, const std::string& edits,
               const std::vector<std::pair<std::string, std::string>>& settings, bool draft,
               const py::object& callback) {
    if (!old.workshop)
        throw Refused{{old.plan->title, "was read from a file, which does not hold the drawing",
                       "plan the drawing, with these edits"}};
    Options options = old.plan->options;
    for (const auto& [key, text] : settings) value(set(options, key, text));
    return made(old.workshop, options, value(formats::read_edits(edits, "edits")), draft, callback);
}

Planned read(const py::bytes& text, const std::string& place) {
    return {std::make_shared<const Plan>(value(formats::read_plan(std::string(text), place))), nullptr};
}

using From = std::variant<double, std::string, std::pair<double, double>>;

Planned resumed(const Planned& whole, const From& from) {
    value(parts::can_be_cut(*whole.plan));
    const auto place = std::visit(
        [](const auto& at) -> parts::From {
            if constexpr (std::is_same_v<std::decay_t<decltype(at)>, std::pair<double, double>>)
                return Point{at.first, at.second};
            else
                return at;
        },
        from);
    const int first = value(parts::stroke_at(*whole.plan, place));
    return {std::make_shared<const Plan>(
                parts::part(*whole.plan, first, static_cast<int>(whole.plan->strokes.size()))),
            nullptr};
}

std::vector<Planned> split(const Planned& whole, double seconds, double metres) {
    value(parts::can_be_cut(*whole.plan));
    const int strokes = static_cast<int>(whole.plan->strokes.size());
    const std::vector<int> begins = parts::cuts(*whole.plan, {.seconds = seconds, .metres = metres});
    std::vector<Planned> all;
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const int end = k + 1 < begins.size() ? begins[k + 1] : strokes;
        all.push_back({std::make_shared<const Plan>(parts::part(*whole.plan, begins[k], end)), nullptr});
    }
    return all;
}

}  // namespace

void add_plans(py::module_& module) {
    py::class_<Planned> type(module, "Planned", "A finished plan.");
    using py::arg;
    type.def("edited", &edited, arg("edits"), arg("settings"), arg("draft"), arg("progress"))
        .def("resumed", &resumed, arg("start"))
        .def("split", &split, arg("seconds"), arg("metres"));
    add_columns(type);
    add_results(type);
    module.def("plan", &plan, arg("source"), arg("title"), arg("place"), arg("call"), arg("edits"),
               arg("progress"));
    module.def("read_plan", &read, arg("text"), arg("place"));
    module.def(
        "read_file", [](const std::string& path) { return py::bytes(value(cli::read_input(path))); },
        arg("path"));
    module.def(
        "write_file",
        [](const std::string& path, const py::bytes& bytes) {
            value(cli::write_output(path, std::string(bytes)));
        },
        arg("path"), arg("content"));
}

}  // namespace strandline::python
