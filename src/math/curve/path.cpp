// Exact paths: ends, maps, chords, lengths and boxes of lines, cubic Beziers and elliptic arcs.
#include <algorithm>
#include <array>
#include <cmath>

#include "math/curve/curve.hpp"
#include "math/curve/quadrature.hpp"
#include "math/curve/segments.hpp"

namespace strandline {
namespace {

/// Chords of one segment and of a whole path at most: a wild input must not fill the memory.
constexpr double most_chords = 1e6;
/// Halvings of a segment for its length: 2^-40 of it is below rounding even at a cusp.
constexpr int length_depth = 40;
constexpr double length_accuracy = 1e-10;

template <class... Ts>
struct Visitor : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Visitor(Ts...) -> Visitor<Ts...>;

double speed_integral(Point from, const Segment& segment, double t0, double t1) {
    double sum = 0;
    quadrature::panel(t0, t1, [&](double t, double weight) {
        sum += weight * strandline::length(segments::jet(from, segment, t).velocity);
    });
    return sum;
}

double refined_length(Point from, const Segment& segment, double t0, double t1, double whole, double accuracy,
                      int depth) {
    const double middle = (t0 + t1) / 2;
    const double first = speed_integral(from, segment, t0, middle);
    const double second = speed_integral(from, segment, middle, t1);
    if (depth == 0 || !(std::abs(first + second - whole) > accuracy)) return first + second;
    return refined_length(from, segment, t0, middle, first, accuracy, depth - 1) +
           refined_length(from, segment, middle, t1, second, accuracy, depth - 1);
}

/// Parameters in (0, 1) where a cubic coordinate with these four controls stands still.
void add_cubic_extrema(double p0, double p1, double p2, double p3, std::vector<double>& ts) {
    const double a = p3 - 3 * p2 + 3 * p1 - p0, b = 2 * (p2 - 2 * p1 + p0), c = p1 - p0;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0) ts.push_back(q / a);
    if (q != 0) ts.push_back(c / q);
}

/// Parameters where one coordinate of an arc stands still: tan t = v / u.
void add_arc_extrema(double u, double v, const ArcSegment& arc, std::vector<double>& ts) {
    if (arc.sweep == 0 || (u == 0 && v == 0)) return;
    const double first = std::atan2(v, u);
    const double low = std::min(arc.start, arc.start + arc.sweep),
                 high = std::max(arc.start, arc.start + arc.sweep);
    double t = first + pi * std::ceil((low - first) / pi);
    // Four half turns show every extremum of any sweep.
    for (int i = 0; i < 4 && t <= high; ++i, t += pi) ts.push_back((t - arc.start) / arc.sweep);
}

}  // namespace

namespace segments {

Jet jet(Point from, const Segment& segment, double t) {
    return std::visit(
        Visitor{[&](const LineSegment& line) {
                    return Jet{between(from, line.to, t), line.to - from, Point{}};
                },
                [&](const CubicSegment& c) {
                    const double r = 1 - t;
                    const Point d0 = c.control1 - from, d1 = c.control2 - c.control1, d2 = c.to - c.control2;
                    return Jet{r * r * r * from + 3 * r * r * t * c.control1 + 3 * r * t * t * c.control2 +
                                   t * t * t * c.to,
                               3 * (r * r * d0 + 2 * r * t * d1 + t * t * d2),
                               6 * (r * (d1 - d0) + t * (d2 - d1))};
                },
                [&](const ArcSegment& arc) {
                    const double angle = arc.start + t * arc.sweep, c = std::cos(angle), s = std::sin(angle);
                    const Point radial = c * arc.u + s * arc.v;
                    return Jet{arc.center + radial, arc.sweep * (c * arc.v - s * arc.u),
                               -arc.sweep * arc.sweep * radial};
                }},
        segment);
}

Point point(Point from, const Segment& segment, double t) {
    if (t <= 0) return from;
    if (t >= 1) return end_of(segment);
    return jet(from, segment, t).at;
}

double length(Point from, const Segment& segment, double t0, double t1) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) return (t1 - t0) * distance(from, line->to);
    const double whole = speed_integral(from, segment, t0, t1);
    return refined_length(from, segment, t0, t1, whole, length_accuracy * whole, length_depth);
}

