// Three turns, the middle one to the other side. The circles of full turns give first angles; Newton goes on
// from there and finds turns that stop short of the limit too.
#include <algorithm>
#include <cmath>

#include "math/curve/families.hpp"

namespace strandline::turns {
namespace {

/// Seeds this much longer than what is known are not worth the steps: Newton seldom shortens them that much.
constexpr double hopeless = 1.25;
constexpr int most_steps = 8;
/// Step of the difference quotients (radians): half the digits.
constexpr double nudge = 1e-7;
/// Largest step of Newton (radians): farther the turns look different.
constexpr double most_step = 1;

}  // namespace

void add_three_turns(const Task& task, double side, std::vector<Found>& found) {
    const Spiral& spiral = task.spiral;
    // Saturated turns first: circles whose centres form a triangle with two known sides.
    const Pose up = spiral.rise(side * task.begin), down = spiral.rise(side * task.end);
    const double heading_to = side * task.heading, leave = heading_to - down.heading;
    const Point to{task.to.x, side * task.to.y};
    const Point first = up.at + left_normal(unit(up.heading));
    const Point last =
        to - rotated({task.ahead.x, side * task.ahead.y}, {down.at.x, -down.at.y}) + left_normal(unit(leave));
    // From the left centre to the right one, seen along the heading at the change of sides.
    const double h = spiral.full_heading;
    const Point half{spiral.full.x - std::sin(h), -spiral.full.y - std::cos(h)};
    const double reach = 2 * length(half), apart = distance(first, last);
    if (apart > 2 * reach) return;
    const double line = apart > 1e-12 ? heading(last - first) : 0;
    const double bend = std::acos(apart / (2 * reach)), tilt = heading(half);
    const Turn middle(spiral, 0);
    const double tolerance = root_accuracy * (1 + length(task.to));
    const double best = std::ranges::min(found, {}, &Found::length).length;
    for (double sign : {1.0, -1.0}) {
        const double h1 = line + sign * bend - tilt, h2 = line - sign * bend + tilt;
        double a = side * lifted(h1, side * task.first.natural), m = -side * lifted(h1 - h2, 0);
        double b = side * lifted(heading_to - h2, side * task.last_natural());
        const double total = task.heading + 2 * pi * std::round((a + m + b - task.heading) / (2 * pi));
        const auto miss = [&](double first_angle, double middle_angle) {
            const Point turned = rotated(unit(first_angle), middle.end(middle_angle).at);
            return task.first.end(first_angle).at + turned -
                   task.entry(total - first_angle - middle_angle).at;
        };
        const auto whole = [&] {
            return task.first.end(a).length + middle.end(m).length + task.last.end(a + m - total).length;
        };
        if (whole() > hopeless * best) continue;
        Point f = miss(a, m);
        for (int k = 0; k < most_steps && length(f) > tolerance; ++k) {
            const Point fa = (1 / nudge) * (miss(a + nudge, m) - f),
                        fm = (1 / nudge) * (miss(a, m + nudge) - f);
            const double det = cross(fa, fm);
            if (det == 0) break;
            const double da = -cross(f, fm) / det, dm = -cross(fa, f) / det;
            const double share = std::min(1.0, most_step / std::max(std::abs(da), std::abs(dm)));
            a += share * da, m += share * dm;
            f = miss(a, m);
        }
        if (length(f) <= tolerance) found.push_back({Found::three_turns, whole(), a, m, total - a - m, side});
    }
}

}  // namespace strandline::turns
