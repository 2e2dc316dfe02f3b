// A plan driven and laid in the sand.
#include <pybind11/stl.h>

#include <cmath>
#include <memory>

#include "base/units/units.hpp"
#include "cli/controller.hpp"
#include "planned.hpp"
#include "result/fidelity/fidelity.hpp"
#include "result/film/film.hpp"
#include "result/formats/formats.hpp"
#include "result/picture/picture.hpp"

namespace strandline::python {
namespace {

struct Simulation {
    Canvas canvas;
    surface::Drive drive;
    std::shared_ptr<const fidelity::Judged> judged;  ///< a surface cannot be copied
    std::string report;
    std::optional<tracking::Driven> driven;  ///< absent: the plan itself was laid, exactly
};

/// As the program's `simulate`; `controlled`: a controller drives, with what the arguments say of it.
Simulation simulated(const Planned& planned, double cell, bool controlled,
                     const cli::SimulateArguments& arguments, const py::object& callback) {
    const Plan& plan = *planned.plan;
    const tracking::Options options =
        controlled ? value(cli::controller(arguments, plan.robot)) : tracking::Options{};
    return watched(callback, [&](const Progress& progress) {
        Simulation s{plan.drawing.canvas, fidelity::drive_of(plan), {}, {}, {}};
        formats::Simulated found;
        if (!s.drive.samples.empty()) found.planned_time = s.drive.samples.back().t;
        if (controlled) {
            s.driven = tracking::driven(plan.robot, s.drive.samples, options, progress);
            s.drive.samples = s.driven->samples;
            s.drive.elements = fidelity::elements_of(s.drive.samples, plan.strokes);
            found.driven = &*s.driven;
        }
        s.judged = std::make_shared<const fidelity::Judged>(
            fidelity::judged(plan.drawing, s.drive, {.cell = cell}, progress));
        found.fidelity = s.judged->report;
        found.time = s.drive.samples.empty() ? 0 : s.drive.samples.back().t;
        s.report = formats::write_fidelity(found);
        return s;
    });
}

Simulation simulate(const Planned& planned, double cell, bool controlled, std::optional<double> noise,
                    std::optional<double> wander, std::optional<double> delay, unsigned long long seed,
                    bool late_pins, const py::object& callback) {
    constexpr double least = 1e-5, most = 1;
    if (cell != 0 && !(cell >= least && cell <= most))
        throw Refused{{"cell", "is out of range", "use 0.00001 to 1 m, or 0"}};
    cli::SimulateArguments arguments;
    if (noise) arguments.noise = number_text(*noise);
    if (wander) arguments.wander = number_text(*wander);
    if (delay) arguments.delay = number_text(*delay);
    arguments.seed = seed;
    arguments.late_pins = late_pins;
    return simulated(planned, cell, controlled, arguments, callback);
}

/// Cells of the canvas by row from its lower edge.
template <class Number, class Get>
py::array_t<Number> cells(const Simulation& s, Get get) {
    const double cell = s.judged->sand.cell_size();
    const auto count = [cell](double side) {
        return static_cast<py::ssize_t>(std::ceil(side / cell - 1e-9));
    };
    py::array_t<Number> array({count(s.canvas.height), count(s.canvas.width)});
    auto out = array.template mutable_unchecked<2>();
    for (py::ssize_t j = 0; j < out.shape(0); ++j)
        for (py::ssize_t i = 0; i < out.shape(1); ++i)
            out(j, i) = get(s.judged->sand, static_cast<int>(i), static_cast<int>(j));
    return array;
}

py::array_t<std::uint8_t> bits(const Simulation& s) {
    return cells<std::uint8_t>(s, [](const surface::Surface& sand, int i, int j) {
        return static_cast<std::uint8_t>(sand.bits(i, j));
    });
}

py::array_t<std::int8_t> heights(const Simulation& s) {
    return cells<std::int8_t>(s, [](const surface::Surface& sand, int i, int j) {
        const surface::Tile* tile = sand.find_tile(i, j);
        return tile == nullptr ? std::int8_t{0} : tile->height[surface::Surface::place_in_tile(i, j)];
    });
}

shade::View view_of(const Simulation& s, int pixels) {
    constexpr int least = 16, most = 16000;
    if (pixels < least || pixels > most) throw Refused{{"pixels", "is out of range", "use 16 to 16000"}};
    return {{{0, 0}, {s.canvas.width, s.canvas.height}}, pixels};
}

/// (rows, columns, 3) from the upper left.
py::array_t<std::uint8_t> image(const Simulation& s, int pixels, bool flaws) {
    const shade::View view = view_of(s, pixels);
    const shade::Image image = [&] {
        const py::gil_scoped_release released;
        return flaws ? shade::flaws(s.judged->sand, view) : shade::sand(s.judged->sand, view);
    }();
    py::array_t<std::uint8_t> array({py::ssize_t{image.rows}, py::ssize_t{image.columns}, py::ssize_t{3}});
    std::uint8_t* out = array.mutable_data();
    for (const shade::Rgb& pixel : image.pixels)
        for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b}) *out++ = channel;
    return array;
}

