// A plan as the trace judges read it: what was to be drawn, and what is driven in order.
#include <cmath>

#include "base/text/text.hpp"
#include "result/formats/formats.hpp"
#include "result/formats/instants.hpp"
#include "result/sketch/sketch.hpp"

namespace strandline::formats {
namespace {

constexpr int decimals = 7;            // a tenth of a micrometre: 0.0001 1/m of curvature over 5 cm chords
constexpr double travel_step = 0.004;  // m
constexpr double longest_move = 10;    // m between two samples: a jump; not to be filled in

void add_points(Text& text, const std::vector<Point>& points) {
    const char* before = "[";
    if (points.empty()) add(text, before);
    for (Point p : points) {
        add(text, before);
        add(text, "[");
        add_fixed(text, p.x, decimals);
        add(text, ",");
        add_fixed(text, p.y, decimals);
        add(text, "]");
        before = ",";
    }
    add(text, "]");
}

void add_targets(Text& text, const Plan& plan) {
    Text fills, lines;
    for (const Element& element : plan.drawing.elements) {
        if (const auto* region = std::get_if<RegionElement>(&element.what)) {
            add(fills, fills.size() ? ",\n" : "\n");
            add(fills, "{\"outer\": ");
            add_points(fills, region->region.outer);
            add(fills, ", \"holes\": [");
            for (std::size_t i = 0; i < region->region.holes.size(); ++i) {
                if (i > 0) add(fills, ",");
                add_points(fills, region->region.holes[i]);
            }
            add(fills, "]}");
        } else {
            const Path& path = std::get<LineElement>(element.what).path;
            add(lines, lines.size() ? ",\n" : "\n");
            add(lines, "{\"pts\": ");
            add_points(lines, flattened(path, plan.options.drawing.tolerance));
            add(lines, path.closed ? ", \"closed\": true}" : ", \"closed\": false}");
        }
    }
    add(text, "{\"fills\": [");
    text.append(fills.begin(), fills.end());
    add(text, "],\n\"lines\": [");
    text.append(lines.begin(), lines.end());
    add(text, "]}");
}

/// Points of a run, of the robot or of the middle of `pins`. Rake up they are `travel_step` apart: the judge
/// measures curvature on chords of 5 cm between points on straight lines from point to point, and finds 2.08
/// where samples 2 cm apart drive an arc of 2.00 1/m.
std::vector<Point> track(const Plan& plan, const sketch::Run& run, unsigned pins, bool robot_path) {
    std::vector<Point> points;
    const auto add_point = [&](Pose pose, Point rake) { points.push_back(robot_path ? pose.at : rake); };
    for (std::size_t i = run.first; i <= run.last; ++i) {
        const Sample& sample = plan.samples[i];
        add_point(sample.pose, drawn_at(plan.robot, sample, pins));
        if (run.draws || run.mask != 0 || i == run.last) continue;
        const double farthest = farthest_move(sample, plan.samples[i + 1]);
        if (!(farthest < longest_move)) continue;
        const double parts = std::ceil(farthest / travel_step);
        for (const Instant& at : instants_between(plan.robot, sample, plan.samples[i + 1], parts))
            add_point(at.pose, at.rake);
    }
    return points;
}

void add_move(Text& text, const Plan& plan, const sketch::Run& run, bool robot_path) {
    unsigned pins = 0;
    // Along a stroke with no pin down: a drawing move of width 0, "driven, but not drawn".
    if (run.mask != 0 || run.draws) {
        const bool known = run.stroke >= 0 && static_cast<std::size_t>(run.stroke) < plan.strokes.size();
        const bool fill = known && plan.strokes[static_cast<std::size_t>(run.stroke)].fill;
        // Along a fill pins come and go while the rake keeps to its path.
        if (!fill) pins = run.mask;
        add(text, fill ? "{\"kind\": \"draw\", \"fill\": true, \"width\": "
                       : "{\"kind\": \"draw\", \"fill\": false, \"width\": ");
        add_number(text, groove_width(plan.robot, pins_down(run.mask)));
    } else {
        add(text, "{\"kind\": \"travel\"");
    }
    add(text, ", \"pts\": ");
    add_points(text, track(plan, run, pins, robot_path));
    add(text, "}");
}

}  // namespace

std::string write_trace(const Plan& plan, bool robot_path) {
    Text text;
    add(text, "{\"name\": ");
    add_string(text, plan.title);
    const double spacing = plan.options.fill.spacing;  // 0 stands for the rake's own width
    add(text, ",\n\"line_distance\": ");
    add_number(text, spacing > 0 ? spacing : plan.robot.rake_width());
    add(text, ",\n\"curvature_limit\": ");
    if (plan.robot.min_radius > 0)
        add_number(text, 1 / plan.robot.min_radius);
    else
        add(text, "null");
    add(text, ",\n\"targets\": ");
    add_targets(text, plan);
    add(text, ",\n\"moves\": [");
    const char* before = "\n";
    for (const sketch::Run& run : sketch::runs(plan.samples)) {
        add(text, before);
        add_move(text, plan, run, robot_path);
        before = ",\n";
    }
    add(text, "]\n}\n");
    return text;
}

}  // namespace strandline::formats
