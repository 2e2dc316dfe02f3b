// Where the searches for three peaks begin.
#include <algorithm>
#include <cmath>
#include <optional>

#include "math/curve/three_peaks.hpp"

namespace strandline::turns {
namespace {

/// What is this near to Dubins' lower bound is short enough for the quick search.
constexpr double good_enough = 1.06;
/// A turn of some radians looks like a circle wider than the limit's by about this over the sharpness (1.5
/// radii at 2.5: of 1.2, 1.5, 2 this leaves the shortest curves), and no wider than the second number.
constexpr double widening = 1.25, widest = 3;
/// The thorough search: seeds from the end's curvature up to the limit, and radians between seeds that stay
/// there. Twice as many find the same curves.
constexpr int ramp_seeds = 8;
constexpr double stay_step = 0.4;

/// Two circles and the third between them; seen so that the first turn is to the left.
struct Triangle {
    double line, bend;  ///< heading from first to last centre; angle between that and the middle centre
};
std::optional<Triangle> triangle(Point first, Point last, double reach) {
    const double apart = distance(first, last);
    if (apart > 2 * reach) return std::nullopt;
    return Triangle{apart > 1e-12 ? heading(last - first) : 0, std::acos(apart / (2 * reach))};
}

/// Newton from turns by a to the left, m to the right, b to the left, each from curvature 0 to 0.
void from_turns(ThreePeaks& search, double a, double m, double b, std::vector<Found>& found) {
    const Peak first = search.turning(a - search.g0(), 1), valley = search.turning(m, -1);
    search.newton(first, valley, search.turning(b, 1), found);
}

/// Circles as Dubins would take, a little wider.
void try_circles(const Task& task, ThreePeaks& search, double radius, std::vector<Found>& found) {
    const double side = search.side(), heading_to = side * task.heading;
    const Point to{task.to.x, side * task.to.y}, ahead{task.ahead.x, side * task.ahead.y};
    const auto circles = triangle({0, radius}, to + radius * left_normal(ahead), 2 * radius);
    if (!circles) return;
    for (const double bend : {circles->bend, -circles->bend}) {
        const double leave = lifted(circles->line + bend + pi / 2, 0), middle = pi + 2 * bend;
        from_turns(search, leave, middle, lifted(heading_to - leave + middle, 0), found);
    }
}

std::vector<Peak> peaks_from(const ThreePeaks& search, double begin) {
    std::vector<Peak> list;
    const double limit = search.limit();
    for (int i = 0; i <= ramp_seeds; ++i)
        list.push_back(search.peak(begin + (limit - begin) * i / ramp_seeds));
    const double at_limit = list.back().turn, most = std::min(search.best() * limit, 2 * pi);
    for (double stay = stay_step; stay < most; stay += stay_step)
        list.push_back(search.turning(at_limit + stay, 1));
    return list;
}

}  // namespace

void add_three_peaks(const Task& task, std::vector<Found>& found) {
    const double best = std::ranges::min(found, {}, &Found::length).length;
    if (best < good_enough * dubins_length({}, {task.to, task.heading}, 1)) return;
    for (const double side : {1.0, -1.0}) {
        ThreePeaks search(task, side, best);
        try_circles(task, search, std::min(1 + widening / task.spiral.sharpness, widest), found);
    }
}

void add_all_three_peaks(const Task& task, std::vector<Found>& found) {
    for (const double side : {1.0, -1.0}) {
        ThreePeaks search(task, side, std::ranges::min(found, {}, &Found::length).length);
        const std::vector<Peak> firsts = peaks_from(search, search.begin()),
                                seconds = peaks_from(search, search.end());
        // A root lies within a cell of its seed, and is shorter by two cells' change of length at most.
        const double cell = 2 * stay_step;
        for (const Peak& first : firsts) {
            for (const Peak& second : seconds) {
                const double high = std::min(first.p, second.p);
                if (search.length_of(first.q, high, second.q) > search.best() + cell) break;
                // the valley turns by what is over, up to whole turns
                for (double over = lifted(search.g0() + first.turn + second.turn - search.g3(), 0);;
                     over += 2 * pi) {
                    const Peak valley = search.turning(over, -1);
                    if (search.length_of(first.q, valley.q, second.q) > search.best() + cell) break;
                    search.newton(first, valley, second, found);
                }
                const Peak dip =
                    search.turning(lifted(search.g0() + first.turn + second.turn - search.g3(), 0), 1);
                if (dip.p <= high && !dip.stays) search.newton(first, dip, second, found);
            }
        }
    }
}

}  // namespace strandline::turns
