// Where clothoid curves run, and what is read off and cut from them.
#include <algorithm>
#include <array>
#include <cmath>

#include "math/curve/curve.hpp"
#include "math/curve/quadrature.hpp"

namespace strandline {
namespace {

/// Ten Gauss-Legendre nodes err by less than 1e-15 of the panel while it turns by at most this much
/// (radians).
constexpr double panel_turning = 1.5;
/// A curve that winds more than this is not meant to be driven; it costs time, not memory.
constexpr double most_panels = 1e6;

/// (sin x / x, (1 - cos x) / x): a circular arc in closed form, with its digits kept near straightness.
Point chord_factors(double x) {
    if (std::abs(x) < 1e-4) return {1 - x * x / 6, x / 2 - x * x * x / 24};
    const double half = std::sin(x / 2);
    return {std::sin(x) / x, 2 * half * half / x};
}

/// 1 / (n (n + 1)): what a term of the sine or cosine series takes from the one before.
constexpr auto series = [] {
    std::array<double, 17> shares{};
    for (std::size_t n = 1; n < shares.size(); ++n) shares[n] = 1.0 / static_cast<double>(n * (n + 1));
    return shares;
}();
/// (cos x, sin x) by their Taylor series: errs by less than 1e-17 up to half of panel_turning.
Point small_turn(double x) {
    const double y = x * x;
    double cosine = 1, sine = 1;
    for (std::size_t n = series.size(); n > 2;) {
        n -= 2;
        cosine = 1 - y * series[n] * cosine;
        sine = 1 - y * series[n + 1] * sine;
    }
    return {cosine, x * sine};
}

/// Finds the piece that holds arc length s and the state at its start.
template <class Visit>
void for_pieces(const Curve& curve, Visit visit) {
    Pose pose = curve.start;
    double s = 0;
    for (const Clothoid& piece : curve.pieces) {
        visit(pose, s, piece);
        pose = advanced(pose, piece, piece.length);
        s += std::abs(piece.length);
    }
}

/// `local`: metres driven within the piece.
CurvePoint state(Pose start, double s0, const Clothoid& piece, double local) {
    const double along = std::copysign(local, piece.length);
    return {s0 + local, advanced(start, piece, along), piece.curvature + piece.sharpness * along};
}

}  // namespace

Pose advanced(Pose start, const Clothoid& piece, double s) {
    const double k = piece.curvature, sharpness = piece.sharpness;
    const double turned = s * (k + 0.5 * sharpness * s);
    if (sharpness == 0) {
        const Point f = chord_factors(turned), ahead = unit(start.heading);
        return {start.at + s * (f.x * ahead + f.y * left_normal(ahead)), start.heading + turned};
    }
    const double turning = std::abs(s) * std::max(std::abs(k), std::abs(k + sharpness * s));
    const double panels = std::clamp(std::ceil(turning / panel_turning), 1.0, most_panels);
    Point sum{};
    for (double i = 0; i < panels; ++i) {
        // Seen from the panel's middle every heading is near: one sine and cosine serve the panel.
        const double from = s * i / panels, to = s * (i + 1) / panels, middle = (from + to) / 2;
        const double k_middle = k + sharpness * middle;
        Point panel{};
        quadrature::panel(from, to, [&](double t, double weight) {
            const double u = t - middle;
            panel = panel + weight * small_turn(u * (k_middle + 0.5 * sharpness * u));
        });
        const Point ahead = unit(start.heading + middle * (k + 0.5 * sharpness * middle));
        sum = sum + panel.x * ahead + panel.y * left_normal(ahead);
    }
    return {start.at + sum, start.heading + turned};
}

Pose end_pose(const Curve& curve) {
    Pose pose = curve.start;
    for (const Clothoid& piece : curve.pieces) pose = advanced(pose, piece, piece.length);
    return pose;
}

double length(const Curve& curve) {
    double sum = 0;
    for (const Clothoid& piece : curve.pieces) sum += std::abs(piece.length);
    return sum;
}

double length(const std::vector<Curve>& curves) {
    double sum = 0;
    for (const Curve& curve : curves) sum += length(curve);
    return sum;
}

double max_curvature(const Curve& curve) {
    double most = 0;
    for (const Clothoid& piece : curve.pieces)
        most = std::max({most, std::abs(piece.curvature), std::abs(piece.end_curvature())});
    return most;
}

double max_sharpness(const Curve& curve) {
    double most = 0;
    for (const Clothoid& piece : curve.pieces)
        if (piece.length != 0) most = std::max(most, std::abs(piece.sharpness));
    return most;
}

double max_curvature_jump(const Curve& curve) {
    double most = 0;
    for (std::size_t i = 1; i < curve.pieces.size(); ++i) {
        const Clothoid &a = curve.pieces[i - 1], &b = curve.pieces[i];
        if (backs(a) == backs(b)) most = std::max(most, std::abs(b.curvature - a.end_curvature()));
    }
    return most;
}

CurvePoint point_at(const Curve& curve, double s) {
    Pose pose = curve.start;
    double s0 = 0;
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
        const Clothoid& piece = curve.pieces[i];
        const double far = std::abs(piece.length);
        if (s - s0 <= far || i + 1 == curve.pieces.size())
            return state(pose, s0, piece, std::clamp(s - s0, 0.0, far));
        pose = advanced(pose, piece, piece.length);
        s0 += far;
    }
    return {0, curve.start, 0};
}