py::bytes png(const Simulation& s, int pixels, bool flaws) {
    const shade::View view = view_of(s, pixels);
    auto bytes = [&] {
        const py::gil_scoped_release released;
        return flaws ? picture::flaws_png(s.judged->sand, view) : picture::sand_png(s.judged->sand, view);
    }();
    return py::bytes(value(std::move(bytes)));
}

py::bytes gif(const Simulation& s, int pixels, double seconds, const py::object& callback) {
    const shade::View view = view_of(s, pixels);
    constexpr double least = 0.5, most = 3600;
    if (!(seconds >= least && seconds <= most))
        throw Refused{{"seconds", "is out of range", "use 0.5 to 3600"}};
    return py::bytes(value(watched(callback, [&](const Progress& progress) {
        return film::gif(s.drive, view, {.cell = s.judged->report.cell, .seconds = seconds}, progress);
    })));
}

/// A tick a row; empty where no controller drove.
py::dict log(const Simulation& s) {
    using tracking::LogLine;
    const std::vector<LogLine> none;
    const std::vector<LogLine>& lines = s.driven ? s.driven->log : none;
    py::dict columns;
    const auto add = [&](const char* name, auto get) { columns[name] = column<double>(lines, get); };
    add("t", [](const LogLine& l) { return l.t; });
    add("planned_t", [](const LogLine& l) { return l.planned_t; });
    add("x", [](const LogLine& l) { return l.real.at.x; });
    add("y", [](const LogLine& l) { return l.real.at.y; });
    add("heading", [](const LogLine& l) { return l.real.heading; });
    add("v", [](const LogLine& l) { return l.speed; });
    add("omega", [](const LogLine& l) { return l.turn_rate; });
    add("rake_x", [](const LogLine& l) { return l.rake.x; });
    add("rake_y", [](const LogLine& l) { return l.rake.y; });
    add("off", [](const LogLine& l) { return l.off; });
    columns["pins"] = column<std::uint32_t>(lines, [](const LogLine& l) { return l.mask; });
    return columns;
}

}  // namespace

void add_simulation(py::module_& module) {
    using py::arg;
    py::class_<Simulation>(module, "Simulation", "What a drive left in the sand.")
        .def_property_readonly("cell", [](const Simulation& s) { return s.judged->report.cell; })
        .def_property_readonly("lost", [](const Simulation& s) { return s.driven && s.driven->lost; })
        .def("report_json", [](const Simulation& s) { return s.report; })
        .def("bits", &bits)
        .def("heights", &heights)
        .def("log", &log)
        .def("image", &image, arg("pixels"), arg("flaws"))
        .def("png", &png, arg("pixels"), arg("flaws"))
        .def("gif", &gif, arg("pixels"), arg("seconds"), arg("progress"));
    module.def("simulate", &simulate, arg("plan"), arg("cell"), arg("controlled"), arg("noise"),
               arg("wander"), arg("delay"), arg("seed"), arg("late_pins"), arg("progress"));
}

}  // namespace strandline::python
