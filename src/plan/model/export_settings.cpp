#include "plan/model/export_settings.hpp"

namespace strandline {
namespace {

using Kind = Setting::Kind;
using Field = std::variant<double*, int*, bool*, std::string*>;
using Access = Field (*)(Options&);

constexpr double far = 100'000;  // m: beyond it the ground is no plane

Setting number(const char* key, const char* meaning, Kind kind, double low, double high, Access field) {
    return {key, meaning, kind, low, high, {}, "", field};
}
Setting text(const char* key, const char* meaning, Access field) {
    return {key, meaning, Kind::text, 0, 0, {}, "", field};
}
Setting choice(const char* key, const char* meaning, std::vector<std::string> choices, Access field) {
    return {key, meaning, Kind::choice, 0, 0, std::move(choices), "", field};
}

}  // namespace

std::vector<Setting> export_settings() {
    return {
        number("site.latitude", "degrees north of the place on earth that site.x and site.y count from",
               Kind::number, -90, 90, [](Options& o) -> Field { return &o.site.at.place.latitude; }),
        number("site.longitude", "degrees east of the place on earth that site.x and site.y count from",
               Kind::number, -180, 180, [](Options& o) -> Field { return &o.site.at.place.longitude; }),
        number("site.altitude", "of the ground above the ellipsoid of WGS 84", Kind::length, -500, 9000,
               [](Options& o) -> Field { return &o.site.at.altitude; }),
        number("site.x", "how far east of that place the canvas's lower left corner is", Kind::length, -far,
               far, [](Options& o) -> Field { return &o.site.at.x; }),
        number("site.y", "how far north of that place the canvas's lower left corner is", Kind::length, -far,
               far, [](Options& o) -> Field { return &o.site.at.y; }),
        number("site.heading", "where the canvas's y axis looks: clockwise from true north", Kind::angle,
               -1000, 1000, [](Options& o) -> Field { return &o.site.at.heading; }),
        number("site.known", "the canvas has a place on earth; off: exports that need one take 0, 0",
               Kind::flag, 0, 1, [](Options& o) -> Field { return &o.site.known; }),
        number("mission.items", "how many items the autopilot holds, home among them", Kind::integer, 2,
               65535, [](Options& o) -> Field { return &o.mission.items; }),
        number("mission.tolerance",
               "how far waypoints thinned to mission.items may leave the path; beyond it there is no mission",
               Kind::length, 0, 100, [](Options& o) -> Field { return &o.mission.tolerance; }),
        number("mission.servo", "the autopilot's output that lifts the rake", Kind::integer, 1, 32,
               [](Options& o) -> Field { return &o.mission.servo; }),
        number("mission.down", "microseconds of that output's pulse, rake down", Kind::integer, 500, 2500,
               [](Options& o) -> Field { return &o.mission.down; }),
        number("mission.up", "microseconds of that output's pulse, rake up", Kind::integer, 500, 2500,
               [](Options& o) -> Field { return &o.mission.up; }),
        text("gcode.begin", "first lines; \\n between lines, {title}, {up}, {down} stand for what they name",
             [](Options& o) -> Field { return &o.gcode.begin; }),
        text("gcode.down", "tool down; {feed} is the feed in mm/min",
             [](Options& o) -> Field { return &o.gcode.down; }),
        text("gcode.up", "tool up", [](Options& o) -> Field { return &o.gcode.up; }),
        text("gcode.stop",
             "where the drive waits, tool up: {why}, {tool} the number of the tool to come, {layer} of what "
             "comes next",
             [](Options& o) -> Field { return &o.gcode.stop; }),
        text("gcode.end", "last lines", [](Options& o) -> Field { return &o.gcode.end; }),
        number("gcode.feed", "tool down, mm/min; 0: the robot's speed", Kind::number, 0, 1e6,
               [](Options& o) -> Field { return &o.gcode.feed; }),
        number("thr.radius",
               "of the table's circle round the canvas's middle; 0: what holds all that is drawn",
               Kind::length, 0, far, [](Options& o) -> Field { return &o.thr.radius; }),
        choice("thr.ends",
               "the ball comes from there and goes there, straight out or in: rim, centre, the nearest of "
               "both; drawn: it begins and ends with the drawing",
               {"nearest", "rim", "centre", "drawn"}, [](Options& o) -> Field { return &o.thr.ends; }),
        text("nav.frame", "frame_id of ROS paths", [](Options& o) -> Field { return &o.nav.frame; }),
        choice("nav.goals",
               "one FollowPath goal, or one for each time the rake is lowered or lifted, as YAML documents",
               {"one", "strokes"}, [](Options& o) -> Field { return &o.nav.goals; }),
        text("nav.controller", "controller_id of FollowPath goals; empty: the default one",
             [](Options& o) -> Field { return &o.nav.controller; }),
        text("nav.goal_checker", "goal_checker_id of FollowPath goals; empty: the default one",
             [](Options& o) -> Field { return &o.nav.goal_checker; }),
    };
}

}  // namespace strandline
