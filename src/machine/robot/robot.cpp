#include "machine/robot/robot.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace strandline {
namespace {

// SVG transforms leave rounding in a stroke's width: 3.0000001 is still "up to 3".
constexpr double width_slack = 1e-6;

Robot beachbot() {
    // Rake, radius, speeds, turn rates and rake rules: BeachBot, ETH Zurich 2014. sharpness =
    // turn_acceleration / speed^2. Footprint and wheels are assumptions (two driven wheels on the turning
    // axle, inside the rake's width so that the rake smooths their tracks, and one in front): the 2014 files
    // do not hold them.
    return Robot{.name = "beachbot",
                 .rake_offset = 0.2,
                 .pins = 7,
                 .pin_pitch = 0.06,
                 .min_radius = 0.5,
                 .sharpness = 10,
                 .can_pivot = false,
                 .speed = 0.2,
                 .travel_speed = 0.2,
                 .acceleration = 0.1,
                 .turn_rate = 0.4,
                 .turn_acceleration = 0.4,
                 .lift_delay = 0,
                 .front = 0.45,
                 .back = 0.25,
                 .half_width = 0.25,
                 .wheels = {{{0, 0.17}, 0.08}, {{0, -0.17}, 0.08}, {{0.35, 0}, 0.08}},
                 .rake_rules = {{0, 0}, {1, 1}, {3, 3}, {5, 5}, {8, 7}},
                 .fill_wide_strokes = true};
}

Robot plotter() {
    // A pen on a gantry: what it "turns" costs nothing, so the turn rates are as good as infinite. The
    // footprint is the pen.
    return Robot{.name = "plotter",
                 .rake_offset = 0,
                 .pins = 1,
                 .pin_pitch = 0.0005,
                 .min_radius = 0,
                 .sharpness = 1e6,
                 .can_pivot = true,
                 .speed = 0.1,
                 .travel_speed = 0.3,
                 .acceleration = 2,
                 .turn_rate = 1000,
                 .turn_acceleration = 1e6,
                 .lift_delay = 0.1,
                 .front = 0.001,
                 .back = 0.001,
                 .half_width = 0.001,
                 .wheels = {},
                 .rake_rules = {{0, 0}, {1, 1}},
                 .fill_wide_strokes = false};
}

Robot turf() {
    // A field marker: users report a least radius of 3 ft. The paint nozzle, on an arm beside the body on its
    // right, the speeds, footprint and wheels are assumptions; sharpness R^2 = 2.5 as for the beachbot. Its
    // line is one width whatever the drawing says.
    return Robot{.name = "turf",
                 .rake_offset = 0.3,
                 .rake_side = -0.5,
                 .pins = 1,
                 .pin_pitch = 0.10,
                 .min_radius = 0.9,
                 .sharpness = 3,
                 .can_pivot = false,
                 .speed = 1,
                 .travel_speed = 1,
                 .acceleration = 0.5,
                 .turn_rate = 1.2,
                 .turn_acceleration = 3,
                 .lift_delay = 0,
                 .front = 0.6,
                 .back = 0.4,
                 .half_width = 0.4,
                 .wheels = {{{0, 0.3}, 0.1}, {{0, -0.3}, 0.1}, {{0.5, 0}, 0.1}},
                 .rake_rules = {{0, 0}, {1, 1}},
                 .fill_wide_strokes = false};
}

Robot diff_drive() {
    // Two driven wheels and a caster behind, a marker between the wheels: turns on the spot and has no rake
    // that trails. A robot for classrooms; all of it is assumed.
    return Robot{.name = "diffdrive",
                 .rake_offset = 0,
                 .pins = 1,
                 .pin_pitch = 0.01,
                 .min_radius = 0.05,
                 .sharpness = 300,
                 .can_pivot = true,
                 .speed = 0.1,
                 .travel_speed = 0.15,
                 .acceleration = 0.3,
                 .turn_rate = 2,
                 .turn_acceleration = 8,
                 .lift_delay = 0.15,
                 .front = 0.06,
                 .back = 0.09,
                 .half_width = 0.07,
                 .wheels = {{{0, 0.06}, 0.015}, {{0, -0.06}, 0.015}, {{-0.07, 0}, 0.01}},
                 .rake_rules = {{0, 0}, {1, 1}},
                 .fill_wide_strokes = false};
}

Robot sand_table() {
    // A ball that a magnet under the table draws through the sand: it is always down, turns on the spot, and
    // its groove is about as wide as the ball. Speeds as users of such tables report them; the rest is
    // assumed.
    return Robot{.name = "sandtable",
                 .rake_offset = 0,
                 .pins = 1,
                 .pin_pitch = 0.008,
                 .min_radius = 0,
                 .sharpness = 1e6,
                 .can_pivot = true,
                 .speed = 0.04,
                 .travel_speed = 0.04,
                 .acceleration = 0.5,
                 .turn_rate = 1000,
                 .turn_acceleration = 1e6,
                 .lift_delay = 0,
                 .lifts = false,
                 .fix_noise = 0,
                 .front = 0.008,
                 .back = 0.008,
                 .half_width = 0.008,
                 .wheels = {},
                 .rake_rules = {{0, 0}, {1, 1}},
                 .fill_wide_strokes = false};
}

}  // namespace

