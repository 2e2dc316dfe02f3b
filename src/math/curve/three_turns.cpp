// Three turns, the middle one to the other side or short. Circles give first angles; Newton goes on from
// there to turns that stop short of the limit.
#include <algorithm>
#include <cmath>
#include <optional>

#include "math/curve/families.hpp"

namespace strandline::turns {
namespace {

/// Seeds this much longer than what is known are not worth the steps: Newton seldom shortens them that much.
constexpr double hopeless = 1.15;
/// What is this near to Dubins' lower bound is short enough.
constexpr double good_enough = 1.06;
constexpr int most_steps = 8;
/// Step of the difference quotients (radians): half the digits.
constexpr double nudge = 1e-7;
/// Largest step of Newton (radians): farther the turns look different.
constexpr double most_step = 1;
/// A gentle turn looks like a circle of about this radius (of 1.2, 1.5, 2: this leaves the shortest curves).
constexpr double gentle_radius = 1.5;

struct Solver {
    const Task& task;
    Turn middle;
    /// Of what was found before; it stays, so that mirrored tasks are pruned alike.
    double best;
    double tolerance;
    std::vector<Found>& found;

    /// The gap between the middle turn and the last for the first two angles, a + m + b = total.
    Point miss(double a, double m, double total) const {
        return task.first.end(a).at + rotated(unit(a), middle.end(m).at) - task.entry(total - a - m).at;
    }
    double whole(double a, double m, double total) const {
        return task.first.end(a).length + middle.end(m).length + task.last.end(a + m - total).length;
    }

    void from(double a, double m, double b) {
        const double total = task.heading + 2 * pi * std::round((a + m + b - task.heading) / (2 * pi));
        if (whole(a, m, total) > hopeless * best) return;
        Point f = miss(a, m, total);
        for (int k = 0; k < most_steps && length(f) > tolerance; ++k) {
            const Point fa = (1 / nudge) * (miss(a + nudge, m, total) - f);
            const Point fm = (1 / nudge) * (miss(a, m + nudge, total) - f);
            const double det = cross(fa, fm);
            if (det == 0) return;
            const double da = -cross(f, fm) / det, dm = -cross(fa, f) / det;
            const double share = std::min(1.0, most_step / std::max(std::abs(da), std::abs(dm)));
            a += share * da;
            m += share * dm;
            f = miss(a, m, total);
        }
        if (!(length(f) <= tolerance)) return;
        found.push_back({Found::three_turns, whole(a, m, total), a, m, total - a - m});
    }
};

/// Two circles and the third between them; seen so that the first turn is to the left.
struct Triangle {
    double line, bend;  ///< heading from first to last centre; angle between that and the middle centre
};
std::optional<Triangle> triangle(Point first, Point last, double reach) {
    const double apart = distance(first, last);
    if (apart > 2 * reach) return std::nullopt;
    return Triangle{apart > 1e-12 ? heading(last - first) : 0, std::acos(apart / (2 * reach))};
}

/// Full turns with the given end curvatures.
void try_full_turns(Solver& solver, double side) {
    const Task& task = solver.task;
    const Spiral& spiral = task.spiral;
    const Pose up = spiral.rise(side * task.begin), down = spiral.rise(side * task.end);
    const double heading_to = side * task.heading, leave = heading_to - down.heading;
    const Point to{task.to.x, side * task.to.y}, ahead{task.ahead.x, side * task.ahead.y};
    const Point first = up.at + left_normal(unit(up.heading));
    const Point last = to - rotated(ahead, {down.at.x, -down.at.y}) + left_normal(unit(leave));
    // From the left centre to the right one, seen along the heading at the change of sides.
    const double h = spiral.full_heading;
    const Point half{spiral.full.x - std::sin(h), -spiral.full.y - std::cos(h)};
    const auto circles = triangle(first, last, 2 * length(half));
    if (!circles) return;
    const double tilt = heading(half);
    for (double bend : {circles->bend, -circles->bend}) {
        const double h1 = circles->line + bend - tilt, h2 = circles->line - bend + tilt;
        solver.from(side * lifted(h1, side * task.first.natural), -side * lifted(h1 - h2, 0),
                    side * lifted(heading_to - h2, side * task.last_natural()));
    }
}

/// Circles as Dubins would take, a little wider; turns the short way round as well.
void try_gentle_turns(Solver& solver, double side) {
    const Task& task = solver.task;
    const double heading_to = side * task.heading;
    const Point to{task.to.x, side * task.to.y}, ahead{task.ahead.x, side * task.ahead.y};
    const Point first{0, gentle_radius}, last = to + gentle_radius * left_normal(ahead);
    const auto circles = triangle(first, last, 2 * gentle_radius);
    if (!circles) return;
    for (double bend : {circles->bend, -circles->bend}) {
        const double leave = circles->line + bend + pi / 2, m = -(pi + 2 * bend);
        const double a = lifted(leave, 0), b = lifted(heading_to - leave - m, 0);
        const double other_a = a > pi ? a - 2 * pi : a, other_b = b > pi ? b - 2 * pi : b;
        solver.from(side * other_a, side * m, side * other_b);
        if (other_a != a) solver.from(side * a, side * m, side * other_b);
        if (other_b != b) solver.from(side * other_a, side * m, side * b);
        if (other_a != a && other_b != b) solver.from(side * a, side * m, side * b);
    }
}

}  // namespace

void add_three_turns(const Task& task, std::vector<Found>& found) {
    const double best = std::ranges::min(found, {}, &Found::length).length;
    if (best < good_enough * dubins_length({}, {task.to, task.heading}, 1)) return;
    Solver solver{task, Turn(task.spiral, 0), best, root_accuracy * (1 + length(task.to)), found};
    for (double side : {1.0, -1.0}) {
        try_gentle_turns(solver, side);
        try_full_turns(solver, side);
    }
}

}  // namespace strandline::turns
