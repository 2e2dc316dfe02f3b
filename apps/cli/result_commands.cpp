// Commands that begin with a finished plan: check, render.
#include <fmt/format.h>

#include <cstdio>

#include "arguments.hpp"
#include "base/text/text.hpp"
#include "commands.hpp"
#include "console.hpp"
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

}  // namespace

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
        warn(plan->warnings, common.quiet);
        for (const std::string& idle : plan->idle_edits) fmt::print(stderr, "warning: {}\n", idle);
        fmt::print("{}{}", summary(*plan, report), fidelity_rows(fidelity));
        fmt::print("{}", findings(report, common.verbose));
        fmt::print("{}", places(*plan, report, common.verbose));
        for (const check::Blemish& b : report.blemishes)
            if (common.verbose)
                fmt::print("blemish: at ({:.2f}, {:.2f}) after {:.0f} s: {}, {} of element {}\n", b.at.x,
                           b.at.y, b.t, counted(b.crossings, "crossing"), square(b.area, 3), b.element);
    }
    return report.sound() ? done : falls_short;
}

int render(const RenderArguments& arguments, const Common&) {
    const bool svg = arguments.output.ends_with(".svg"), png = arguments.output.ends_with(".png"),
               pdf = arguments.output.ends_with(".pdf");
    if (!svg && !png && !pdf)
        return complain({"-o " + arguments.output, "is neither .svg nor .png nor .pdf",
                         "name the picture picture.svg, picture.png or picture.pdf"},
                        bad_call);
#ifndef STRANDLINE_PICTURES
    if (!svg)
        return complain(
            {"-o " + arguments.output, "this program was built without pictures", "render to .svg"},
            bad_call);
#endif
    const auto plan = read_plan_file(arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    Outcome<std::string> bytes;
#ifdef STRANDLINE_PICTURES
    bytes = svg   ? formats::write_svg(*plan)
            : pdf ? picture::pdf(*plan)
                  : picture::png(*plan, {.pixels = arguments.pixels});
#else
    bytes = formats::write_svg(*plan);
#endif
    if (!bytes) return complain(bytes.error(), bad_input);
    const auto written = write_output(arguments.output, *bytes);
    if (!written) return complain(written.error(), bad_input);
    return done;
}

}  // namespace strandline::cli
