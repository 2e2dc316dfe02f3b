#include "math/curve/three_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::turns {
namespace {

constexpr int most_steps = 8;
/// A first step of Newton longer than this (curvature, or turning at the limit in radians) comes from a seed
/// that belongs to another curve, or to none.
constexpr double farthest_step = 4;
/// What is shorter by less than this share is the same curve.
constexpr double worthwhile = 1 - 1e-9;

constexpr Point mirrored(Point a) { return {a.x, -a.y}; }
constexpr Point turned(Point a) { return {-a.y, a.x}; }

}  // namespace

std::pair<double, double> peak_and_stay(const Spiral& spiral, double side, double q) {
    const double p = std::clamp(q, -spiral.limit(-side).curvature, spiral.limit(side).curvature);
    return {p, 2 * std::abs(q - p) / spiral.sharpness};
}

ThreePeaks::ThreePeaks(const Task& task, double side, double known)
    : spiral_(task.spiral),
      side_(side),
      best_(known),
      sigma_(task.spiral.sharpness),
      begin_(side * task.begin),
      end_(side * task.end),
      left_(task.spiral.limit(side)),
      right_(task.spiral.limit(-side)),
      to_{task.to.x, side * task.to.y},
      g0_(-task.spiral.heading(begin_)),
      g3_(side * task.heading + task.spiral.heading(end_)),
      spiral_begin_(task.spiral.at(begin_)),
      spiral_end_(task.spiral.at(end_)),
      tolerance_(root_accuracy * (1 + length(task.to))) {}

Peak ThreePeaks::peak(double q) const {
    const auto at_limit = [&](const Spiral::Limit& limit, double sign) {
        const double angle =
            2 * limit.heading + limit.curvature * 2 * (std::abs(q) - limit.curvature) / sigma_;
        return Peak{q, sign * limit.curvature, angle, sign * limit.at, mirrored(limit.back), true};
    };
    if (q >= left_.curvature) return at_limit(left_, 1);
    if (q <= -right_.curvature) return at_limit(right_, -1);
    const double h = spiral_.heading(q);
    return {q, q, 2 * h, spiral_.at(q), unit(h), false};
}

Peak ThreePeaks::turning(double turn, double sign) const {
    const Spiral::Limit& limit = sign > 0 ? left_ : right_;
    const double stay = turn - 2 * limit.heading;
    return peak(sign * (stay > 0 ? limit.curvature + stay * sigma_ / (2 * limit.curvature)
                                 : std::sqrt(sigma_ * std::max(0.0, turn))));
}

ThreePeaks::Miss ThreePeaks::miss(const Peak& a, const Peak& v, const Peak& b, double g3_wanted) const {
    const double g1 = g0_ + a.turn, g2 = g1 - v.turn, g3 = g2 + b.turn;
    const Point u0 = unit(g0_), u1 = unit(g1), u2 = unit(g2), u3 = unit(g3);
    // Headings where ramps meet peaks: going up to the first, leaving it, and so on.
    const Point up1 = rotated(u0, a.ahead), down1 = rotated(u1, mirrored(a.ahead));
    const Point down2 = rotated(u1, mirrored(v.ahead)), up2 = rotated(u2, v.ahead);
    const Point up3 = rotated(u2, b.ahead), down3 = rotated(u3, mirrored(b.ahead));
    const Point ramp0 = rotated(u0, a.spiral - spiral_begin_);
    const Point ramp1 = rotated(u1, mirrored(a.spiral - v.spiral));
    const Point ramp2 = rotated(u2, b.spiral - v.spiral);
    const Point ramp3 = rotated(u3, mirrored(b.spiral - spiral_end_));
    const auto arc = [](const Peak& peak, Point in, Point out) {
        return peak.stays ? (1 / peak.p) * (turned(in) - turned(out)) : Point{};
    };
    const Point after2 = ramp2 + arc(b, up3, down3) + ramp3, after1 = ramp1 + arc(v, down2, up2) + after2;
    // A longer peak moves all that follows it, and turns it: by the stay's end where it stays, by both ramps
    // where it does not.
    const double s = 2 / sigma_;
    const auto by = [&](const Peak& peak, Point in, Point out, Point after, double sign) {
        if (peak.stays) return sign * s * (out + peak.p * turned(after));
        return (sign / sigma_) * (in + out) + (sign * s * peak.p) * turned(after);
    };
    return {ramp0 + arc(a, up1, down1) + after1 - to_, g3 - g3_wanted, by(a, up1, down1, after1, 1),
            by(v, down2, up2, after2, -1), by(b, up3, down3, ramp3, 1)};
}

void ThreePeaks::newton(Peak a, Peak v, Peak b, std::vector<Found>& found) {
    const double total = g0_ + a.turn - v.turn + b.turn, s = 2 / sigma_;
    const double g3 = g3_ + 2 * pi * std::round((total - g3_) / (2 * pi));
    for (int k = 0; k < most_steps; ++k) {
        const Miss m = miss(a, v, b, g3);
        if (std::abs(m.at.x) + std::abs(m.at.y) < tolerance_ && std::abs(m.turn) < 1e-13)
            return offer(a, v, b, found);
        // The heading's derivatives; the position's are in m.
        const double h1 = s * a.p, h2 = -s * v.p, h3 = s * b.p;
        const double c23 = cross(m.by2, m.by3), c31 = cross(m.by3, m.by1), c12 = cross(m.by1, m.by2);
        const double det = h1 * c23 + h2 * c31 + h3 * c12;
        if (det == 0) return;
        const Point r = -m.at;
        const double t = -m.turn;
        const double d1 = (t * c23 + h2 * cross(m.by3, r) + h3 * cross(r, m.by2)) / det;
        const double d2 = (h1 * cross(r, m.by3) + t * c31 + h3 * cross(m.by1, r)) / det;
        const double d3 = (h1 * cross(m.by2, r) + h2 * cross(r, m.by1) + t * c12) / det;
        if (k == 0) {
            if (!(length_of(a.q + d1, v.q + d2, b.q + d3) < best_ * worthwhile)) return;
            const double far = std::max({std::abs(d1), std::abs(d2), std::abs(d3)});
            if (far > farthest_step * std::max(1.0, sigma_ / 2)) return;
        }
        a = peak(std::max(a.q + d1, -right_.curvature));
        v = peak(std::min(v.q + d2, left_.curvature));
        b = peak(std::max(b.q + d3, -right_.curvature));
    }
}

void ThreePeaks::offer(const Peak& a, const Peak& v, const Peak& b, std::vector<Found>& found) {
    constexpr double rounding = 1e-13;
    if (a.q < begin_ - rounding || b.q < end_ - rounding || v.p > std::min(a.p, b.p) + rounding) return;
    const double whole = length_of(a.q, v.q, b.q);
    if (!(whole < best_ * worthwhile)) return;
    best_ = whole;
    found.push_back({Found::three_peaks, whole, a.q, v.q, b.q, side_});
}

}  // namespace strandline::turns
