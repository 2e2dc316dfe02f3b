#include "arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/units/units.hpp"
#include "console.hpp"
#include "input/drawing/drawing.hpp"

namespace strandline::cli {
namespace {

/// "eye:3" -> element and node; the element's name may itself hold colons.
Outcome<NodeName> parse_node(const std::string& text, const std::string& place) {
    const std::size_t colon = text.rfind(':');
    int node = 0;
    const char* end = text.data() + text.size();
    if (colon == std::string::npos || colon == 0 ||
        std::from_chars(text.data() + colon + 1, end, node).ptr != end || colon + 1 == text.size() ||
        node < -1)
        return fail(place, fmt::format("\"{}\" names no node", text),
                    "write ELEMENT:NODE, such as eye:0 (-1 is the last node)");
    return NodeName{text.substr(0, colon), node};
}

}  // namespace

Outcome<Robot> robot_named(const std::string& name) {
    const std::vector<std::string> known = builtin_robots();
    if (std::ranges::find(known, name) != known.end() || !name.ends_with(".toml")) {
        auto robot = builtin_robot(name);
        if (!robot && std::filesystem::exists(name))
            return fail(name, "is not called *.toml",
                        "profiles are TOML files; rename it to " + name + ".toml");
        return robot;
    }
    const auto text = read_input(name);
    if (!text) return tl::unexpected(text.error());
    return read_robot(*text, name);
}

Outcome<void> set_from_text(Wishes& wishes, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return fail("--set " + text, "is not key=value", "write for example --set fill.spacing=36cm");
    const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
    if (key.starts_with("robot.")) {
        wishes.robot_fields.emplace_back(key.substr(6), value);
        return {};
    }
    return set(wishes.options, key, value);
}

Outcome<Edit> parse_link(const std::string& text) {
    const std::string place = "--link " + text;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        return fail(place, "is not A:V=B:W", "write for example --link eye:0=lid:-1");
    const auto a = parse_node(text.substr(0, equals), place), b = parse_node(text.substr(equals + 1), place);
    if (!a) return tl::unexpected(a.error());
    if (!b) return tl::unexpected(b.error());
    return LinkEdit{*a, *b};
}

Outcome<Edit> parse_entry(const std::string& text) {
    const auto at = parse_node(text, "--entry " + text);
    if (!at) return tl::unexpected(at.error());
    return EntryEdit{*at};
}

Outcome<Edit> parse_direction(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    const std::string direction = equals == std::string::npos ? "" : text.substr(equals + 1);
    if (direction != "forward" && direction != "backward" && direction != "ccw" && direction != "cw")
        return fail("--direction " + text, "is not A=forward|backward|ccw|cw",
                    "write for example --direction lid=backward");
    return DirectionEdit{text.substr(0, equals), direction};
}

Outcome<void> set_place(Options& options, const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string mode = text.substr(0, equals);
    if (auto ok = set(options, "place.mode", mode); !ok) {
        ok.error().place = "--place " + text;
        return ok;
    }
    const bool wants = mode == "width" || mode == "scale";
    if (wants != (equals != std::string::npos))
        return fail("--place " + text, wants ? "the value is missing" : "takes no value",
                    "write fit, actual, width=10m or scale=1:50");
    if (!wants) return {};
    std::string value = text.substr(equals + 1);
    if (mode == "scale" && value.starts_with("1:")) value = value.substr(2);
    return set(options, mode == "width" ? "place.width" : "place.scale", value);
}

Outcome<void> set_canvas(Options& options, const std::string& text) {
    const auto canvas = canvas_named(text);
    if (!canvas) return tl::unexpected(canvas.error());
    options.canvas.width = canvas->width;
    options.canvas.height = canvas->height;
    return {};
}

Outcome<void> set_drive_end(Options& options, const std::string& which, const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        return fail("--" + which + " " + text, "is not X,Y", "write for example --" + which + " 0,3.5m");
    if (auto x = set(options, "tour." + which + "_x", text.substr(0, comma)); !x) return x;
    return set(options, "tour." + which + "_y", text.substr(comma + 1));
}

Outcome<void> set_pose(Options& options, const std::string& prefix, const std::string& option,
                       const std::string& text) {
    const std::size_t first = text.find(','), second = text.find(',', std::min(first, text.size() - 1) + 1);
    if (first == std::string::npos)
        return fail(option + " " + text, "is not X,Y or X,Y,HEADING",
                    "write for example " + option + " -1m,2m,90deg");
    auto done = set(options, prefix + "x", text.substr(0, first));
    if (done)
        done = set(options, prefix + "y",
                   text.substr(first + 1, second == std::string::npos ? second : second - first - 1));
    if (done && second != std::string::npos) done = set(options, prefix + "heading", text.substr(second + 1));
    return done;
}

Outcome<void> set_exit(Options& options, const std::string& text) {
    if (text.find(',') == std::string::npos) return set(options, "park.exit", text);
    return set_pose(options, "park.exit_", "--exit", text);
}

}  // namespace strandline::cli
