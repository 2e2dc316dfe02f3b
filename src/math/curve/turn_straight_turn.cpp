// Turn, straight, turn: all words of Dubins with a straight as one equation in the first turn's angle.
#include <algorithm>
#include <array>
#include <cmath>

#include "math/curve/families.hpp"

namespace strandline::turns {
namespace {

/// Samples of a full turn: roots nearer than that may hide each other.
constexpr int grid = 16;
/// Halving alone would end after 50.
constexpr int most_steps = 60;

/// A change of sign between two samples of the first angle.
struct Bracket {
    double hope;  ///< about the least length of a curve in there
    double low, high, f_low, f_high, total;
};

/// Regula falsi after Illinois: an end that stays twice counts half.
void refine(const Task& task, Bracket b, double tolerance, double& best, std::vector<Found>& found) {
    int stayed = 0;
    for (int k = 0; k < most_steps; ++k) {
        double at = (b.low * b.f_high - b.high * b.f_low) / (b.f_high - b.f_low);
        if (k % 8 == 7 || !(at > b.low && at < b.high)) at = (b.low + b.high) / 2;
        const Turn::End leave = task.first.end(at), enter = task.entry(b.total - at);
        const Point way = unit(at), link = enter.at - leave.at;
        const double miss = cross(way, link), along = dot(way, link);
        if (std::abs(miss) <= tolerance) {
            const double straight = std::max(0.0, along), whole = leave.length + straight + enter.length;
            if (along < -tolerance) return;  // the straight would run backwards
            found.push_back({Found::turn_straight_turn, whole, at, straight, b.total - at});
            best = std::min(best, whole);
            return;
        }
        if (b.high - b.low < 1e-15) return;  // a jump, not a root
        if ((miss > 0) == (b.f_high > 0)) {
            b.high = at;
            b.f_high = miss;
            if (stayed == -1) b.f_low /= 2;
            stayed = -1;
        } else {
            b.low = at;
            b.f_low = miss;
            if (stayed == 1) b.f_high /= 2;
            stayed = 1;
        }
    }
}

}  // namespace

void add_turn_straight_turn(const Task& task, std::vector<Found>& found) {
    // The first turn by a, the last by b, a + b = heading of the end up to whole turns. The link from where
    // the first ends to where the last begins must look along the heading between them: one equation in a, on
    // a few lines of constant a + b. Both ends are sampled once and combined.
    constexpr double step = 2 * pi / grid;
    const double low_a = task.first.natural - 2 * pi, base_b = task.last_natural() - 2 * pi;
    const double offset = lifted(task.heading - low_a - base_b, 0);
    const double low_b = base_b + offset - step * std::floor(offset / step);
    const int first_line =
        static_cast<int>(std::lround(lifted(task.heading - low_a - low_b, 0) / step)) % grid;
    std::array<Turn::End, 2 * grid + 1> exits, entries;
    std::array<Point, grid> directions;
    for (std::size_t i = 0; i < exits.size(); ++i) {
        const double angle = static_cast<double>(i) * step;
        exits[i] = task.first.end(low_a + angle);
        entries[i] = task.entry(low_b + angle);
        if (i < grid) directions[i] = unit(low_a + angle);
    }
    double best = std::ranges::min(found, {}, &Found::length).length;
    std::vector<Bracket> brackets;
    brackets.reserve(16);
    for (int line = first_line; line <= 4 * grid; line += grid) {
        const double sum = low_a + low_b + line * step;
        // Exact, so that the end's heading is met to rounding.
        const double total = task.heading + 2 * pi * std::round((sum - task.heading) / (2 * pi));
        double f_before = 0, g_before = 0, length_before = 0;
        const int from = std::max(0, line - 2 * grid), to = std::min(2 * grid, line);
        for (int i = from; i <= to; ++i) {
            const Turn::End& exit = exits[static_cast<std::size_t>(i)];
            const Turn::End& entry = entries[static_cast<std::size_t>(line - i)];
            const Point ahead = directions[static_cast<std::size_t>(i % grid)], link = entry.at - exit.at;
            const double f = cross(ahead, link), g = dot(ahead, link), around = exit.length + entry.length;
            if (i > from && (f > 0) != (f_before > 0) && std::max(g, g_before) >= 0) {
                const double hope = std::min(around, length_before) + std::max(0.0, std::min(g, g_before));
                if (hope < best)
                    brackets.push_back({hope, low_a + (i - 1) * step, low_a + i * step, f_before, f, total});
            }
            f_before = f;
            g_before = g;
            length_before = around;
        }
    }
    std::ranges::sort(brackets, {}, &Bracket::hope);
    const double tolerance = root_accuracy * (1 + length(task.to));
    for (const Bracket& bracket : brackets)
        if (bracket.hope < best) refine(task, bracket, tolerance, best, found);
}

}  // namespace strandline::turns
