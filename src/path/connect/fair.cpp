// Curves under gentler limits than the robot's own: wider radii to either side and less sharpness, searched
// for the least bending within an allowed length.
#include <algorithm>
#include <array>
#include <cmath>

#include "path/connect/styles.hpp"

namespace strandline::connect {
namespace {

/// What a share less of sharpness is worth in shares of bending: enough to take it where it is nearly free.
constexpr double sharpness_weight = 0.1;
/// The coarse grid, in natural logarithms of what is wider and blunter: up to 50 times the radius, 1/400 of
/// the sharpness.
constexpr double coarse_step = 0.3, widest = 4, bluntest = 6;
/// The steps of the search from its best point.
constexpr double first_step = 0.25, last_step = 0.02;
constexpr int rounds_a_step = 3;

/// Logarithms of: left radius, right radius, sharpness against the robot's.
using Gentler = std::array<double, 3>;

struct Search {
    const CurvatureState &from, &to;
    const CurveLimits& limits;
    double longest, bending_before, sharpness_before;
    Curve best;
    double score = 1 + sharpness_weight;
    Gentler at = {0, 0, 0};

    /// Whether gentler still could be worth a try: the curve was not far too long.
    bool consider(const Gentler& gentler) {
        // An end's curvature must stay within the limits.
        const double left = std::max({from.curvature, to.curvature, 0.0}),
                     right = std::max({-from.curvature, -to.curvature, 0.0});
        const auto radius = [](double least, double wider, double end) {
            const double r = least * std::exp(wider);
            return end > 0 ? std::max(least, std::min(r, 1 / end)) : r;
        };
        const double right_radius = limits.right_radius > 0 ? limits.right_radius : limits.radius;
        if (gentler[0] < 0 || gentler[1] < 0 || gentler[2] > 0) return false;
        Curve curve = continuous_curvature(from, to,
                                           {.radius = radius(limits.radius, gentler[0], left),
                                            .sharpness = limits.sharpness * std::exp(gentler[2]),
                                            .right_radius = radius(right_radius, gentler[1], right)});
        const double l = length(curve);
        if (l > longest) return l < 1.5 * longest;
        const double value =
            bending(curve) / bending_before + sharpness_weight * max_sharpness(curve) / sharpness_before;
        if (value >= score) return true;
        score = value;
        at = gentler;
        best = std::move(curve);
        return true;
    }
};

}  // namespace

double bending(const Curve& curve) {
    double sum = 0;
    for (const Clothoid& piece : curve.pieces) {
        const double a = piece.curvature, b = piece.end_curvature();
        sum += std::abs(piece.length) * (a * a + a * b + b * b) / 3;
    }
    return sum;
}

Curve fair(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits, Curve bounded,
           double extra) {
    const double before = bending(bounded), sharp = max_sharpness(bounded);
    if (extra <= 0 || before <= 0 || sharp <= 0) return bounded;
    Search search{from, to, limits, length(bounded) * (1 + extra), before, sharp, std::move(bounded)};
    for (double wider = 0; wider <= widest; wider += coarse_step)
        for (double blunter = 0; blunter <= bluntest; blunter += coarse_step)
            if (!search.consider({wider, wider, -blunter})) break;
    // One limit at a time, both radii together, radii against sharpness.
    constexpr Gentler directions[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, -1}};
    for (double step = first_step; step > last_step; step /= 2)
        for (int round = 0; round < rounds_a_step; ++round) {
            const double score = search.score;
            for (const Gentler& d : directions)
                for (const double s : {step, -step}) {
                    const Gentler at = search.at;
                    search.consider({at[0] + s * d[0], at[1] + s * d[1], at[2] + s * d[2]});
                }
            if (search.score >= score) break;
        }
    return std::move(search.best);
}

}  // namespace strandline::connect
