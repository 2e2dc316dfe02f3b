#pragma once
// A small plan made by hand: two lines, a filled area with a hole, a connection, a turn on the spot. Tests of
// several rooms use it.
#include <cmath>
#include <initializer_list>

#include "plan/model/model.hpp"

namespace strandline::testing {

/// Drives the beachbot by straights, arcs and turns on the spot, and writes down samples.
class Driver {
  public:
    Driver(Robot robot, Pose start) : robot_(std::move(robot)), pose_(start) {}

    /// `length` metres of constant curvature, in steps of 2 cm or a little less.
    void drive(double length, double curvature, Motion motion, unsigned mask = 0, int stroke = -1) {
        const double steps = std::ceil(length / 0.02 - 1e-9), step = length / steps;
        for (double k = 0; k < steps; ++k) {
            note(curvature, 0.2, 0.2 * curvature, mask, motion, stroke);
            const double turn = curvature * step;
            const double chord = std::abs(turn) < 1e-12 ? step : 2 / curvature * std::sin(turn / 2);
            pose_.at = pose_.at + chord * unit(pose_.heading + turn / 2);
            pose_.heading = wrap_angle(pose_.heading + turn);
            t_ += step / 0.2;
        }
    }
    void turn(double angle) {
        constexpr int steps = 20;
        for (int k = 0; k < steps; ++k) {
            note(0, 0, angle > 0 ? 0.4 : -0.4, 0, Motion::pivot, -1);
            pose_.heading = wrap_angle(pose_.heading + angle / steps);
            t_ += std::abs(angle) / steps / 0.4;
        }
    }
    std::vector<Sample> finished() {
        note(0, 0, 0, 0, Motion::connect, -1);
        return samples_;
    }
    Pose pose() const { return pose_; }

  private:
    void note(double curvature, double speed, double turn_rate, unsigned mask, Motion motion, int stroke) {
        const Point rake = pose_.at - robot_.rake_offset * unit(pose_.heading);
        samples_.push_back({t_, pose_, curvature, speed, turn_rate, rake, mask, motion, stroke});
    }
    Robot robot_;
    Pose pose_;
    double t_ = 0;
    std::vector<Sample> samples_;
};

inline Stroke straight_stroke(int element, Pose from, double length, int pins, bool fill) {
    const Point end = from.at + length * unit(from.heading);
    Stroke stroke;
    stroke.element = element;
    stroke.rake_path = {straight(from, length)};
    stroke.one_way = stroke.fill = fill;
    stroke.pins = pins;
    stroke.nodes = {{0, from.at, fill ? -1 : 0}, {length, end, fill ? -1 : 1}};
    return stroke;
}

/// Line 0: one pin, 4 m to the right. Line 1: three pins, back to the left and 1 m higher, then a turn on the
/// spot. Region 2: two passes of all seven pins, up and down, 1 m apart.
inline Plan sample_plan() {
    Plan plan;
    plan.program = "strandline 0.1.0";
    plan.title = "two lines and a \"door\" <é>";
    plan.robot.can_pivot = true;
    plan.robot.wheels = {{{0, 0.25}, 0.05}, {{0, -0.25}, 0.05}, {{0.3, 0}, 0.04}};
    plan.robot.rake_rules = {{0, 0}, {1, 1}, {3, 3}, {5, 5}, {8, 7}};
    plan.options.fill.style = "zigzag";
    plan.options.place.rotate = 0.1;
    plan.edits = {LinkEdit{{"first", -1}, {"second", 0}},
                  EntryEdit{{"first", 0}},
                  DirectionEdit{"second", "backward"},
                  HintEdit{"first", "pins", "3"},
                  OrderEdit{{"second", "first"}},
                  DrawEdit{"pen", {path_through({{0.5, 1.25}, {3, 4}, {5, 4.125}}, false)}, 2, 0.03},
                  ThroughEdit{"second", "first", {{{1.5, 2.25}, -0.5}, {{3, 2}, 0.125}}}};
    plan.idle_edits = {"entry of #gone, node 3"};

    Drawing& drawing = plan.drawing;
    drawing.canvas = {10, 10};
    drawing.scale = 0.01;
    drawing.scale_denominator = 50;
    drawing.to_canvas = {0.01, 0, 0, -0.01, 0, 10};
    drawing.start = Point{2, 2};
    drawing.border = Region{{{-2, -2}, {12, -2}, {12, 12}, {-2, 12}}, {}};
    drawing.keep_out = {{{{8, 8}, {9, 8}, {9, 9}, {8, 9}}, {{{8.25, 8.25}, {8.25, 8.5}, {8.5, 8.5}}}}};
    drawing.counts.shapes = 3;
    drawing.warnings = {{"line 7, <text>", "text is not drawn"}};
    drawing.elements = {{"first", "lines", LineElement{path_through({{2, 2}, {6, 2}}, false), 1}, -1},
                        {"second",
                         "",
                         LineElement{path_through({{6.4, 3}, {3, 3}}, false), 3},
                         -1,
                         {{"pause", "!gold"}, {"tool", "2"}}},
                        {"door", "",
                         RegionElement{{{{1.5, 5}, {3.1, 5}, {3.1, 8}, {1.5, 8}},
                                        {{{2.1, 6}, {2.1, 7}, {2.5, 7}, {2.5, 6}}}}},
                         -1}};
    plan.strokes = {straight_stroke(0, {{2, 2}, 0}, 4, 1, false),
                    straight_stroke(1, {{6.4, 3}, pi}, 3.4, 3, false),
                    straight_stroke(2, {{2.8, 5}, pi / 2}, 3, 7, true),
                    straight_stroke(2, {{1.8, 8.4}, -pi / 2}, 3.2, 7, true)};
    for (int i = 0; i < 4; ++i) plan.order.push_back({i, 0, false});

    Driver driver(plan.robot, {{2.2, 2}, 0});
    driver.drive(4, 0, Motion::draw, 8, 0);
    const Curve half_turn{driver.pose(), {{pi / 2, 2, 0}}};
    driver.drive(pi / 2, 2, Motion::connect);
    driver.drive(3.4, 0, Motion::draw, 28, 1);
    driver.turn(-pi / 2);
    const Curve up = straight(driver.pose(), 2.2);
    driver.drive(2.2, 0, Motion::connect);
    driver.drive(3, 0, Motion::draw, 127, 2);
    driver.drive(0.2, 0, Motion::lead);
    const Curve over{driver.pose(), {{pi / 2, 2, 0}}};
    driver.drive(pi / 2, 2, Motion::connect);
    driver.drive(3.2, 0, Motion::draw, 127, 3);
    plan.samples = driver.finished();
    plan.connections = {{0, 1, 0, 0, half_turn}, {1, 2, -pi / 2, 0, up}, {2, 3, 0, 0, over}};
    plan.stops = {{"tool 2", 1, 12.5}};
    plan.undrivable = {{"corner too tight", {3, 3}, 0.05}};
    plan.blemishes = {{"crosses drawn lines, times", {2, 1}, 2}};
    plan.warnings = {{"", "one corner is rounded"}};

    Figures& figures = plan.figures;
    figures.elements = 3;
    figures.lines = 2;
    figures.regions = 1;
    figures.strokes = 4;
    figures.drawn = 4 + 3.4 + 3 + 3.2;
    figures.up_driven = pi + 2.4;
    figures.time = plan.samples.back().t;
    figures.tightest_up = 2;
    return plan;
}

}  // namespace strandline::testing
