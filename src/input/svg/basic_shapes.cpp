// Elliptic arcs and the shapes made of them.
#include <algorithm>
#include <cmath>

#include "input/svg/outline.hpp"

namespace strandline::svg {

namespace {

/// An arc whose chord is a 1e8th of its radius bulges by 1e-9 of the chord: a line. Its centre would be
/// rounding error.
constexpr double flat_arc = 1e-16;   // squared
constexpr double no_radius = 1e-12;  // of the chord

void append_line(Path& path, Point to) { path.segments.emplace_back(LineSegment{to}); }

}  // namespace

void append_arc(Path& path, Point from, double rx, double ry, double degrees, bool large, bool positive,
                Point to) {
    // Names as in SVG 2, appendix B.2.4: (x1, y1) is half the chord in the ellipse's axes, (cx, cy) the
    // centre there.
    if (from == to) return;
    rx = std::abs(rx);
    ry = std::abs(ry);
    const double chord = distance(from, to);
    if (std::min(rx, ry) <= no_radius * chord) return append_line(path, to);
    const double phi = std::fmod(degrees, 360.0) * pi / 180;
    const Point axis = unit(phi);
    const Point half = 0.5 * (from - to);
    const double x1 = dot(half, axis), y1 = cross(axis, half);
    const double lambda = (x1 / rx) * (x1 / rx) + (y1 / ry) * (y1 / ry);
    if (lambda < flat_arc && !large) return append_line(path, to);
    if (lambda > 1) {
        rx *= std::sqrt(lambda);
        ry *= std::sqrt(lambda);
    }
    // The circle of radius 1 that the ellipse is the image of: half chord (a, b), its centre off to the side
    // by `side`.
    const double a = x1 / rx, b = y1 / ry, squared = a * a + b * b;
    const double side = (large == positive ? -1 : 1) * std::sqrt(std::max(0.0, 1 / squared - 1));
    const double cx = side * b, cy = -side * a;
    const Point u = rx * axis, v = ry * left_normal(axis);
    const Point center = between(from, to, 0.5) + cx * u + cy * v;
    const double start = std::atan2(b - cy, a - cx);
    double sweep = std::atan2(-b - cy, -a - cx) - start;
    if (positive && sweep <= 0) sweep += 2 * pi;
    if (!positive && sweep >= 0) sweep -= 2 * pi;
    if (!is_finite(center) || !is_finite(u) || !is_finite(v) || !std::isfinite(sweep))
        return append_line(path, to);
    path.segments.emplace_back(ArcSegment{center, u, v, start, sweep, to});
}

Path rectangle(double x, double y, double width, double height, double rx, double ry) {
    const double right = x + width, bottom = y + height;
    if (rx <= 0 || ry <= 0)
        return {{x, y},
                {LineSegment{{right, y}}, LineSegment{{right, bottom}}, LineSegment{{x, bottom}},
                 LineSegment{{x, y}}},
                true};
    Path path{{x + rx, y}, {}, true};
    Point at = path.start;
    const auto line = [&](Point to) {
        if (to != at) append_line(path, to);
        at = to;
    };
    const auto corner = [&](Point center, double start, Point to) {
        path.segments.emplace_back(ArcSegment{center, {rx, 0}, {0, ry}, start, pi / 2, to});
        at = to;
    };
    const bool pill = 2 * rx >= width,
               lens = 2 * ry >= height;  // the straight sides vanish, also when rounding says otherwise
    const double left_x = x + rx, right_x = pill ? left_x : right - rx;
    const double top_y = y + ry, low_y = lens ? top_y : bottom - ry;
    line({right_x, y});
    corner({right_x, top_y}, -pi / 2, {right, top_y});
    line({right, low_y});
    corner({right_x, low_y}, 0, {right_x, bottom});
    line({left_x, bottom});
    corner({left_x, low_y}, pi / 2, {x, low_y});
    line({x, top_y});
    corner({left_x, top_y}, pi, path.start);
    return path;
}

Path ellipse(Point center, double rx, double ry) {
    const Point east = center + Point{rx, 0}, south = center + Point{0, ry};
    const Point west = center - Point{rx, 0}, north = center - Point{0, ry};
    Path path{east, {}, true};
    double start = 0;
    for (const Point to : {south, west, north, east}) {
        path.segments.emplace_back(ArcSegment{center, {rx, 0}, {0, ry}, start, pi / 2, to});
        start += pi / 2;
    }
    return path;
}

}  // namespace strandline::svg