double acceleration_bound(Point from, const Segment& segment) {
    return std::visit(Visitor{[](const LineSegment&) { return 0.0; },
                              [&](const CubicSegment& c) {
                                  return 6 * std::max(length(from - 2 * c.control1 + c.control2),
                                                      length(c.control1 - 2 * c.control2 + c.to));
                              },
                              [](const ArcSegment& arc) {  // the largest singular value of (u v)
                                  const double a = dot(arc.u, arc.u), b = dot(arc.v, arc.v);
                                  const double longest =
                                      (a + b + std::hypot(a - b, 2 * dot(arc.u, arc.v))) / 2;
                                  return arc.sweep * arc.sweep * std::sqrt(longest);
                              }},
                      segment);
}

}  // namespace segments

Point end_of(const Segment& segment) {
    return std::visit([](const auto& s) { return s.to; }, segment);
}
Point end_of(const Path& path) { return path.segments.empty() ? path.start : end_of(path.segments.back()); }

Path transformed(const Path& path, const Affine& map) {
    Path result{apply(map, path.start), {}, path.closed};
    result.segments.reserve(path.segments.size());
    for (const Segment& segment : path.segments)
        result.segments.push_back(std::visit(
            Visitor{[&](const LineSegment& s) -> Segment { return LineSegment{apply(map, s.to)}; },
                    [&](const CubicSegment& s) -> Segment {
                        return CubicSegment{apply(map, s.control1), apply(map, s.control2), apply(map, s.to)};
                    },
                    [&](const ArcSegment& s) -> Segment {
                        return ArcSegment{apply(map, s.center),
                                          apply_to_vector(map, s.u),
                                          apply_to_vector(map, s.v),
                                          s.start,
                                          s.sweep,
                                          apply(map, s.to)};
                    }},
            segment));
    return result;
}

Path reversed(const Path& path) {
    Path result{end_of(path), {}, path.closed};
    result.segments.reserve(path.segments.size());
    for (std::size_t i = path.segments.size(); i-- > 0;) {
        const Point to = i == 0 ? path.start : end_of(path.segments[i - 1]);
        result.segments.push_back(
            std::visit(Visitor{[&](const LineSegment&) -> Segment { return LineSegment{to}; },
                               [&](const CubicSegment& s) -> Segment {
                                   return CubicSegment{s.control2, s.control1, to};
                               },
                               [&](const ArcSegment& s) -> Segment {
                                   return ArcSegment{s.center, s.u, s.v, s.start + s.sweep, -s.sweep, to};
                               }},
                       path.segments[i]));
    }
    return result;
}

Path path_through(const std::vector<Point>& points, bool closed) {
    if (points.empty()) return {};
    Path path{points.front(), {}, closed};
    for (std::size_t i = 1; i < points.size(); ++i) path.segments.emplace_back(LineSegment{points[i]});
    if (closed && points.back() != points.front()) path.segments.emplace_back(LineSegment{points.front()});
    return path;
}

std::vector<Point> flattened(const Path& path, double tolerance) {
    std::vector<Point> points{path.start};
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        // A chord over h leaves the curve by at most h^2 max|P''| / 8.
        const double wanted =
            std::ceil(std::sqrt(segments::acceleration_bound(from, segment) / (8 * tolerance)));
        const double room = std::max(1.0, most_chords - static_cast<double>(points.size()));
        const double chords = std::clamp(std::isfinite(wanted) ? wanted : 1.0, 1.0, room);
        for (double k = 1; k < chords; ++k) points.push_back(segments::point(from, segment, k / chords));
        from = end_of(segment);
        points.push_back(from);
    }
    if (path.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
    return points;
}

double length(const Path& path) {
    double sum = 0;
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        sum += segments::length(from, segment);
        from = end_of(segment);
    }
    return sum;
}

Box bounds(const Path& path) {
    Box box = including(Box{}, path.start);
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        std::vector<double> ts;
        if (const auto* c = std::get_if<CubicSegment>(&segment)) {
            add_cubic_extrema(from.x, c->control1.x, c->control2.x, c->to.x, ts);
            add_cubic_extrema(from.y, c->control1.y, c->control2.y, c->to.y, ts);
        } else if (const auto* arc = std::get_if<ArcSegment>(&segment)) {
            add_arc_extrema(arc->u.x, arc->v.x, *arc, ts);
            add_arc_extrema(arc->u.y, arc->v.y, *arc, ts);
        }
        for (double t : ts)
            if (t > 0 && t < 1) box = including(box, segments::point(from, segment, t));
        from = end_of(segment);
        box = including(box, from);
    }
    return box;
}

}  // namespace strandline
