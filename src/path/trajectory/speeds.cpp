#include "path/trajectory/speeds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace strandline::trajectory {
namespace {

// Samples hold rounded curvatures; a hair below the limits keeps what is measured from them within.
constexpr double share_of_limit = 0.98;

}  // namespace

Interval interval_of(double length, double curvature, double next_curvature, double limit) {
    return {length, std::max(std::abs(curvature), std::abs(next_curvature)),
            std::abs(next_curvature - curvature) / length, limit};
}

double cap(const Interval& at, const Robot& robot) {
    double u = at.limit * at.limit;
    if (at.k > 0) u = std::min(u, std::pow(share_of_limit * robot.turn_rate / at.k, 2));
    if (at.dk > 0) u = std::min(u, share_of_limit * robot.turn_acceleration / at.dk);
    return u;
}

double reached(double from, const Interval& at, const Robot& robot) {
    double u = from + 2 * share_of_limit * robot.acceleration * at.length;
    if (at.k > 0) {
        const double gain = 2 * at.length / at.k;
        u = std::min(u, (from + gain * share_of_limit * robot.turn_acceleration) / (1 + gain * at.dk));
    }
    return std::max(u, 0.0);
}

std::vector<double> speeds_along(const Course& run, const Robot& robot) {
    const std::size_t n = run.s.size();
    std::vector<Interval> intervals(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i)
        intervals[i] =
            interval_of(run.s[i + 1] - run.s[i], run.curvature[i], run.curvature[i + 1], run.limit[i]);
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
