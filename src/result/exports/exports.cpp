// The table of formats.
#include "result/exports/exports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text/text.hpp"
#include "result/exports/spans.hpp"
#include "result/formats/formats.hpp"

namespace strandline::exports {
namespace {

constexpr std::array<std::string_view, 5> groups{"site.", "mission.", "gcode.", "thr.", "nav."};

Written one(const char* suffix, std::string bytes) { return {{{suffix, std::move(bytes)}}, {}}; }

std::vector<Format> make_table() {
    return {
        {"beachbot",
         "the pair NAME_robot.txt, NAME_rake.txt: x y mask, metres, a line an instant",
         {"_robot.txt", "_rake.txt"},
         "text/plain",
         false,
         [](const Plan& plan, const Choice&) -> Outcome<Written> {
             formats::BeachbotPair pair = formats::write_beachbot(plan);
             Warnings lost;
             if (const int times = times_backing(plan.samples); times > 0 && plan.robot.rake_offset == 0)
                 lost.push_back({"beachbot",
                                 fmt::format("the robot backs up {}, and a pair whose tool is at the turning "
                                             "point cannot say so: a reader turns it about there",
                                             counted(times, "time"))});
             return Written{{{"_robot.txt", std::move(pair.robot)}, {"_rake.txt", std::move(pair.rake)}},
                            std::move(lost)};
         }},
        {"csv",
         "a line a sample: s, t, x, y, heading, curvature, speed, turn rate, pins, rake",
         {".csv"},
         "text/csv",
         false,
         [](const Plan& plan, const Choice&) -> Outcome<Written> {
             return one(".csv", formats::write_csv(plan));
         }},
        {"geojson",
         "what is raked, driven and fenced as lines and areas on earth, for maps (site.* says where)",
         {".geojson"},
         "application/geo+json",
         true,
         [](const Plan& plan, const Choice&) -> Outcome<Written> { return geojson(plan); }},
        {"nav-path",
         "the robot's path as one nav_msgs/Path, YAML, for ROS 2",
         {"_path.yaml"},
         "application/yaml",
         false,
         [](const Plan& plan, const Choice&) -> Outcome<Written> { return nav_path(plan); }},
        {"follow-path",
         "goals of Nav2's action FollowPath, YAML: the whole drive, or a goal for each stroke (nav.goals)",
         {"_goal.yaml"},
         "application/yaml",
         false,
         [](const Plan& plan, const Choice&) -> Outcome<Written> { return follow_path(plan); }},
        {"wpl",
         "QGC WPL 110: waypoints and rake servo for ArduPilot rovers (site.* says where)",
         {".waypoints"},
         "text/plain",
         true,
         [](const Plan& plan, const Choice&) { return wpl(plan); }},
        {"qgc-plan",
         "the same mission with its fences as a .plan of QGroundControl",
         {".plan"},
         "application/json",
         true,
         [](const Plan& plan, const Choice&) { return qgc_plan(plan); }},
        {"gcode",
         "G-code by templates (gcode.*): tool up and down, feed, a block for each stop; millimetres",
         {".gcode"},
         "text/plain",
         true,
         [](const Plan& plan, const Choice&) { return gcode(plan); }},
        {"thr",
         "theta rho for sand tables: one line that never lifts",
         {".thr"},
         "text/plain",
         false,
         [](const Plan& plan, const Choice&) { return thr(plan); }},
        {"svg",
         "picture: rake down black at true width, rake up red",
         {".svg"},
         "image/svg+xml",
         false,
         [](const Plan& plan, const Choice&) -> Outcome<Written> {
             return one(".svg", formats::write_svg(plan));
         }},
        {"trace",
         "what is drawn and driven as polylines (JSON), for measuring",
         {"_trace.json"},
         "application/json",
         false,
         [](const Plan& plan, const Choice& choice) -> Outcome<Written> {
             return one("_trace.json", formats::write_trace(plan, choice.robot_path));
         }},
    };
}

}  // namespace

const std::vector<Format>& table() {
    static const std::vector<Format> all = make_table();
    return all;
}

Outcome<void> set_for_export(Options& options, const std::string& key, const std::string& value) {
    const bool ours = std::ranges::any_of(groups, [&](std::string_view g) { return key.starts_with(g); });
    if (!ours)
        return fail(key, "is decided when the drawing is planned",
                    "an export can set site.*, mission.*, gcode.*, thr.* and nav.*; plan again for others");
    return set(options, key, value);
}

void take_export_options(Options& options, const Options& from) {
    options.site = from.site;
    options.mission = from.mission;
    options.gcode = from.gcode;
    options.thr = from.thr;
    options.nav = from.nav;
}

}  // namespace strandline::exports
