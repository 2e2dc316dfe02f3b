#pragma once
// The machine: its rake, pins, turning, speeds and limits. A profile is a TOML text; `docs/robot.md` lists
// every field. Body frame: origin at the turning point P, x forward, y left. Metres, seconds, radians.
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline {

/// A stroke in the drawing of width up to `up_to` (SVG user units after all transforms, before it is fitted
/// to the canvas) is drawn with `pins` pins. The last rule of a profile also serves every wider stroke.
struct RakeRule {
    double up_to = 0;
    int pins = 1;
    bool operator==(const RakeRule&) const = default;
};

/// A wheel's contact patch, in the body frame.
struct Wheel {
    Point at;
    double width = 0.05;
    bool operator==(const Wheel&) const = default;
};

/// A drawing machine. Invariant (kept by read_robot and valid()): every field in the range its docs state.
struct Robot {
    std::string name = "beachbot";
    double rake_offset = 0.2;  ///< L: the rake's centre trails P by this; 0: plotter
    double rake_side = 0;      ///< w: the rake's centre lies so far left of P's axis; < 0: right
    int pins = 7;              ///< liftable pins, equally spaced across the travel
    double pin_pitch = 0.06;   ///< metres between pins; a pin's groove is as wide as the pitch
    double min_radius = 0.5;   ///< R of P when driving rake up; 0: turns on the spot are free (plotter)
    double left_radius = 0, right_radius = 0;  ///< the same of turns to one side, where larger; 0: min_radius
    double sharpness = 10;                     ///< sigma: largest |d curvature / d s| rake up, 1/m^2
    bool can_pivot = false;                    ///< may turn on the spot
    bool can_back_up = false;                  ///< may drive backwards, rake up
    double speed = 0.2;                        ///< rake down, m/s
    double travel_speed = 0.2;                 ///< rake up, m/s
    double acceleration = 0.1;                 ///< m/s^2
    double turn_rate = 0.4;                    ///< rad/s
    double turn_acceleration = 0.4;            ///< rad/s^2
    double lift_delay = 0.0;                   ///< s from command to pins up or down
    bool lifts = true;        ///< false: the tool is always down, and marks what lies between strokes
    double setback = 0;       ///< metres that the footprint keeps from a field's border that was asked for
    double fix_noise = 0.01;  ///< metres, along x and along y: what each fix of its place errs
    double front = 0.5, back = 0.35, half_width = 0.35;  ///< footprint around P
    std::vector<Wheel> wheels = {};
    /// ascending up_to; beachbot: 0->0, 1->1, 3->3, 5->5, 8->7 pins (2014)
    std::vector<RakeRule> rake_rules = {};
    /// a drawn stroke wider than the rake becomes a region; false: it stays one line (plotters)
    bool fill_wide_strokes = true;
    bool operator==(const Robot&) const = default;

    double rake_width() const { return pins * pin_pitch; }
};

/// Width of the groove that n neighbouring pins leave.
inline double groove_width(const Robot& robot, int pins) { return pins * robot.pin_pitch; }
/// Mask with the middle `count` pins down; highest used bit = leftmost pin looking forward. 0 for count 0. An
/// even number of an odd one, or the other way round, lies half a pitch right of the middle; left of it where
/// the rake lies right of the robot's axis.
unsigned pin_mask(const Robot& robot, int count);
int pins_down(unsigned mask);
/// Metres left of the rake's centre at which the middle of a mask's pins lies: half a pitch where an even
/// number is down of an odd one, or the other way round. 0 for no pin. O(pins).
double middle_of(const Robot& robot, unsigned mask);
/// Pins for a stroke of that width (user units, as in RakeRule).
int pins_for_width(const Robot& robot, double stroke_width);
/// Of turns to the left (side > 0) or right.
inline double least_radius(const Robot& robot, double side) {
    const double own = side > 0 ? robot.left_radius : robot.right_radius;
    return own > 0 ? own : robot.min_radius;
}
/// How far to the side of P's path wheels roll, in turns of the least radius too; 0 without wheels.
double wheel_reach(const Robot& robot);
/// Corners of the footprint, counter-clockwise, in the body frame.
Polygon footprint(const Robot& robot);
/// How far the footprint reaches from the turning point.
double footprint_reach(const Robot& robot);
/// Whether the footprint, with the turning point `at` a place and looking along `heading`, lies wholly within
/// the area; wholly outside it. Touching the outline is both. O(corners).
bool stays_within(const Robot& robot, Point at, double heading, const Region& area);
bool keeps_off(const Robot& robot, Point at, double heading, const Region& area);

std::vector<std::string> builtin_robots();            ///< "beachbot", "plotter", ...
Outcome<Robot> builtin_robot(std::string_view name);  ///< unknown: the Error lists the names
/// TOML text; `base = "plotter"` starts from that built-in, without it from beachbot. `place` names the text
/// in errors ("my.toml"). A wrong field is refused by name with its unit and range; unknown fields too.
Outcome<Robot> read_robot(std::string_view toml, const std::string& place);
std::string write_robot(const Robot& robot);  ///< TOML that reads back equal
/// The robot itself when every field is in its range and the fields agree with each other; else the Error
/// names field, unit and range.
Outcome<Robot> valid(Robot robot, const std::string& place);
/// One number or flag by its field name, e.g. ("min_radius", "0.3"): for --set robot.min_radius=0.3.
Outcome<Robot> with_field(Robot robot, const std::string& field, const std::string& value);
/// The name of every scalar field with unit, range (inclusive) and meaning, for docs and --help.
/// unit: "m", "s", ..., "count" for whole numbers, "true/false" for flags.
struct RobotField {
    std::string name, unit, meaning;
    double low, high;
};
const std::vector<RobotField>& robot_fields();

}  // namespace strandline