unsigned pin_mask(const Robot& robot, int count) {
    const int down = std::clamp(count, 0, robot.pins);
    // pins are numbered from the left, the leftmost in the highest used bit; of what cannot be halved evenly
    // more is up on the left, or on the right of a rake to the right: pins near the axis follow bends better
    const int right_of_it = (robot.pins - down + (robot.rake_side < 0 ? 1 : 0)) / 2;
    return ((1u << down) - 1u) << right_of_it;
}

int pins_down(unsigned mask) { return std::popcount(mask); }

double middle_of(const Robot& robot, unsigned mask) {
    double sum = 0;
    int down = 0;
    for (int pin = 0; pin < robot.pins; ++pin) {
        if ((mask >> (robot.pins - 1 - pin) & 1U) == 0) continue;
        sum += (robot.pins - 1) / 2.0 - pin;
        ++down;
    }
    return down == 0 ? 0 : sum / down * robot.pin_pitch;
}

int pins_for_width(const Robot& robot, double stroke_width) {
    if (robot.rake_rules.empty()) return robot.pins;
    const auto rule = std::find_if(robot.rake_rules.begin(), robot.rake_rules.end(), [&](const RakeRule& r) {
        return stroke_width <= r.up_to * (1 + width_slack);
    });
    return rule == robot.rake_rules.end() ? robot.rake_rules.back().pins : rule->pins;
}

double wheel_reach(const Robot& robot) {
    double reach = 0;
    for (const Wheel& wheel : robot.wheels) {
        const double side = std::abs(wheel.at.y) + wheel.width / 2;
        for (const double turn : {1.0, -1.0}) {
            // a wheel ahead of the axle runs on a wider circle
            const double radius = least_radius(robot, turn);
            reach = std::max({reach, side, std::hypot(radius + side, wheel.at.x) - radius});
        }
    }
    return reach;
}

std::vector<std::string> builtin_robots() {
    return {"beachbot", "plotter", "turf", "diffdrive", "sandtable"};
}

Outcome<Robot> builtin_robot(std::string_view name) {
    if (name == "beachbot") return beachbot();
    if (name == "plotter") return plotter();
    if (name == "turf") return turf();
    if (name == "diffdrive") return diff_drive();
    if (name == "sandtable") return sand_table();
    return fail("robot", "there is no built-in \"" + std::string(name) + '"',
                "use beachbot, plotter, turf, diffdrive or sandtable, or name a .toml file");
}

}  // namespace strandline
