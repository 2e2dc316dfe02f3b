// A path cut at its cusps, and the tangents at the ends of the parts.
#include <algorithm>
#include <cmath>

#include "math/curve/fit.hpp"

namespace strandline::fit {
namespace {

using segments::Jet;

/// What is shorter than this share of the tolerance has no direction worth keeping.
constexpr double negligible = 1e-6;
/// A bend tighter than this share of the tolerance is a cusp: nobody can see that it is round.
constexpr double cusp_radius = 0.1;
/// |P'|^2 of a cubic has at most two minima; this many samples find them apart.
constexpr int slowness_samples = 32;

double extent(Point from, const Segment& segment) {
    if (const auto* c = std::get_if<CubicSegment>(&segment))
        return std::max({distance(from, c->control1), distance(from, c->control2), distance(from, c->to)});
    if (const auto* arc = std::get_if<ArcSegment>(&segment))
        return (length(arc->u) + length(arc->v)) * std::min(1.0, std::abs(arc->sweep));
    return distance(from, end_of(segment));
}

/// Where in (0, 1) the segment runs slowest: the only places of cusps.
std::vector<double> slowest(Point from, const Segment& segment) {
    std::vector<double> ts;
    if (std::holds_alternative<CubicSegment>(segment)) {
        const auto slope = [&](double t) {
            const Jet j = segments::jet(from, segment, t);
            return dot(j.velocity, j.acceleration);
        };
        double before = slope(0);
        for (int i = 1; i <= slowness_samples; ++i) {
            double low = (i - 1.0) / slowness_samples, high = static_cast<double>(i) / slowness_samples;
            const double after = slope(high);
            if (before < 0 && after >= 0) {
                for (int k = 0; k < 50; ++k) {
                    const double middle = (low + high) / 2;
                    (slope(middle) < 0 ? low : high) = middle;
                }
                ts.push_back((low + high) / 2);
            }
            before = after;
        }
    } else if (const auto* arc = std::get_if<ArcSegment>(&segment); arc && arc->sweep != 0) {
        // |P'|^2 = const + a cos 2 angle + b sin 2 angle, smallest half a turn from (a, b).
        const double a = (dot(arc->v, arc->v) - dot(arc->u, arc->u)) / 2, b = -dot(arc->u, arc->v);
        const double low = std::min(arc->start, arc->start + arc->sweep);
        const double high = std::max(arc->start, arc->start + arc->sweep);
        double angle = (std::atan2(b, a) + pi) / 2;
        angle += pi * std::ceil((low - angle) / pi);
        // SVG sweeps at most once round; sixteen half turns bound the work for any other.
        for (int i = 0; i < 16 && angle <= high; ++i, angle += pi)
            ts.push_back((angle - arc->start) / arc->sweep);
        std::ranges::sort(ts);
    }
    return ts;
}

bool is_cusp(Point from, const Segment& segment, double t, double tolerance) {
    const Jet j = segments::jet(from, segment, t);
    const double speed = length(j.velocity);
    return speed * speed * speed <= cusp_radius * tolerance * std::abs(cross(j.velocity, j.acceleration)) ||
           speed <= 1e-9 * extent(from, segment);
}

/// Handles too short to have a direction drawn in to their ends: the curve moves by half of that at most.
Segment without_specks(Point from, const Segment& segment, double tolerance) {
    Segment clean = segment;
    if (auto* c = std::get_if<CubicSegment>(&clean)) {
        const double apart = std::min(tolerance / 100, 1e-3 * extent(from, segment));
        if (distance(from, c->control1) <= apart) c->control1 = from;
        if (distance(c->to, c->control2) <= apart) c->control2 = c->to;
    }
    return clean;
}

/// One-sided direction of a cubic's end: of the first control point that lies apart from it.
double end_heading(Point end, Point a, Point b, Point c) {
    for (Point p : {a, b})
        if (p != end) return heading(p - end);
    return heading(c - end);
}

/// Heading just after (side 1) or just before (side -1) t.
double side_heading(Point from, const Segment& segment, double t, int side, bool cusp) {
    if (const auto* c = std::get_if<CubicSegment>(&segment); c && (t == 0 || t == 1)) {
        return t == 0 ? end_heading(from, c->control1, c->control2, c->to)
                      : end_heading(c->to, c->control2, c->control1, from) + pi;
    }
    const Jet j = segments::jet(from, segment, t);
    if (cusp && length(j.acceleration) > 0) return heading(side * j.acceleration);
    if (length(j.velocity) > 0) return heading(j.velocity);
    return heading(end_of(segment) - from);
}

void add_line(std::vector<Span>& spans, const Segment& segment, Point from) {
    const Point to = end_of(segment);
    const double direction = heading(to - from);
    spans.push_back({from, segment, 0, 1, from, to, direction, direction, 0, true, true});
}

void add_circular_arc(std::vector<Span>& spans, const Segment& segment, const ArcSegment& arc, Point from) {
    const double sense = cross(arc.u, arc.v) * arc.sweep > 0 ? 1 : -1;
    const auto tangent = [&](double t) { return heading(segments::jet(from, segment, t).velocity); };
    spans.push_back(
        {from, segment, 0, 1, from, arc.to, tangent(0), tangent(1), sense / length(arc.u), true, false});
}

bool is_circular(const ArcSegment& arc) {
    const double a = dot(arc.u, arc.u), b = dot(arc.v, arc.v);
    return std::abs(a - b) <= 1e-9 * a && std::abs(dot(arc.u, arc.v)) <= 1e-9 * a;
}

void add_curved(std::vector<Span>& spans, const Segment& drawn, Point from, double tolerance) {
    const Segment segment = without_specks(from, drawn, tolerance);
    std::vector<double> cuts{0};
    for (double t : slowest(from, segment))
        if (t > 1e-6 && t < 1 - 1e-6 && is_cusp(from, segment, t, tolerance)) cuts.push_back(t);
    cuts.push_back(1);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double a = cuts[i - 1], b = cuts[i];
        spans.push_back({from, segment, a, b, segments::point(from, segment, a),
                         segments::point(from, segment, b), side_heading(from, segment, a, 1, i > 1),
                         side_heading(from, segment, b, -1, i + 1 < cuts.size()), 0, false, false});
    }
}

}  // namespace

std::vector<Span> spans(const Path& path, double tolerance) {
    std::vector<Span> spans;
    const double shortest = negligible * tolerance;
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        const Point to = end_of(segment);
        if (std::holds_alternative<LineSegment>(segment)) {
            if (distance(from, to) <= shortest) continue;  // the next segment starts where this one did
            add_line(spans, segment, from);
        } else if (extent(from, segment) > shortest) {
            const auto* arc = std::get_if<ArcSegment>(&segment);
            if (arc && is_circular(*arc))
                add_circular_arc(spans, segment, *arc, from);
            else
                add_curved(spans, segment, from, tolerance);
        }
        from = to;
    }
    return spans;
}

}  // namespace strandline::fit
