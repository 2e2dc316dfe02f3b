// simulate: a plan, or a drive of any origin, laid in the sand and held against its drawing.
#include <fmt/format.h>

#include <cstdio>

#include "arguments.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "controller.hpp"
#include "machine/pins/pins.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/fidelity/fidelity.hpp"
#include "result/film/film.hpp"
#include "result/formats/formats.hpp"
#include "summary.hpp"
#ifdef STRANDLINE_PICTURES
#include "result/picture/picture.hpp"
#endif

namespace strandline::cli {
namespace {

/// What is driven, and what it is held against.
struct Subject {
    std::optional<Plan> plan;     ///< of which the drive is
    std::optional<Plan> against;  ///< another one
    Drawing drawing;
    surface::Drive drive;
};

bool is_plan(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

/// The drawing, or the drawing of the plan, of --against.
Outcome<void> read_against(Subject& subject, const SimulateArguments& a, const Wishes& wishes) {
    const auto bytes = read_input(a.against);
    if (!bytes) return tl::unexpected(bytes.error());
    if (is_plan(*bytes)) {
        auto plan = formats::read_plan(*bytes, a.against);
        if (!plan) return tl::unexpected(plan.error());
        subject.drawing = plan->drawing;
        subject.against = std::move(*plan);
        return {};
    }
    auto drawing = drawing_of({*bytes, a.against}, subject.drive.robot, wishes.options);
    if (!drawing) return tl::unexpected(drawing.error());
    subject.drawing = std::move(*drawing);
    return {};
}

Outcome<Subject> read_subject(const SimulateArguments& a, const Wishes& wishes, const Robot& robot) {
    Subject subject;
    const auto text = read_input(a.inputs[0]);
    if (!text) return tl::unexpected(text.error());
    if (is_plan(*text)) {
        if (a.inputs.size() > 1)
            return fail(a.inputs[1], "stands beside a plan", "give a plan alone, or a pair of robot texts");
        auto plan = formats::read_plan(*text, a.inputs[0]);
        if (!plan) return tl::unexpected(plan.error());
        subject.drive = fidelity::drive_of(*plan);
        subject.drawing = plan->drawing;
        subject.plan = std::move(*plan);
        if (!a.against.empty())
            if (const auto read = read_against(subject, a, wishes); !read)
                return tl::unexpected(read.error());
        return subject;
    }
    subject.drive.robot = robot;
    Outcome<std::vector<Sample>> samples;
    if (a.inputs.size() == 2) {
        const auto rake = read_input(a.inputs[1]);
        if (!rake) return tl::unexpected(rake.error());
        samples = formats::read_beachbot(*text, *rake, robot, a.inputs[0], a.inputs[1]);
        // The text says what pins are told.
        if (samples) samples = pins::done(robot, *samples);
    } else {
        samples = formats::read_drive_csv(*text, robot, a.inputs[0]);
    }
    if (!samples) return tl::unexpected(samples.error());
    subject.drive.samples = std::move(*samples);
    subject.drawing.canvas = {wishes.options.canvas.width, wishes.options.canvas.height};
    if (!a.against.empty())
        if (const auto read = read_against(subject, a, wishes); !read) return tl::unexpected(read.error());
    return subject;
}

/// drive-%03d.png -> drive-007.png
std::string numbered(const std::string& path, int number) {
    const std::size_t percent = path.find('%'), end = path.find('d', percent);
    const std::string width = path.substr(percent + 1, end - percent - 1);
    return path.substr(0, percent) + fmt::format("{:0{}}", number, width.empty() ? 1 : std::stoi(width)) +
           path.substr(end + 1);
}
/// Whether the name holds one place for a number: %d, %3d, %04d.
bool is_numbered(const std::string& path) {
    const std::size_t percent = path.find('%'), end = path.find_first_not_of("0123456789", percent + 1);
    constexpr std::size_t most_digits = 3;
    return percent != std::string::npos && end != std::string::npos && path[end] == 'd' &&
           end - percent <= most_digits;
}

Outcome<void> write_film(const SimulateArguments& a, const surface::Drive& drive, const shade::View& view,
                         double cell, const Progress& progress) {
    const film::Options options{.cell = cell, .seconds = a.seconds};
    if (a.output.ends_with(".gif")) {
        const auto bytes = film::gif(drive, view, options, progress);
        if (!bytes) return tl::unexpected(bytes.error());
        return write_output(a.output, *bytes);
    }
#ifdef STRANDLINE_PICTURES
    Outcome<void> done;
    int number = 0;
    film::for_frames(drive, view, options, [&](const film::Frame& frame) {
        const auto bytes = picture::image_png(frame.image);
        done = bytes ? write_output(numbered(a.output, number++), *bytes) : tl::unexpected(bytes.error());
        return done && !progress.stopped();
    });
    return done;
#else
    return fail("-o " + a.output, "this program was built without pictures", "write a .gif");
#endif
}

#ifdef STRANDLINE_PICTURES
Outcome<void> write_flat(const SimulateArguments& a, const surface::Surface& sand, const shade::View& view) {
    const bool film = a.output.ends_with(".gif") || is_numbered(a.output);
    for (const auto& [path, painted] :
         {std::pair{film ? "" : a.output, &picture::sand_png}, {a.flaws, &picture::flaws_png}}) {
        if (path.empty()) continue;
        const auto bytes = painted(sand, view);
        if (!bytes) return tl::unexpected(bytes.error());
        if (const auto written = write_output(path, *bytes); !written) return written;
    }
    return {};
}
#else
Outcome<void> write_flat(const SimulateArguments& a, const surface::Surface&, const shade::View&) {
    if ((a.output.empty() || a.output.ends_with(".gif")) && a.flaws.empty()) return {};
    return fail("-o, --flaws", "this program was built without pictures", "write a .gif");
}
#endif

Outcome<void> write_pictures(const SimulateArguments& a, const surface::Drive& drive,
                             const fidelity::Judged& judged, const Canvas& canvas, const Progress& progress) {
    const shade::View view{{{0, 0}, {canvas.width, canvas.height}}, a.pixels};
    if (!(canvas.width > 0) || !(canvas.height > 0))
        return fail("-o", "the canvas has no extent", "check its size");
    if (const auto written = write_flat(a, judged.sand, view); !written) return written;
    if (a.output.ends_with(".gif") || is_numbered(a.output))
        return write_film(a, drive, view, judged.report.cell, progress);
    return {};
}

}  // namespace

int simulate(const SimulateArguments& arguments, const Common& common) {
    const std::string& output = arguments.output;
    if (!output.empty() && !output.ends_with(".png") && !output.ends_with(".gif"))
        return complain({"-o " + output, "is neither .png nor .gif",
                         "name it sand.png, drive.gif, or drive-%03d.png for a picture an instant"},
                        bad_call);
    const auto wishes = gathered(arguments.wishes);
    if (!wishes) return complain(wishes.error(), bad_call);
    const auto robot = robot_of(*wishes);
    if (!robot) return complain(robot.error(), bad_call);
    fidelity::Options judging;
    if (!arguments.cell.empty()) {
        const auto cell = parse_length(arguments.cell, "--cell");
        if (!cell) return complain(cell.error(), bad_call);
        constexpr double least = 1e-5, most = 1;
        if (!(*cell >= least && *cell <= most))
            return complain({"--cell", "is out of range", "use 0.01mm to 1m"}, bad_call);
        judging.cell = *cell;
    }
    const Progress progress = console_progress(common.quiet);
    auto subject = read_subject(arguments, *wishes, *robot);
    if (!subject) return complain(subject.error(), bad_input);
    surface::Drive& drive = subject->drive;
    formats::Simulated found;
    tracking::Driven driven;
    if (subject->plan && !drive.samples.empty()) found.planned_time = drive.samples.back().t;
    if (arguments.noise || !arguments.log.empty()) {
        if (!subject->plan)
            return complain({"--noise", "needs a plan to follow", "give a plan file"}, bad_call);
        const auto options = controller(arguments, drive.robot);
        if (!options) return complain(options.error(), bad_call);
        driven = tracking::driven(drive.robot, drive.samples, *options, progress);
        found.driven = &driven;
        drive.samples = driven.samples;
        drive.elements = fidelity::elements_of(drive.samples, subject->plan->strokes);
        if (!arguments.log.empty())
            if (const auto written = write_output(arguments.log, formats::write_log(driven)); !written)
                return complain(written.error(), bad_input);
    }
    if (!subject->plan)
        drive.elements = fidelity::elements_drawn(subject->drawing, drive.robot, drive.samples);
    found.time = drive.samples.empty() ? 0 : drive.samples.back().t;
    const fidelity::Judged judged = fidelity::judged(subject->drawing, drive, judging, progress);
    found.fidelity = judged.report;
    if (subject->against) {
        judging.cell = judged.report.cell;
        const surface::Drive own = fidelity::drive_of(*subject->against);
        found.same_sand = surface::intersection_over_union(
            judged.sand, fidelity::judged(subject->drawing, own, judging, progress).sand);
    }
    if (const auto written = write_pictures(arguments, drive, judged, subject->drawing.canvas, progress);
        !written)
        return complain(written.error(), bad_input);
    if (common.json)
        fmt::print("{}", formats::write_fidelity(found));
    else if (!common.quiet)
        fmt::print("{}", simulated(found, common.verbose));
    return driven.lost ? falls_short : done;
}

}  // namespace strandline::cli