std::vector<CurvePoint> sampled(const Curve& curve, double step, int least) {
    if (curve.pieces.empty()) return {{0, curve.start, 0}};
    const double whole = length(curve);
    const double steps = std::max({1.0, static_cast<double>(least - 1), std::ceil(whole / step - 1e-9)});
    std::vector<CurvePoint> points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    double next = 0, k = 0;
    for_pieces(curve, [&](Pose pose, double s0, const Clothoid& piece) {
        for (; k < steps && next <= s0 + std::abs(piece.length); next = ++k / steps * whole)
            points.push_back(state(pose, s0, piece, next - s0));
    });
    Clothoid last = curve.pieces.back();
    points.push_back({whole, end_pose(curve), last.end_curvature()});
    return points;
}

Curve reversed(const Curve& curve) {
    Curve back{end_pose(curve), {}};
    back.start.heading += pi;
    back.pieces.reserve(curve.pieces.size());
    for (std::size_t i = curve.pieces.size(); i-- > 0;) {
        const Clothoid& piece = curve.pieces[i];
        back.pieces.push_back({piece.length, -piece.end_curvature(), piece.sharpness});
    }
    return back;
}

Curve slice(const Curve& curve, double from, double to) {
    Curve part{curve.start, {}};
    bool started = false;
    for_pieces(curve, [&](Pose pose, double s0, const Clothoid& piece) {
        const double far = std::abs(piece.length), a = std::max(0.0, from - s0), b = std::min(far, to - s0);
        if (a > far || b < a || (started && b == a)) return;
        const CurvePoint first = state(pose, s0, piece, a);
        if (!started || part.pieces.empty()) part.start = first.pose;
        started = true;
        if (b > a)
            part.pieces.push_back({std::copysign(b - a, piece.length), first.curvature, piece.sharpness});
    });
    if (!started) part.start = from <= 0 ? curve.start : end_pose(curve);
    return part;
}

Curve joined(Curve first, const Curve& second) {
    if (first.pieces.empty()) return second;
    first.pieces.insert(first.pieces.end(), second.pieces.begin(), second.pieces.end());
    return first;
}

Curve straight(Pose start, double length) { return {start, {{length, 0, 0}}}; }

bool backs(const Clothoid& piece) { return piece.length < 0; }

int stands(const Curve& curve) {
    int count = 0;
    bool back = false;  // before the curve, and after it, the robot drives forward
    for (const Clothoid& piece : curve.pieces) {
        if (backs(piece) != back) ++count;
        back = backs(piece);
    }
    return count + (back ? 1 : 0);
}

std::vector<Curve> sections(const Curve& curve) {
    std::vector<Curve> found;
    for_pieces(curve, [&](Pose pose, double, const Clothoid& piece) {
        if (found.empty() || backs(found.back().pieces.back()) != backs(piece)) found.push_back({pose, {}});
        found.back().pieces.push_back(piece);
    });
    return found;
}

}  // namespace strandline
