// The style of the thesis of 2014: a spiro spline (Levien, From spiral to spline, PhD thesis, Berkeley 2009)
// by libspiro, through control points ahead of the start and behind the end. The solver gives each segment as
// curvature polynomial k(s) = k0 + k1 s + k2 s^2/2 + k3 s^3/6 for s from -1/2 to 1/2, at the scale of its
// chord: from it come the poses that are joined by clothoids, not from the Beziers that libspiro makes of it.
#include <bezctx.h>
#include <spiro.h>
#include <spiroentrypoints.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "path/connect/styles.hpp"

namespace strandline::connect {
namespace {

/// The ends are held straight over this share of the radius: so the spline takes their heading.
constexpr double held = 0.01;
/// Control points lie this many radii from the ends.
constexpr double reach = 2;
/// Ends that look along the way between them (radians) need no control points.
constexpr double along = pi / 5;
/// Clothoids a segment.
constexpr int pieces = 64;

/// The polynomials' variable at a joint of the clothoids.
double share(int joint) { return static_cast<double>(joint) / pieces - 0.5; }

/// Three cases: along the way, no points; else one ahead of the start and one behind the end; and where those
/// come nearer to each other than a reach, pushed apart from their middle.
std::vector<spiro_cp> control_points(Pose from, Pose to, double radius) {
    const Point ahead = unit(from.heading), back = -unit(to.heading);
    const auto cp = [](Point p, char type) { return spiro_cp{p.x, p.y, type}; };
    std::vector<spiro_cp> points{cp(from.at, SPIRO_OPEN_CONTOUR),
                                 cp(from.at + held * radius * ahead, SPIRO_RIGHT)};
    const double way = heading(to.at - from.at);
    const bool straight_on = std::abs(wrap_angle(from.heading - way)) < along &&
                             std::abs(wrap_angle(to.heading - way)) < along &&
                             std::abs(wrap_angle(to.heading - from.heading)) < along;
    if (!straight_on) {
        Point first = from.at + reach * radius * ahead, last = to.at + reach * radius * back;
        const double apart = distance(first, last);
        if (apart < reach * radius) {
            const Point middle = first + 0.5 * (last - first);
            const Point away = apart > 0 ? (1 / apart) * (first - last) : left_normal(ahead);
            first = middle + radius * away;
            last = middle - radius * away;
        }
        points.push_back(cp(first, SPIRO_G2));
        points.push_back(cp(last, SPIRO_G2));
    }
    points.push_back(cp(to.at + held * radius * back, SPIRO_LEFT));
    points.push_back(cp(to.at, SPIRO_END_OPEN_CONTOUR));
    return points;
}

/// A segment of the solver's answer, at scale 1 and with heading 0 in its middle.
struct Spiral {
    const double* k;
    double heading(double s) const { return s * (k[0] + s * (k[1] / 2 + s * (k[2] / 6 + s * k[3] / 24))); }
    /// The way from s0 to s1, by Simpson's rule.
    Point way(double s0, double s1) const {
        constexpr int steps = 8;
        Point sum{};
        for (int i = 0; i <= steps; ++i) {
            const double weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
            sum = sum + ((s1 - s0) * weight / (3 * steps)) * unit(heading(s0 + i * (s1 - s0) / steps));
        }
        return sum;
    }
};

std::optional<Curve> spline(Pose from, Pose to, double radius) {
    std::vector<spiro_cp> points = control_points(from, to, radius);
    const int n = static_cast<int>(points.size());
    const std::unique_ptr<spiro_seg, void (*)(spiro_seg*)> solved(run_spiro(points.data(), n), free_spiro);
    if (!solved) return std::nullopt;
    Curve curve{from, {}};
    Pose at = from;
    for (int i = 0; i + 1 < n; ++i) {
        const spiro_seg& segment = solved.get()[i];
        const Spiral spiral{segment.ks};
        std::vector<Point> ways{{}};
        for (int j = 0; j < pieces; ++j) ways.push_back(ways.back() + spiral.way(share(j), share(j + 1)));
        const Point chord = ways.back();
        const double size = segment.seg_ch / strandline::length(chord);
        const double turn = segment.seg_th - heading(chord);
        if (!std::isfinite(size) || !std::isfinite(turn)) return std::nullopt;
        const Point start{segment.x, segment.y}, ahead = unit(turn);
        for (int j = 1; j <= pieces; ++j) {
            const Point way = size * ways[static_cast<std::size_t>(j)];
            Pose next{start + Point{ahead.x * way.x - ahead.y * way.y, ahead.x * way.y + ahead.y * way.x},
                      turn + spiral.heading(share(j))};
            if (i + 2 == n && j == pieces) next = to;
            if (distance(at.at, next.at) == 0) return std::nullopt;
            curve = joined(std::move(curve), hermite_clothoid(at, next));
            at = next;
        }
    }
    return curve;
}

}  // namespace

std::optional<Curve> spiro(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits) {
    // The spline begins and ends with curvature 0: an end that asks for more is unwound at full sharpness.
    const auto unwound = [&](double k) {
        return Clothoid{std::abs(k) / limits.sharpness, k, std::copysign(limits.sharpness, -k)};
    };
    const Clothoid lead = unwound(from.curvature), tail_back = unwound(-to.curvature);
    const Pose start = advanced(from.pose, lead, lead.length);
    const Pose turned = advanced({to.pose.at, to.pose.heading + pi}, tail_back, tail_back.length);
    auto middle = spline(start, {turned.at, turned.heading - pi}, limits.radius);
    if (!middle) return std::nullopt;
    Curve curve{from.pose, {}};
    if (lead.length > 0) curve.pieces.push_back(lead);
    curve = joined(std::move(curve), *middle);
    if (tail_back.length > 0)
        curve.pieces.push_back({tail_back.length, 0, std::copysign(limits.sharpness, to.curvature)});
    return curve;
}

}  // namespace strandline::connect
