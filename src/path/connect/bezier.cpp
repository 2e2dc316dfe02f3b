// One cubic Bezier with given end curvatures (de Boor, Hoellig and Sabin, High accuracy geometric Hermite
// interpolation, CAGD 1987), driven as clothoids between its points.
#include <algorithm>
#include <cmath>

#include "path/connect/styles.hpp"

namespace strandline::connect {
namespace {

constexpr int pieces = 64;
/// The handle at the start is looked for up to this many chords, on so many samples.
constexpr double longest_handle = 4;
constexpr int samples = 128;

struct Cubic {
    Point a, b, c, d;
    Pose pose(double t) const {
        const double u = 1 - t;
        const Point at = (u * u * u) * a + (3 * u * u * t) * b + (3 * u * t * t) * c + (t * t * t) * d;
        return {at, heading((u * u) * (b - a) + (2 * u * t) * (c - b) + (t * t) * (d - c))};
    }
};

Curve driven(const Cubic& cubic, Pose from, Pose to) {
    Curve curve{from, {}};
    Pose at = from;
    for (int i = 1; i <= pieces; ++i) {
        const Pose next = i < pieces ? cubic.pose(static_cast<double>(i) / pieces) : to;
        curve = joined(std::move(curve), hermite_clothoid(at, next));
        at = next;
    }
    return curve;
}

}  // namespace

std::optional<Curve> bezier(const CurvatureState& from, const CurvatureState& to) {
    const Point t0 = unit(from.pose.heading), t1 = unit(to.pose.heading), chord = to.pose.at - from.pose.at;
    const double d = length(chord), turn = cross(t0, t1);
    if (d == 0) return std::nullopt;
    // Handles a, b: the curvature at the start is 2/3 (t0 x (chord - b t1)) / a^2, at the end likewise.
    std::optional<Curve> best;
    const auto offer = [&](double a, double b) {
        if (!(a > 0 && b > 0)) return;
        const Cubic cubic{from.pose.at, from.pose.at + a * t0, to.pose.at - b * t1, to.pose.at};
        Curve curve = driven(cubic, from.pose, to.pose);
        if (!best || length(curve) < length(*best)) best = std::move(curve);
    };
    constexpr double parallel = 1e-9;
    if (std::abs(turn) < parallel) {
        offer(d / 3, d / 3);
        return best;
    }
    const auto b_of = [&](double a) { return (cross(t0, chord) - 1.5 * from.curvature * a * a) / turn; };
    const auto miss = [&](double a) {
        return 1.5 * to.curvature * b_of(a) * b_of(a) - cross(chord, t1) + a * turn;
    };
    const double step = longest_handle * d / samples;
    for (int i = 0; i < samples; ++i) {
        double low = i * step, high = low + step;
        const bool rises = miss(high) > 0;
        if ((miss(low) > 0) == rises) continue;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            ((miss(middle) > 0) == rises ? high : low) = middle;
        }
        offer(high, b_of(high));
    }
    return best;
}

}  // namespace strandline::connect
