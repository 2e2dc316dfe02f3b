// strandline export: a finished plan in the forms of the table.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "console.hpp"
#include "export_formats.hpp"
#include "result/formats/formats.hpp"

namespace strandline::cli {

using exports::Format;

int export_plan(const ExportArguments& arguments, const Common& common) {
    const auto& formats = export_formats();
    const auto format = std::ranges::find(formats, arguments.format, &Format::name);
    if (format == formats.end()) {
        std::string names;
        for (const Format& f : formats) names += (names.empty() ? "" : ", ") + f.name;
        return complain({"--format " + arguments.format, "is not known", "use one of " + names}, bad_call);
    }
    if (format->suffixes.size() > 1 && arguments.output == "-")
        return complain({"--format " + format->name, "writes two files", "name them with -o NAME.txt"},
                        bad_call);
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    auto plan = formats::read_plan(*text, arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    if (const auto set = set_options(plan->options, arguments.configs, arguments.settings); !set)
        return complain(set.error(), bad_call);
    for (const Stop& stop : plan->stops)
        if (!common.quiet && !format->stops)
            fmt::print(
                stderr,
                "note: stop for {} before stroke {}, {:.0f} s after the start; {} has no word for it\n",
                stop.why, stop.stroke, stop.time, format->name);
    const auto written = format->write(*plan, {.robot_path = arguments.path == "robot"});
    if (!written) return complain(written.error(), bad_input);
    warn(written->warnings, common.quiet);
    if (const auto kept = write_files(written->files, arguments.output); !kept)
        return complain(kept.error(), bad_input);
    return done;
}

}  // namespace strandline::cli
