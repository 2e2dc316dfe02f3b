// `strandline connect`: curves between pairs of poses, a line a pair.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text/text.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "connect_stage.hpp"
#include "console.hpp"

namespace strandline::cli {
namespace {

Outcome<stages::PairDefaults> defaults_of(const ConnectArguments& arguments) {
    stages::PairDefaults defaults;
    if (!arguments.radius.empty()) {
        const auto radius = parse_length(arguments.radius, "--radius");
        if (!radius) return tl::unexpected(radius.error());
        if (!(*radius > 0)) return fail("--radius", "is not above 0", "write a length such as 0.5m");
        defaults.radius = *radius;
    }
    if (arguments.sharpness && !(*arguments.sharpness > 0 && std::isfinite(*arguments.sharpness)))
        return fail("--sharpness", "is not above 0", "write 1/m^2, such as 10");
    defaults.sharpness = arguments.sharpness;
    return defaults;
}

Outcome<std::vector<stages::Pair>> read_pairs(std::string_view text, const std::string& name,
                                              const stages::PairDefaults& defaults) {
    std::vector<stages::Pair> pairs;
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        at = end + 1;
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        auto pair = stages::read_pair(line, number, defaults);
        if (!pair) {
            Error error = pair.error();
            error.place = (name == "-" ? "stdin" : name) + ", " + error.place;
            return tl::unexpected(error);
        }
        pairs.push_back(std::move(*pair));
    }
    if (pairs.empty()) return fail(name, "holds no pair", "write a JSON object a line");
    return pairs;
}

}  // namespace

int connect(const ConnectArguments& arguments, const Common& common) {
    const auto style = style_of(arguments.style);
    if (!style) return complain(style.error(), bad_call);
    if (!(arguments.extra_length >= 0 && arguments.extra_length <= 10))
        return complain({"--extra-length", "is not within 0 to 10", "write a share, such as 0.1"}, bad_call);
    const auto defaults = defaults_of(arguments);
    if (!defaults) return complain(defaults.error(), bad_call);
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto pairs = read_pairs(*text, arguments.input, *defaults);
    if (!pairs) return complain(pairs.error(), bad_input);

    std::set<std::string> unknown;
    for (const stages::Pair& pair : *pairs) unknown.insert(pair.unknown.begin(), pair.unknown.end());
    Warnings warnings;
    for (const std::string& key : unknown)
        warnings.push_back({arguments.input == "-" ? "stdin" : arguments.input,
                            fmt::format("unknown key \"{}\" is ignored", key)});
    warn(warnings, common.quiet);

    std::string out;
    int blocked = 0, fallbacks = 0, round = 0;
    for (std::size_t i = 0; i < pairs->size(); ++i) {
        const stages::Pair& pair = (*pairs)[i];
        const auto made = connect::connection(pair.from, pair.through, pair.to,
                                              {.style = *style,
                                               .limits = pair.limits,
                                               .refined = !arguments.quick,
                                               .extra_length = arguments.extra_length});
        if (!made) {
            Error error = made.error();
            error.place = fmt::format("pair {}, {}", i + 1, error.place);
            return complain(error, bad_input);
        }
        const Led led = led_round(pair, *made);
        if (!led.connection.broken.empty()) ++fallbacks;
        if (led.round) ++round;
        if (led.failure) ++blocked;
        out += stages::write_curve(pair, led.connection, led.failure);
        out += '\n';
    }
    if (const auto written = write_output(arguments.output, out); !written)
        return complain(written.error(), bad_input);
    if (!common.quiet)
        fmt::print(stderr, "{}{}{}{}\n", counted(pairs->size(), "curve"),
                   fallbacks ? fmt::format(", {} of them bounded because {} breaks a limit there", fallbacks,
                                           arguments.style)
                             : "",
                   round ? fmt::format(", {} of them round obstacles", round) : "",
                   blocked ? fmt::format(", {} of them come too near an obstacle", blocked) : "");
    return blocked ? falls_short : done;
}

}  // namespace strandline::cli
