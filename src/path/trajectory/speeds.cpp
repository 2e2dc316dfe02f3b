#include "path/trajectory/speeds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace strandline::trajectory {
namespace {

// Samples hold rounded curvatures; a hair below the limits keeps what is measured from them within.
constexpr double share_of_limit = 0.98;

/// What bounds u = v^2 on one interval: k is the larger |curvature| of its ends, dk its slope.
struct Interval {
    double length, k, dk, limit;
};

Interval interval(const Course& run, std::size_t i) {
    const double length = run.s[i + 1] - run.s[i];
    return {length, std::max(std::abs(run.curvature[i]), std::abs(run.curvature[i + 1])),
            std::abs(run.curvature[i + 1] - run.curvature[i]) / length, run.limit[i]};
}

/// Largest u that is allowed anywhere on the interval: speed, turn rate, and turn acceleration at constant
/// speed.
double cap(const Interval& at, const Robot& robot) {
    double u = at.limit * at.limit;
    if (at.k > 0) u = std::min(u, std::pow(share_of_limit * robot.turn_rate / at.k, 2));
    if (at.dk > 0) u = std::min(u, share_of_limit * robot.turn_acceleration / at.dk);
    return u;
}

/// Largest u at the far end of an interval that began with `from`: acceleration, and what turning leaves of
/// the turn acceleration when taken at the far end (the faster one): k a <= alpha - dk u.
double reached(double from, const Interval& at, const Robot& robot) {
    double u = from + 2 * share_of_limit * robot.acceleration * at.length;
    if (at.k > 0) {
        const double gain = 2 * at.length / at.k;
        u = std::min(u, (from + gain * share_of_limit * robot.turn_acceleration) / (1 + gain * at.dk));
    }
    return std::max(u, 0.0);
}

}  // namespace

std::vector<double> speeds_along(const Course& run, const Robot& robot) {
    const std::size_t n = run.s.size();
    std::vector<Interval> intervals(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i) intervals[i] = interval(run, i);
    std::vector<double> u(n);
    u[0] = 0;
    for (std::size_t i = 1; i < n; ++i) {
        u[i] = std::min(cap(intervals[i - 1], robot), reached(u[i - 1], intervals[i - 1], robot));
        if (i + 1 < n) u[i] = std::min(u[i], cap(intervals[i], robot));
    }
    u[n - 1] = 0;
    for (std::size_t i = n - 1; i-- > 0;) u[i] = std::min(u[i], reached(u[i + 1], intervals[i], robot));
    for (double& value : u) value = std::sqrt(value);
    return u;
}

}  // namespace strandline::trajectory
