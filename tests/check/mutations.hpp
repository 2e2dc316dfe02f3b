#pragma once
// Ways to break a valid plan, each with the law that must name it. They ask for nothing but a plan that draws
// something and connects something, so they serve planned ones too.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "result/check/check.hpp"

namespace strandline::mutations {

struct Mutation {
    std::string name;
    check::Law law;  ///< that names it; a crossing breaks none
    std::function<Plan(Plan)> apply;
    bool listed = false;  ///< true: it appears among the blemishes instead
};
/// In a test's name; else it would be the bytes of the struct, another name each run.
inline void PrintTo(const Mutation& mutation, std::ostream* out) { *out << mutation.name; }

using Samples = std::vector<Sample>;

inline bool draws(const Sample& s) { return s.motion == Motion::draw; }
/// The middle of the longest run of at least nine samples for which `wanted` holds; the plan's size when
/// there is none.
template <class Wanted>
std::size_t middle_of_run(const Samples& samples, Wanted wanted) {
    std::size_t run = 0, longest = 8, middle = samples.size();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        run = wanted(samples[i]) ? run + 1 : 0;
        if (run <= longest) continue;
        longest = run;
        middle = i - run / 2;
    }
    return middle;
}
inline std::size_t connecting(const Plan& plan) {
    return middle_of_run(plan.samples, [](const Sample& s) {
        return (s.motion == Motion::connect || s.motion == Motion::loop) && s.speed > 0;
    });
}
inline std::size_t drawing(const Plan& plan) {
    return middle_of_run(plan.samples, [](const Sample& s) { return draws(s) && s.speed > 0; });
}
inline int drawn_element(const Plan& plan) {
    return plan.strokes[static_cast<std::size_t>(plan.samples[drawing(plan)].stroke)].element;
}
/// Adds samples at the end of the drive; their times go on from there.
inline void append(Plan& plan, Samples more) {
    const double later = plan.samples.back().t + 1 - more.front().t;
    for (Sample& s : more) {
        s.t += later;
        plan.samples.push_back(s);
    }
}

inline Plan element_dropped(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    const int element = drawn_element(plan);
    for (Sample& s : plan.samples) {
        if (!draws(s) || plan.strokes[static_cast<std::size_t>(s.stroke)].element != element) continue;
        s.motion = Motion::lead;
        s.mask = 0;
        s.stroke = -1;
    }
    return plan;
}
inline Plan drawn_twice(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    const int element = drawn_element(plan);
    Samples again;
    for (const Sample& s : plan.samples)
        if (draws(s) && plan.strokes[static_cast<std::size_t>(s.stroke)].element == element)
            again.push_back(s);
    append(plan, again);
    return plan;
}
inline Plan pose_jumps(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    for (std::size_t i = drawing(plan); i < plan.samples.size(); ++i) {
        plan.samples[i].pose.at = plan.samples[i].pose.at + Point{0.03, 0.04};
        plan.samples[i].rake = plan.samples[i].rake + Point{0.03, 0.04};
    }
    return plan;
}
inline Plan curvature_over_limit(Plan plan) {
    if (connecting(plan) == plan.samples.size() || plan.robot.min_radius <= 0) return plan;
    Sample& s = plan.samples[connecting(plan)];
    s.curvature = 1.5 / plan.robot.min_radius;
    s.turn_rate = s.speed * s.curvature;
    return plan;
}
/// Stays within the curvature limit, but gets there too quickly.
inline Plan sharpness_over_limit(Plan plan) {
    if (connecting(plan) == plan.samples.size() || plan.robot.min_radius <= 0) return plan;
    Sample& s = plan.samples[connecting(plan)];
    s.curvature += (s.curvature > 0 ? -0.8 : 0.8) / plan.robot.min_radius;
    s.turn_rate = s.speed * s.curvature;
    return plan;
}
inline Plan too_fast(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    Sample& s = plan.samples[drawing(plan)];
    s.speed = 1.3 * plan.robot.speed;
    return plan;
}
/// The whole drive on a field that is somewhere else.
inline Plan out_of_the_field(Plan plan) {
    const Point away{2 * plan.drawing.canvas.width + 10, 0};
    for (Sample& s : plan.samples) {
        s.pose.at = s.pose.at + away;
        s.rake = s.rake + away;
    }
    return plan;
}
inline Plan pins_early(Plan plan) {
    for (std::size_t i = 1; i < plan.samples.size(); ++i)
        if (draws(plan.samples[i]) && !draws(plan.samples[i - 1])) {
            plan.samples[i - 1].mask = plan.samples[i].mask;
            return plan;
        }
    // The robot starts on the stroke: then the pins are late to go up.
    for (std::size_t i = 1; i < plan.samples.size(); ++i)
        if (!draws(plan.samples[i]) && draws(plan.samples[i - 1])) {
            plan.samples[i].mask = plan.samples[i - 1].mask;
            return plan;
        }
    return plan;
}
/// Drives straight across the middle of the longest run of drawing, at the end of the drive.
inline Plan across_finished_ground(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    const Sample middle = plan.samples[drawing(plan)];
    Samples across;
    const double heading = middle.pose.heading + pi / 2, speed = plan.robot.travel_speed, step = 0.02;
    for (int i = -50; i <= 50; ++i) {
        Sample s;
        s.t = (i + 50) * step / speed;
        s.pose = {middle.rake + (i + 0.5) * step * unit(heading), heading};
        s.rake = s.pose.at - plan.robot.rake_offset * unit(heading);
        s.speed = speed;
        across.push_back(s);
    }
    append(plan, across);
    return plan;
}
inline Plan not_a_number(Plan plan) {
    plan.samples[plan.samples.size() / 2].pose.at.x = std::numeric_limits<double>::quiet_NaN();
    return plan;
}
/// The rake is where it would be if it trailed the robot by 3 cm more.
inline Plan wrong_offset(Plan plan) {
    for (Sample& s : plan.samples) s.rake = s.rake - 0.03 * unit(s.pose.heading);
    return plan;
}
inline Plan old_version(Plan plan) {
    plan.version = Plan::current_version - 1;
    return plan;
}

