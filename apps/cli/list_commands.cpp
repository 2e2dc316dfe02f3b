// Lists of what there is: settings, robots, export formats; for people, or with --json for programs.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "export_formats.hpp"
#include "result/blueprint/blueprint.hpp"
#include "result/formats/formats.hpp"

namespace strandline::cli {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Setting::Kind;

/// One object a line.
void print_list(const std::vector<std::string>& items) {
    fmt::print("[");
    for (std::size_t i = 0; i < items.size(); ++i) fmt::print("{}{}", i > 0 ? ",\n" : "\n", items[i]);
    fmt::print("\n]\n");
}

/// In the units that people write.
void print_setting(const Setting& setting, const Options& defaults) {
    constexpr double degrees = 180 / pi;
    const bool angle = setting.kind == Kind::angle;
    const char* unit = setting.kind == Kind::length     ? " m"
                       : angle                          ? " deg"
                       : setting.kind == Kind::duration ? " s"
                                                        : "";
    std::string value = get(defaults, setting.key), range;
    if (setting.kind == Kind::choice) {
        range = fmt::format("{}", fmt::join(setting.choices, " | "));
    } else if (setting.kind == Kind::flag) {
        range = "on | off";
    } else if (setting.kind == Kind::text) {
        range = name_of(setting.kind);
    } else {
        const double factor = angle ? degrees : 1;
        range = fmt::format("{}, {:g} to {:g}{}", name_of(setting.kind), factor * setting.low,
                            factor * setting.high, unit);
        if (angle) value = fmt::format("{:g}", degrees * *parse_angle(value, setting.key));
        value += unit;
    }
    fmt::print("{:<24} {:<10} {}\n{:<36}{}\n", setting.key, value, setting.meaning, "", range);
}

}  // namespace

int list_formats(const Common& common) {
    std::vector<std::string> items;
    for (const exports::Format& format : export_formats()) {
        if (common.json)
            items.push_back(Json{{"name", format.name}, {"what", format.what}}.dump());
        else
            fmt::print("{:<12} {}\n", format.name, format.what);
    }
    if (common.json) print_list(items);
    return done;
}

int list_settings(const Common& common) {
    if (common.json) {
        fmt::print("{}\n", formats::write_settings_json());
        return done;
    }
    const Options defaults;
    for (const Setting& setting : settings()) print_setting(setting, defaults);
    return done;
}

int show_robot(const std::string& name, const std::string& output, const Common& common) {
    if (name.empty() && output != "-")
        return complain({"-o " + output, "there is no robot to write", "name one, as in robots beachbot"},
                        bad_call);
    if (!name.empty()) {
        const auto robot = robot_named(name);
        if (!robot) return complain(robot.error(), bad_input);
        if (output != "-") {
            const auto written = write_output(
                output, output.ends_with(".svg") ? blueprint::write_svg(*robot) : write_robot(*robot));
            return written ? done : complain(written.error(), bad_input);
        }
        fmt::print("{}", common.json ? formats::write_robot_json(*robot) + '\n' : write_robot(*robot));
        return done;
    }
    std::vector<std::string> items;
    for (const std::string& builtin : builtin_robots()) {
        if (common.json)
            items.push_back(formats::write_robot_json(*builtin_robot(builtin)));
        else
            fmt::print("{}\n", builtin);
    }
    if (common.json) print_list(items);
    return done;
}

}  // namespace strandline::cli
