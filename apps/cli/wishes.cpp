// What a call of plan wishes for, gathered from its arguments.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arguments.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline::cli {
namespace {

/// Settings file first, the command line over it, both over `defaults`.
Outcome<Wishes> gathered(const PlanArguments& a, const Options& defaults) {
    Wishes wishes;
    wishes.options = defaults;
    Outcome<void> done;
    for (const std::string& config : a.configs)
        if (done) done = read_settings_file(wishes, config);
    if (!a.robot.empty()) wishes.robot = a.robot;
    if (done && !a.canvas.empty()) done = set_canvas(wishes.options, a.canvas);
    // Who says how high letters are wants them so.
    if (done && !a.lettering.text.empty() && !a.lettering.height.empty())
        done = set(wishes.options, "place.mode", "actual");
    if (done && !a.margin.empty()) done = set(wishes.options, "canvas.margin", a.margin);
    if (done && !a.place.empty()) done = set_place(wishes.options, a.place);
    if (done && !a.layers.empty())
        done = set(wishes.options, "drawing.layers", fmt::format("{}", fmt::join(a.layers, "; ")));
    if (done && !a.rules.empty())
        done = set(wishes.options, "drawing.rules", fmt::format("{}", fmt::join(a.rules, "; ")));
    if (done && !a.avoid.empty()) done = set(wishes.options, "avoid.finished", a.avoid);
    if (done && !a.order.empty())
        done = set(wishes.options, "tour.grouped", a.order == "grouped" ? "on" : "off");
    if (done && !a.method.empty()) done = set(wishes.options, "tour.method", a.method);
    if (done && !a.occlusion.empty()) done = set(wishes.options, "drawing.occlusion", a.occlusion);
    if (done && a.invert) done = set(wishes.options, "ink.invert", "on");
    if (done && !a.dpi.empty()) done = set(wishes.options, "drawing.dpi", a.dpi);
    if (done && !a.park.empty()) done = set_pose(wishes.options, "park.", "--park", a.park);
    if (done && !a.exit.empty()) done = set_exit(wishes.options, a.exit);
    if (done && !a.start.empty()) done = set_drive_end(wishes.options, "start", a.start);
    if (done && !a.end.empty()) done = set_drive_end(wishes.options, "end", a.end);
    for (const std::string& text : a.settings)
        if (done) done = set_from_text(wishes, text);
    if (done) done = set_fences(wishes, a.border, a.keep_outs);
    const auto add_edits = [&](const std::vector<std::string>& texts, auto parse) {
        for (const std::string& text : texts) {
            if (!done) return;
            const auto edit = parse(text);
            if (edit)
                wishes.edits.push_back(*edit);
            else
                done = tl::unexpected(edit.error());
        }
    };
    add_edits(a.links, parse_link);
    add_edits(a.entries, parse_entry);
    add_edits(a.directions, parse_direction);
    if (!done) return tl::unexpected(done.error());
    return wishes;
}

}  // namespace

// Twice: the canvas that is wished for decides the defaults of all that is not.
Outcome<Wishes> gathered(const PlanArguments& a) {
    auto first = gathered(a, Options{});
    if (!first) return first;
    return gathered(a, defaults_for({first->options.canvas.width, first->options.canvas.height}));
}

Outcome<Robot> robot_of(const Wishes& wishes) {
    auto robot = wishes.profile ? read_robot(*wishes.profile, "robot")
                                : robot_named(wishes.robot.empty() ? "beachbot" : wishes.robot);
    for (const auto& [field, value] : wishes.robot_fields)
        if (robot) robot = with_field(*robot, field, value);
    return robot;
}

}  // namespace strandline::cli
