// strandline export: a finished plan in the forms of the table.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "arguments.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "export_formats.hpp"
#include "result/formats/formats.hpp"
#ifdef STRANDLINE_PICTURES
#include "result/picture/picture.hpp"
#endif

namespace strandline::cli {
namespace {

using exports::File;
using exports::Format;
using exports::Written;

#ifdef STRANDLINE_PICTURES
Outcome<Written> picture_file(const char* suffix, Outcome<std::string> bytes) {
    if (!bytes) return tl::unexpected(bytes.error());
    return Written{{{suffix, std::move(*bytes)}}, {}};
}
#endif

std::vector<Format> make_table() {
    std::vector<Format> all = exports::table();
#ifdef STRANDLINE_PICTURES
    all.push_back(
        {"pdf",
         "picture for paper: rake down black at true width, rake up red, to a round scale",
         {".pdf"},
         "application/pdf",
         false,
         [](const Plan& plan, const exports::Choice&) { return picture_file(".pdf", picture::pdf(plan)); }});
    all.push_back(
        {"png",
         "picture: rake down black at true width, rake up red",
         {".png"},
         "image/png",
         false,
         [](const Plan& plan, const exports::Choice&) { return picture_file(".png", picture::png(plan)); }});
#endif
    return all;
}

/// Settings files first, the command line over them, both over the plan's own.
Outcome<void> set_options(Options& options, const ExportArguments& arguments) {
    for (const std::string& config : arguments.configs) {
        Wishes wishes;
        wishes.options = options;
        if (auto read = read_settings_file(wishes, config); !read) return read;
        exports::take_export_options(options, wishes.options);
    }
    for (const std::string& text : arguments.settings) {
        const auto equals = text.find('=');
        if (equals == std::string::npos)
            return fail("--set " + text, "has no =", "write key=value, as in site.latitude=47.37");
        if (auto set = exports::set_for_export(options, text.substr(0, equals), text.substr(equals + 1));
            !set)
            return set;
    }
    return {};
}

Outcome<void> write_files(const std::vector<File>& files, const ExportArguments& arguments) {
    if (files.size() == 1) return write_output(arguments.output, files.front().bytes);
    // The pair: NAME.txt gives NAME_robot.txt and NAME_rake.txt.
    const std::string& last = files.back().suffix;
    const std::string extension = last.substr(last.rfind('.'));
    const std::string base = arguments.output.ends_with(extension)
                                 ? arguments.output.substr(0, arguments.output.size() - extension.size())
                                 : arguments.output;
    std::vector<std::pair<std::string, std::string_view>> outputs;
    for (const File& file : files) outputs.emplace_back(base + file.suffix, file.bytes);
    return write_outputs(outputs);
}

}  // namespace

const std::vector<Format>& export_formats() {
    static const std::vector<Format> table = make_table();
    return table;
}

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
    if (const auto set = set_options(plan->options, arguments); !set) return complain(set.error(), bad_call);
    for (const Stop& stop : plan->stops)
        if (!common.quiet && !format->stops)
            fmt::print(
                stderr,
                "note: stop for {} before stroke {}, {:.0f} s after the start; {} has no word for it\n",
                stop.why, stop.stroke, stop.time, format->name);
    const auto written = format->write(*plan, {.robot_path = arguments.path == "robot"});
    if (!written) return complain(written.error(), bad_input);
    warn(written->warnings, common.quiet);
    if (const auto kept = write_files(written->files, arguments); !kept)
        return complain(kept.error(), bad_input);
    return done;
}

}  // namespace strandline::cli
