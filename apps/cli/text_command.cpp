// strandline text: words -> SVG of single lines; and the list of fonts.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/text/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "fonts.hpp"

namespace strandline::cli {
namespace {

int list_fonts(const Common& common) {
    const auto fonts = installed_fonts();
    if (!fonts) return complain(fonts.error(), bad_input);
    std::string items;
    for (const FontEntry& font : *fonts) {
        if (!common.json)
            fmt::print("{:<12} {}\n", font.name, font.what);
        else
            items += (items.empty() ? "\n" : ",\n") +
                     nlohmann::ordered_json{{"name", font.name}, {"what", font.what}}.dump();
    }
    if (common.json) fmt::print("[{}\n]\n", items);
    return done;
}

}  // namespace

int text(const TextArguments& arguments, const Common& common) {
    if (arguments.list) return list_fonts(common);
    if (arguments.lettering.text.empty())
        return complain({"text", "is missing", "write for example strandline text \"Hello\" -o hello.svg"},
                        bad_call);
    const auto document = lettered(arguments.lettering);
    if (!document) return complain(document.error(), fault_of(document.error()));
    const auto written = write_output(arguments.output, svg::write(*document));
    if (!written) return complain(written.error(), bad_input);
    warn(document->warnings, common.quiet);
    const Point size = *document->size_metres;
    if (common.json)
        fmt::print(arguments.output == "-" ? stderr : stdout,
                   "{{\"strokes\":{},\"width\":{},\"height\":{}}}\n", document->shapes.size(), size.x,
                   size.y);
    else if (!common.quiet)
        fmt::print(stderr, "{}, {:.4g} m x {:.4g} m\n", counted(document->shapes.size(), "stroke"), size.x,
                   size.y);
    return done;
}

}  // namespace strandline::cli
