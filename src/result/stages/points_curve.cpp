// One clothoid from point to point (G1 Hermite). The tangent at a point is that of the circle through it and
// two neighbours: both sides', or two on one side. Where the two one-sided circles agree with each other
// better than with the one in the middle, curvature jumps there (a line meets an arc) and they are right;
// where they disagree by much, the point is a corner.
#include "result/stages/points_curve.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::stages {
namespace {

// Points nearer than this (metres) are one.
constexpr double same_place = 1e-6;
// A chord must turn by so much (radians) before a corner is thought of: an arc of 0.2 m radius, the tightest
// that a beachbot's rake follows, turns by 0.25 at samples of 5 cm.
constexpr double least_corner = 0.28;
// A turn of more than this between two chords is always a corner (radians).
constexpr double surely_corner = 1.2;
// A smooth bend that would bulge by more than this beyond its chords (metres) was not sampled: its points are
// a polygon's.
constexpr double most_bulge = 0.02;

/// Directions of the chords and their lengths, of points that all differ.
struct Chords {
    std::vector<double> heading, length;
};
Chords chords_of(const std::vector<Point>& points) {
    Chords chords;
    for (std::size_t i = 1; i < points.size(); ++i) {
        chords.heading.push_back(heading(points[i] - points[i - 1]));
        chords.length.push_back(distance(points[i], points[i - 1]));
    }
    return chords;
}
/// From chord i-1 to chord i: the turn at point i.
double turn_at(const Chords& chords, std::size_t i) {
    return wrap_angle(chords.heading[i] - chords.heading[i - 1]);
}

/// Tangent at point i of the circle through points i-1, i, i+1.
double middle(const Chords& chords, std::size_t i) {
    // the tangent turns off a chord by half the arc over it: shares as the chords' lengths, to the third
    // order
    const Point u = unit(chords.heading[i - 1]), v = unit(chords.heading[i]);
    return heading((1 / chords.length[i - 1]) * u + (1 / chords.length[i]) * v);
}
/// Of the circle through the two points before i and i itself, and through i and the two points after it.
double from_before(const Chords& chords, std::size_t i) {
    return 2 * chords.heading[i - 1] - middle(chords, i - 1);
}
double from_after(const Chords& chords, std::size_t i) {
    return 2 * chords.heading[i] - middle(chords, i + 1);
}

bool is_corner(const Chords& chords, std::size_t i) {
    const std::size_t last = chords.heading.size();
    const double turn = std::abs(turn_at(chords, i));
    if (turn < least_corner) return false;
    if (turn > surely_corner) return true;
    if (std::min(chords.length[i - 1], chords.length[i]) * turn / 8 > most_bulge) return true;
    const double before = i >= 2 ? from_before(chords, i) : chords.heading[i - 1];
    const double after = i + 2 <= last ? from_after(chords, i) : chords.heading[i];
    return std::abs(wrap_angle(after - before)) > std::max(least_corner, turn / 2);
}

/// Tangents of one smooth run of at least two points.
std::vector<double> tangents(const Chords& chords) {
    const std::size_t last = chords.heading.size();
    if (last == 1) return {chords.heading[0], chords.heading[0]};
    std::vector<double> result(last + 1);
    for (std::size_t i = 0; i <= last; ++i) {
        if (i == 0) {
            result[i] = from_after(chords, i);
        } else if (i == last) {
            result[i] = from_before(chords, i);
        } else {
            result[i] = middle(chords, i);
            if (i < 2 || i + 2 > last) continue;
            const double before = from_before(chords, i), apart = wrap_angle(from_after(chords, i) - before);
            const double both = before + apart / 2;
            if (std::abs(apart) < std::abs(wrap_angle(both - result[i]))) result[i] = both;
        }
    }
    return result;
}

/// A curve through points[from..to] without a corner between.
Curve smooth_run(const std::vector<Point>& points, std::size_t from, std::size_t to) {
    const std::vector<Point> run(points.begin() + static_cast<std::ptrdiff_t>(from),
                                 points.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    const std::vector<double> directions = tangents(chords_of(run));
    Curve curve{{run.front(), directions.front()}, {}};
    for (std::size_t i = 1; i < run.size(); ++i) {
        const Curve piece = hermite_clothoid({run[i - 1], directions[i - 1]}, {run[i], directions[i]});
        curve.pieces.insert(curve.pieces.end(), piece.pieces.begin(), piece.pieces.end());
    }
    return curve;
}

}  // namespace

PointsCurve curve_through(const std::vector<Point>& all) {
    std::vector<Point> points;
    std::vector<std::size_t> index;  // of each given point among those that differ
    for (const Point p : all) {
        if (points.empty() || distance(points.back(), p) > same_place) points.push_back(p);
        index.push_back(points.size() - 1);
    }
    PointsCurve result{{}, std::vector<double>(all.size(), 0.0)};
    if (points.size() < 2) return result;

    const Chords chords = chords_of(points);
    std::vector<double> s{0};
    std::size_t begun = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i + 1 < points.size() && !is_corner(chords, i)) continue;
        result.curves.push_back(smooth_run(points, begun, i));
        for (const Clothoid& piece : result.curves.back().pieces) s.push_back(s.back() + piece.length);
        begun = i;
    }
    for (std::size_t i = 0; i < all.size(); ++i) result.s[i] = s[index[i]];
    return result;
}

}  // namespace strandline::stages
