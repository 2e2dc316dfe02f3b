#pragma once
// The plan file's schema, once for both directions: the keys of each object in the order they are written.
// The writer and the reader are visitors that are called with (key, field); how a field of each type looks is
// theirs (docs/plan-format.md).
#include <concepts>
#include <type_traits>

#include "plan/model/model.hpp"

namespace strandline::formats {

inline constexpr const char* plan_format_name = "strandline-plan";

/// T, const or not.
template <class A, class T>
concept Either = std::same_as<std::remove_const_t<A>, T>;

template <class Visit>
void fields(Either<Warning> auto& warning, Visit&& field) {
    field("place", warning.place);
    field("reason", warning.reason);
}

template <class Visit>
void fields(Either<Robot> auto& robot, Visit&& field) {
    field("name", robot.name);
    field("rake_offset", robot.rake_offset);
    field("rake_side", robot.rake_side);
    field("pins", robot.pins);
    field("pin_pitch", robot.pin_pitch);
    field("min_radius", robot.min_radius);
    field("left_radius", robot.left_radius);
    field("right_radius", robot.right_radius);
    field("sharpness", robot.sharpness);
    field("can_pivot", robot.can_pivot);
    field("can_back_up", robot.can_back_up);
    field("speed", robot.speed);
    field("travel_speed", robot.travel_speed);
    field("acceleration", robot.acceleration);
    field("turn_rate", robot.turn_rate);
    field("turn_acceleration", robot.turn_acceleration);
    field("lift_delay", robot.lift_delay);
    field("lifts", robot.lifts);
    field("setback", robot.setback);
    field("fix_noise", robot.fix_noise);
    field("front", robot.front);
    field("back", robot.back);
    field("half_width", robot.half_width);
    field("wheels", robot.wheels);
    field("rake_rules", robot.rake_rules);
    field("fill_wide_strokes", robot.fill_wide_strokes);
}

template <class Visit>
void fields(Either<LineElement> auto& line, Visit&& field) {
    field("pins", line.pins);
    field("path", line.path);
}

template <class Visit>
void fields(Either<Region> auto& region, Visit&& field) {
    field("outer", region.outer);
    field("holes", region.holes);
}

template <class Visit>
void fields(Either<Canvas> auto& canvas, Visit&& field) {
    field("width", canvas.width);
    field("height", canvas.height);
}

template <class Visit>
void fields(Either<DrawingCounts> auto& counts, Visit&& field) {
    field("shapes", counts.shapes);
    field("joined", counts.joined);
    field("duplicates", counts.duplicates);
    field("too_short", counts.too_short);
    field("too_small", counts.too_small);
    field("bare", counts.bare);
    field("merged", counts.merged);
    field("wide_strokes", counts.wide_strokes);
    field("hidden", counts.hidden);
    field("cut", counts.cut);
    field("unchosen", counts.unchosen);
}

template <class Visit>
void fields(Either<Element> auto& element, Visit&& field) {
    field("id", element.id);
    field("layer", element.layer);
    field("inside", element.inside);
    field("hints", element.hints);
    field("section", element.section);
    field("draw", element.what);
}

template <class Visit>
void fields(Either<svg::Hint> auto& hint, Visit&& field) {
    field("name", hint.name);
    field("value", hint.value);
}

template <class Visit>
void fields(Either<Drawing> auto& drawing, Visit&& field) {
    field("canvas", drawing.canvas);
    field("scale", drawing.scale);
    field("scale_denominator", drawing.scale_denominator);
    field("to_canvas", drawing.to_canvas);
    field("start", drawing.start);
    field("border", drawing.border);
    field("keep_out", drawing.keep_out);
    field("counts", drawing.counts);
    field("warnings", drawing.warnings);
    field("elements", drawing.elements);
}

template <class Visit>
void fields(Either<Stroke> auto& stroke, Visit&& field) {
    field("element", stroke.element);
    field("closed", stroke.closed);
    field("one_way", stroke.one_way);
    field("fill", stroke.fill);
    field("pins", stroke.pins);
    field("nodes", stroke.nodes);
    field("rake_path", stroke.rake_path);
}

template <class Visit>
void fields(Either<Entry> auto& entry, Visit&& field) {
    field("stroke", entry.stroke);
    field("node", entry.node);
    field("reversed", entry.reversed);
}

template <class Visit>
void fields(Either<PlannedConnection> auto& connection, Visit&& field) {
    field("from", connection.from);
    field("to", connection.to);
    field("turn_before", connection.turn_before);
    field("turn_after", connection.turn_after);
    field("curve", connection.curve);
}

template <class Visit>
void fields(Either<Spot> auto& spot, Visit&& field) {
    field("what", spot.what);
    field("at", spot.at);
    field("amount", spot.amount);
}

template <class Visit>
void fields(Either<Figures> auto& figures, Visit&& field) {
    field("elements", figures.elements);
    field("lines", figures.lines);
    field("regions", figures.regions);
    field("strokes", figures.strokes);
    field("drawn", figures.drawn);
    field("up_straight", figures.up_straight);
    field("up_dubins", figures.up_dubins);
    field("up_driven", figures.up_driven);
    field("loops_driven", figures.loops_driven);
    field("in_driven", figures.in_driven);
    field("out_driven", figures.out_driven);
    field("time", figures.time);
    field("tightest_up", figures.tightest_up);
    field("tightest_drawn", figures.tightest_drawn);
    field("corners_exact", figures.corners_exact);
    field("corners_rounded", figures.corners_rounded);
    field("corners_looped", figures.corners_looped);
    field("corners_pivoted", figures.corners_pivoted);
    field("direct", figures.direct);
    field("fallbacks", figures.fallbacks);
    field("tour_proven", figures.tour_proven);
    field("tour_parts", figures.tour_parts);
    field("tour_longer", figures.tour_longer);
    field("reproducible", figures.reproducible);
    field("fill_area", figures.fill_area);
    field("fill_swept", figures.fill_swept);
    field("fill_coverage", figures.fill_coverage);
    field("fill_overdraw", figures.fill_overdraw);
    field("fill_spill", figures.fill_spill);
    field("fill_hops", figures.fill_hops);
    field("fill_drives_over", figures.fill_drives_over);
}

/// Samples are columns: one array a field, all of one length; columns of numbers that seldom change are runs
/// [value, count, ...].
struct SampleColumns {
    std::vector<double> t, x, y, heading, curvature, speed, turn_rate, rake_x, rake_y;
    std::vector<long long> mask, stroke;
    std::vector<Motion> motion;
};
template <class Visit>
void fields(Either<SampleColumns> auto& columns, Visit&& field) {
    field("t", columns.t);
    field("x", columns.x);
    field("y", columns.y);
    field("heading", columns.heading);
    field("curvature", columns.curvature);
    field("speed", columns.speed);
    field("turn_rate", columns.turn_rate);
    field("rake_x", columns.rake_x);
    field("rake_y", columns.rake_y);
    field("mask", columns.mask);
    field("motion", columns.motion);
    field("stroke", columns.stroke);
}

template <class Visit>
void fields(Either<Stop> auto& stop, Visit&& field) {
    field("why", stop.why);
    field("stroke", stop.stroke);
    field("time", stop.time);
}

/// After "format" and "version", which the reader looks at first.
template <class Visit>
void fields(Either<Plan> auto& plan, Visit&& field) {
    field("program", plan.program);
    field("title", plan.title);
    field("robot", plan.robot);
    field("options", plan.options);
    field("edits", plan.edits);
    field("idle_edits", plan.idle_edits);
    field("figures", plan.figures);
    field("warnings", plan.warnings);
    field("stops", plan.stops);
    field("undrivable", plan.undrivable);
    field("blemishes", plan.blemishes);
    field("bare", plan.bare);
    field("drawing", plan.drawing);
    field("strokes", plan.strokes);
    field("order", plan.order);
    field("connections", plan.connections);
    field("samples", plan.samples);
}

}  // namespace strandline::formats