inline Plan heading_jumps(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    Sample& s = plan.samples[drawing(plan)];
    s.pose.heading += 0.1;
    s.rake = s.pose.at - plan.robot.rake_offset * unit(s.pose.heading);
    return plan;
}
inline Plan time_stands(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    const std::size_t i = drawing(plan);
    plan.samples[i].t = plan.samples[i - 1].t;
    return plan;
}
inline Plan too_hasty(Plan plan) {
    for (Sample& s : plan.samples) s.t /= 10;
    for (Sample& s : plan.samples) s.speed *= 10;
    for (Sample& s : plan.samples) s.turn_rate *= 10;
    plan.robot.speed *= 10;
    plan.robot.travel_speed *= 10;
    plan.robot.turn_rate *= 10;
    return plan;
}
inline Plan turns_too_fast(Plan plan) {
    const double fastest =
        std::ranges::max(plan.samples, {}, [](const Sample& s) { return std::abs(s.turn_rate); }).turn_rate;
    plan.robot.turn_rate = 0.8 * std::abs(fastest);
    return plan;
}
inline Plan sparse(Plan plan) {
    if (drawing(plan) == plan.samples.size()) return plan;
    const auto from = plan.samples.begin() + static_cast<std::ptrdiff_t>(drawing(plan));
    plan.samples.erase(from, std::find_if(from, plan.samples.end(), [&](const Sample& s) {
                           return distance(s.pose.at, (from - 1)->pose.at) > 0.07;
                       }));
    return plan;
}
inline Plan drawn_elsewhere(Plan plan) {
    const Point away{0.05, 0.05};
    for (Sample& s : plan.samples) {
        s.pose.at = s.pose.at + away;
        s.rake = s.rake + away;
    }
    return plan;
}

/// A keep-out where the longest run of drawing goes, told by the drawing or by the settings.
inline Polygon on_the_way(const Plan& plan) {
    const Point at = plan.samples[drawing(plan)].pose.at;
    return {at + Point{-0.05, -0.05}, at + Point{0.05, -0.05}, at + Point{0.05, 0.05},
            at + Point{-0.05, 0.05}};
}
inline Plan into_a_keep_out(Plan plan) {
    plan.drawing.keep_out.push_back({on_the_way(plan), {}});
    return plan;
}
inline Plan into_a_keep_out_of_the_settings(Plan plan) {
    for (const Point p : on_the_way(plan))
        plan.options.field.keep_out += std::to_string(p.x) + "," + std::to_string(p.y) + " ";
    return plan;
}
/// A field of which a slit is cut out, thinner than the robot.
inline Plan over_a_dent_of_the_border(Plan plan) {
    const Point at = plan.samples[drawing(plan)].pose.at;
    const double far = 1000;
    plan.drawing.border = Region{{{-far, -far},
                                  {at.x - 0.01, -far},
                                  {at.x, at.y},
                                  {at.x + 0.01, -far},
                                  {far, -far},
                                  {far, far},
                                  {-far, far}},
                                 {}};
    return plan;
}
inline Plan parked_elsewhere(Plan plan) {
    plan.options.park = {.parked = true,
                         .x = plan.samples.front().pose.at.x + 0.1,
                         .y = plan.samples.front().pose.at.y,
                         .heading = plan.samples.front().pose.heading};
    return plan;
}
inline Plan not_at_the_exit(Plan plan) {
    const Pose last = plan.samples.back().pose;
    plan.options.park.exit = "pose";
    plan.options.park.exit_x = last.at.x;
    plan.options.park.exit_y = last.at.y;
    plan.options.park.exit_heading = last.heading + 0.1;
    return plan;
}

/// The twelve of the contract. A robot without limits on its turning (min_radius 0) has no curvature or
/// sharpness to break.
inline std::vector<Mutation> twelve() {
    using check::Law;
    return {{"element dropped", Law::drawn_once, element_dropped},
            {"drawn twice", Law::drawn_once, drawn_twice},
            {"pose jump", Law::position, pose_jumps},
            {"curvature", Law::curvature, curvature_over_limit},
            {"sharpness", Law::sharpness, sharpness_over_limit},
            {"speed", Law::speed, too_fast},
            {"field", Law::field, out_of_the_field},
            {"pin early", Law::pins, pins_early},
            {"crossing", Law::field, across_finished_ground, true},
            {"NaN", Law::finite, not_a_number},
            {"wrong offset", Law::offset, wrong_offset},
            {"old version", Law::version, old_version}};
}
/// The remaining laws.
inline std::vector<Mutation> more() {
    using check::Law;
    return {{"heading jump", Law::heading, heading_jumps},
            {"time stands", Law::time, time_stands},
            {"too hasty", Law::acceleration, too_hasty},
            {"turns too fast", Law::turn_rate, turns_too_fast},
            {"sparse samples", Law::step, sparse},
            {"drawn elsewhere", Law::drawn_right, drawn_elsewhere},
            {"keep-out", Law::field, into_a_keep_out},
            {"keep-out of the settings", Law::field, into_a_keep_out_of_the_settings},
            {"border's dent", Law::field, over_a_dent_of_the_border},
            {"parked elsewhere", Law::ends, parked_elsewhere},
            {"not at the exit", Law::ends, not_at_the_exit}};
}

}  // namespace strandline::mutations
