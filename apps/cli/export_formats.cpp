#include "export_formats.hpp"

#include <utility>

#include "arguments.hpp"
#include "console.hpp"

#ifdef STRANDLINE_PICTURES
#include "result/picture/picture.hpp"
#endif

namespace strandline::cli {
namespace {

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

}  // namespace

const std::vector<Format>& export_formats() {
    static const std::vector<Format> table = make_table();
    return table;
}

Outcome<void> set_options(Options& options, const std::vector<std::string>& configs,
                          const std::vector<std::string>& settings) {
    for (const std::string& config : configs) {
        Wishes wishes;
        wishes.options = options;
        if (auto read = read_settings_file(wishes, config); !read) return read;
        exports::take_export_options(options, wishes.options);
    }
    for (const std::string& text : settings) {
        const auto equals = text.find('=');
        if (equals == std::string::npos)
            return fail("--set " + text, "has no =", "write key=value, as in site.latitude=47.37");
        if (auto set = exports::set_for_export(options, text.substr(0, equals), text.substr(equals + 1));
            !set)
            return set;
    }
    return {};
}

Outcome<std::vector<std::string>> write_files(const std::vector<exports::File>& files,
                                              const std::string& output) {
    std::vector<std::pair<std::string, std::string_view>> outputs;
    const std::string& last = files.back().suffix;
    const std::string extension = last.substr(last.rfind('.'));
    const std::string base =
        output.ends_with(extension) ? output.substr(0, output.size() - extension.size()) : output;
    for (const exports::File& file : files)
        outputs.emplace_back(files.size() == 1 ? output : base + file.suffix, file.bytes);
    const auto written =
        files.size() == 1 ? write_output(output, files.front().bytes) : write_outputs(outputs);
    if (!written) return tl::unexpected(written.error());
    std::vector<std::string> names;
    for (const auto& [name, bytes] : outputs) names.push_back(name);
    return names;
}

}  // namespace strandline::cli
