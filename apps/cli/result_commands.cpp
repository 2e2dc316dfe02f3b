// Commands that begin with a finished plan: export, check, render.
#include <fmt/format.h>

#include <cstdio>

#include "arguments.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "export_formats.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"
#include "summary.hpp"
#ifdef STRANDLINE_PICTURES
#include "result/picture/picture.hpp"
#endif

namespace strandline::cli {
namespace {

Outcome<Plan> read_plan_file(const std::string& path) {
    const auto text = read_input(path);
    if (!text) return tl::unexpected(text.error());
    return formats::read_plan(*text, path);
}

int write_pair(const Plan& plan, const std::string& output) {
    const formats::BeachbotPair pair = formats::write_beachbot(plan);
    if (output == "-")
        return complain({"--format beachbot", "writes two files", "name them with -o NAME.txt"}, bad_call);
    const std::string base = output.ends_with(".txt") ? output.substr(0, output.size() - 4) : output;
    const auto written = write_outputs({{base + "_robot.txt", pair.robot}, {base + "_rake.txt", pair.rake}});
    if (!written) return complain(written.error(), bad_input);
    return done;
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
    static const std::vector<ExportFormat> table{
        {"beachbot", "the pair NAME_robot.txt, NAME_rake.txt: x y mask, metres, a line an instant", {}},
        {"trace", "what is drawn and driven as polylines (JSON), for measuring",
         [](const Plan& plan, const ExportArguments& a) {
             return formats::write_trace(plan, a.path == "robot");
         }},
        {"csv", "a line a sample: s, t, x, y, heading, curvature, speed, turn rate, pins, rake",
         [](const Plan& plan, const ExportArguments&) { return formats::write_csv(plan); }},
        {"svg", "picture: rake down black at true width, rake up red",
         [](const Plan& plan, const ExportArguments&) { return formats::write_svg(plan); }},
    };
    return table;
}

int export_plan(const ExportArguments& arguments, const Common& common) {
    const ExportFormat* format = nullptr;
    std::string names;
    for (const ExportFormat& f : export_formats()) {
        if (f.name == arguments.format) format = &f;
        names += (names.empty() ? "" : ", ") + f.name;
    }
    if (!format)
        return complain({"--format " + arguments.format, "is not known", "use one of " + names}, bad_call);
    const auto plan = read_plan_file(arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    // The plan and its picture know of stops, robot texts do not.
    for (const Stop& stop : plan->stops)
        if (!common.quiet)
            fmt::print(
                stderr,
                "note: stop for {} before stroke {}, {:.0f} s after the start; {} has no word for it\n",
                stop.why, stop.stroke, stop.time, format->name);
    if (format->name == "beachbot") return write_pair(*plan, arguments.output);
    const auto written = write_output(arguments.output, format->write(*plan, arguments));
    if (!written) return complain(written.error(), bad_input);
    return done;
}

int check(const CheckArguments& arguments, const Common& common) {
    const auto plan = read_plan_file(arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    const check::Report report = check::prove(*plan);  // Ctrl-C ends it: half a proof is none
    const bool readable = report.faults.empty() || report.faults.front().law > check::Law::finite;
    const fidelity::Report fidelity =
        readable ? fidelity::judged(plan->drawing, fidelity::drive_of(*plan)).report : fidelity::Report{};
    if (common.json) {
        fmt::print("{}", formats::write_report(report, &fidelity));
    } else if (!common.quiet) {
        fmt::print("{}{}", summary(*plan, report), fidelity_rows(fidelity));
        fmt::print("{}", findings(report, common.verbose));
        if (common.verbose) fmt::print("{}", places(*plan, report));
        for (const check::Blemish& b : report.blemishes)
            if (common.verbose)
                fmt::print(
                    "blemish: at ({:.2f}, {:.2f}) after {:.0f} s: {} crossings, {:.3f} m^2 of element {}\n",
                    b.at.x, b.at.y, b.t, b.crossings, b.area, b.element);
    }
    return report.sound() ? done : falls_short;
}

int render(const RenderArguments& arguments, const Common&) {
    const bool svg = arguments.output.ends_with(".svg"), png = arguments.output.ends_with(".png");
    if (!svg && !png)
        return complain({"-o " + arguments.output, "is neither .svg nor .png",
                         "name the picture picture.svg or picture.png"},
                        bad_call);
#ifndef STRANDLINE_PICTURES
    if (png)
        return complain(
            {"-o " + arguments.output, "this program was built without pictures", "render to .svg"},
            bad_call);
#endif
    const auto plan = read_plan_file(arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    Outcome<std::string> bytes;
#ifdef STRANDLINE_PICTURES
    bytes = svg ? formats::write_svg(*plan) : picture::png(*plan, {.pixels = arguments.pixels});
#else
    bytes = formats::write_svg(*plan);
#endif
    if (!bytes) return complain(bytes.error(), bad_input);
    const auto written = write_output(arguments.output, *bytes);
    if (!written) return complain(written.error(), bad_input);
    return done;
}

}  // namespace strandline::cli
