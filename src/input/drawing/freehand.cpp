// Lines that a hand drew: fewer points (Douglas and Peucker, Cartographica 1973), or smooth curves through
// the jitter (Schneider, An Algorithm for Automatically Fitting Digitized Curves, Graphics Gems, 1990).
#include <algorithm>
#include <cmath>
#include <span>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

/// A turn that large (radians) of the simplified line is meant as a corner.
constexpr double meant_corner = pi / 3;
/// Rounds of placing the points anew on the curve (Newton); more gain nothing.
constexpr int most_rounds = 6;
/// A fit that is off by less than this many tolerances is worth such rounds; a worse one is cut in two.
constexpr double worth_a_round = 4;

/// Of a closed line the first point comes again at the end; it begins at the point farthest from its middle,
/// which is the likeliest corner.
std::vector<Point> points_of(const Path& path, double tolerance) {
    std::vector<Point> points = flattened(path, tolerance / 4);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (!path.closed || points.size() < 3) return points;
    Point middle{};
    for (Point p : points) middle = middle + (1.0 / static_cast<double>(points.size())) * p;
    const auto corner = std::ranges::max_element(points, {}, [&](Point p) { return distance(p, middle); });
    std::rotate(points.begin(), corner, points.end());
    points.push_back(points.front());
    return points;
}

struct Bezier {
    Point p0, p1, p2, p3;
    Point at(double t) const {
        const double u = 1 - t;
        return u * u * u * p0 + 3 * u * u * t * p1 + 3 * u * t * t * p2 + t * t * t * p3;
    }
    Point slope(double t) const {
        const double u = 1 - t;
        return 3 * u * u * (p1 - p0) + 6 * u * t * (p2 - p1) + 3 * t * t * (p3 - p2);
    }
    Point bend(double t) const { return 6 * (1 - t) * (p2 - 2 * p1 + p0) + 6 * t * (p3 - 2 * p2 + p1); }
};

/// The cubic with these end tangents nearest to the points in the sense of least squares. run: length of the
/// chords through the points.
Bezier nearest(std::span<const Point> points, const std::vector<double>& t, double run, Point out, Point in) {
    double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
    const Point first = points.front(), last = points.back();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double u = 1 - t[i], b0 = u * u * u, b1 = 3 * t[i] * u * u, b2 = 3 * t[i] * t[i] * u,
                     b3 = t[i] * t[i] * t[i];
        const Point a0 = b1 * out, a1 = b2 * in, rest = points[i] - ((b0 + b1) * first + (b2 + b3) * last);
        c00 += dot(a0, a0);
        c01 += dot(a0, a1);
        c11 += dot(a1, a1);
        x0 += dot(a0, rest);
        x1 += dot(a1, rest);
    }
    const double determinant = c00 * c11 - c01 * c01;
    double reach0 = determinant != 0 ? (x0 * c11 - x1 * c01) / determinant : 0;
    double reach1 = determinant != 0 ? (c00 * x1 - c01 * x0) / determinant : 0;
    // Handles that point backward, or none, or longer than the line itself (few points, which a curve that
    // runs away between them meets as well): a third of the chord (Wu and Barsky's rule).
    const double chord = distance(first, last);
    const auto fair = [&](double reach) { return reach > 1e-6 * chord && reach <= run; };
    if (!fair(reach0) || !fair(reach1)) reach0 = reach1 = chord / 3;
    return {first, first + reach0 * out, last + reach1 * in, last};
}

/// How far the points are from the curve, and the curve from the chords between them; the number of the worst
/// inner point.
struct Misfit {
    double points = 0, between = 0;
    std::size_t at = 0;
};
Misfit misfit(const Bezier& curve, std::span<const Point> points, const std::vector<double>& t) {
    Misfit misfit{0, 0, points.size() / 2};
    double worst = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double off = i + 1 < points.size() ? distance(curve.at(t[i]), points[i]) : 0;
        double between = 0;
        for (const double share : {0.25, 0.5, 0.75})
            between = std::max(between, distance_to_segment(curve.at(t[i - 1] + share * (t[i] - t[i - 1])),
                                                            points[i - 1], points[i]));
        misfit.points = std::max(misfit.points, off);
        misfit.between = std::max(misfit.between, between);
        if (std::max(off, between) > worst) {
            worst = std::max(off, between);
            misfit.at = std::min(i, points.size() - 2);
        }
    }
    return misfit;
}

