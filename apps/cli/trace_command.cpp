// strandline trace: what of a picture would be planned, as SVG.
#include <fmt/format.h>

#include "arguments.hpp"
#include "base/text/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline::cli {
namespace {

Outcome<Options> options_of(const TraceArguments& arguments) {
    Wishes wishes;
    Outcome<void> done;
    if (!arguments.threshold.empty()) done = set(wishes.options, "trace.threshold", arguments.threshold);
    if (done && arguments.invert) done = set(wishes.options, "ink.invert", "on");
    for (const std::string& text : arguments.settings)
        if (done) done = set_from_text(wishes, text);
    if (!done) return tl::unexpected(done.error());
    return wishes.options;
}

}  // namespace

int trace(const TraceArguments& arguments, const Common& common) {
    const auto options = options_of(arguments);
    if (!options) return complain(options.error(), bad_call);
    if (same_file(arguments.input, arguments.output))
        return complain({"-o " + arguments.output, "is the picture itself", "choose another name"}, bad_call);
    const auto bytes = read_input(arguments.input);
    if (!bytes) return complain(bytes.error(), bad_input);
    auto traced = trace_source({*bytes, arguments.input}, *options, console_progress(common.quiet));
    if (!traced) {
        traced.error().place = arguments.input;
        return complain(traced.error(), bad_input);
    }
    const auto written = write_output(arguments.output, svg::write(traced->document));
    if (!written) return complain(written.error(), bad_input);
    warn(traced->document.warnings, common.quiet);
    const Box view = traced->document.view;
    const std::size_t regions = traced->document.shapes.size();
    if (common.json)
        fmt::print(arguments.output == "-" ? stderr : stdout,
                   "{{\"width\":{},\"height\":{},\"threshold\":{:.4f},\"regions\":{},\"holes\":{}}}\n",
                   view.width(), view.height(), traced->threshold, regions, traced->holes);
    else if (!common.quiet)
        fmt::print(stderr, "{} x {} pixels, threshold {:.3f}{}: {}, {}\n", view.width(), view.height(),
                   traced->threshold, options->trace.threshold == 0 ? " (found)" : "",
                   counted(regions, "region"), counted(traced->holes, "hole"));
    return done;
}

}  // namespace strandline::cli