Point direction(Point from, Point to) {
    const double l = distance(from, to);
    return l > 0 ? (1 / l) * (to - from) : Point{1, 0};
}

/// Where the line heads from an end: towards the first point that is well away from it, so that jitter does
/// not decide.
Point heading_from_end(std::span<const Point> points, double away) {
    for (const Point p : points)
        if (distance(points.front(), p) >= away) return direction(points.front(), p);
    return direction(points.front(), points.back());
}

void fit(std::span<const Point> points, Point out, Point in, double tolerance, Path& path) {
    if (points.size() == 2) {
        path.segments.push_back(LineSegment{points[1]});
        return;
    }
    std::vector<double> t{0};
    for (std::size_t i = 1; i < points.size(); ++i)
        t.push_back(t.back() + distance(points[i - 1], points[i]));
    const double run = t.back();
    for (double& place : t) place /= run;
    std::size_t worst_at = points.size() / 2;
    for (int round = 0; round <= most_rounds; ++round) {
        const Bezier curve = nearest(points, t, run, out, in);
        const Misfit off = misfit(curve, points, t);
        worst_at = off.at;
        if (off.points <= tolerance && off.between <= tolerance) {
            path.segments.push_back(CubicSegment{curve.p1, curve.p2, curve.p3});
            return;
        }
        if (off.points > worth_a_round * tolerance) break;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const Point away = curve.at(t[i]) - points[i], slope = curve.slope(t[i]);
            const double curvature = dot(slope, slope) + dot(away, curve.bend(t[i]));
            // in order, so that no two points share a place
            if (curvature > 0) t[i] = std::clamp(t[i] - dot(away, slope) / curvature, t[i - 1], t[i + 1]);
        }
    }
    // The tangent at the cut: across the neighbourhood, not from point to point.
    std::size_t before = worst_at, after = worst_at;
    while (before > 0 && distance(points[before], points[worst_at]) < 2 * tolerance) --before;
    while (after + 1 < points.size() && distance(points[after], points[worst_at]) < 2 * tolerance) ++after;
    const Point along = direction(points[before], points[after]);
    fit(points.first(worst_at + 1), out, -1 * along, tolerance, path);
    fit(points.subspan(worst_at), along, in, tolerance, path);
}

}  // namespace

Path simplified(const Path& path, double tolerance) {
    const std::vector<Point> points = points_of(path, tolerance);
    if (points.size() < 3) return path;
    std::vector<Point> fewer;
    for (const std::size_t i : thinned(points, tolerance)) fewer.push_back(points[i]);
    if (path.closed) fewer.pop_back();
    return fewer.size() < (path.closed ? 3U : 2U) ? path : path_through(fewer, path.closed);
}

Path smoothed(const Path& path, double tolerance) {
    const std::vector<Point> points = points_of(path, tolerance);
    if (points.size() < 3) return path;
    const std::vector<std::size_t> bones = thinned(points, tolerance);
    std::vector<std::size_t> corners{0};
    const auto turn = [&](std::size_t before, std::size_t at, std::size_t after) {
        return std::abs(
            wrap_angle(heading(points[after] - points[at]) - heading(points[at] - points[before])));
    };
    for (std::size_t k = 1; k + 1 < bones.size(); ++k)
        if (turn(bones[k - 1], bones[k], bones[k + 1]) >= meant_corner) corners.push_back(bones[k]);
    corners.push_back(points.size() - 1);
    // A closed line whose seam is no corner goes through it in one direction.
    const bool smooth_seam =
        path.closed && bones.size() > 2 && turn(bones[bones.size() - 2], 0, bones[1]) < meant_corner;
    const Point seam = smooth_seam ? direction(points[bones[bones.size() - 2]], points[bones[1]]) : Point{};
    Path smooth{points.front(), {}, path.closed};
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const std::span<const Point> part(points.data() + corners[k], corners[k + 1] - corners[k] + 1);
        const std::vector<Point> back(part.rbegin(), part.rend());
        const Point out = smooth_seam && k == 0 ? seam : heading_from_end(part, 2 * tolerance);
        const Point in =
            smooth_seam && k + 2 == corners.size() ? -1 * seam : heading_from_end(back, 2 * tolerance);
        fit(part, out, in, tolerance, smooth);
    }
    return smooth;
}

}  // namespace strandline::drawing_parts
