// Entries anywhere on the edges of closed elements, for an order that is fixed.
#include <algorithm>
#include <cmath>

#include "path/tour/model.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Rounds end where one gains less than this share of the length, and after so many.
constexpr double least_gain = 1e-9;
constexpr int most_rounds = 100;

/// What comes before and after; absent: the drive begins or ends here.
struct Beside {
    const Point* before;
    const Point* after;
    double legs(Point p) const {
        return (before ? distance(*before, p) : 0) + (after ? distance(p, *after) : 0);
    }
};

/// The point of the edge where the legs are shortest. The sum is convex along the edge: a way that would meet
/// its line beyond an end is shortest at that end.
Point shortest_on(Point a, Point b, const Beside& beside) {
    const Point edge = b - a;
    const double l = length(edge);
    if (l == 0 || (!beside.before && !beside.after)) return a;
    const Point along = (1 / l) * edge;
    const auto place = [&](Point p) { return std::pair{dot(p - a, along), std::abs(cross(along, p - a))}; };
    double s = 0;
    if (beside.before && beside.after) {
        // what lies beyond the edge is mirrored by it: either way the line is met between the two feet
        const auto [s1, d1] = place(*beside.before);
        const auto [s2, d2] = place(*beside.after);
        s = d1 + d2 > 0 ? (s1 * d2 + s2 * d1) / (d1 + d2)
                        : std::clamp(0.0, std::min(s1, s2), std::max(s1, s2));
    } else {
        s = place(beside.before ? *beside.before : *beside.after).first;
    }
    return a + std::clamp(s, 0.0, l) * along;
}

/// Elements whose entry is not free.
std::vector<char> held(const Problem& problem) {
    std::vector<char> held(problem.elements.size(), 0);
    for (std::size_t e = 0; e < held.size(); ++e) {
        const Element& element = problem.elements[e];
        held[e] = !element.closed || element.entry || element.points.size() < 2 ? 1 : 0;
    }
    for (const Link& link : problem.links) held[at(link.element_a)] = held[at(link.element_b)] = 1;
    return held;
}

}  // namespace

Entries entered_on_edges(const Problem& problem, const std::vector<Step>& steps) {
    const std::vector<char> held = tour::held(problem);
    const std::size_t n = steps.size();
    std::vector<Point> in, out;  // where each is entered and left
    for (const Step& step : steps) {
        in.push_back(entry_of(problem, step));
        out.push_back(exit_of(problem, step));
    }
    const auto beside = [&](std::size_t k) {
        const bool ring = problem.end == End::at_start;
        Beside b{k > 0           ? &out[k - 1]
                 : problem.start ? &*problem.start
                                 : nullptr,
                 k + 1 < n ? &in[k + 1] : nullptr};
        if (k == 0 && !b.before && ring && n > 1) b.before = &out[n - 1];
        if (k + 1 == n && problem.end == End::at_point) b.after = &problem.end_point;
        if (k + 1 == n && ring) b.after = problem.start ? &*problem.start : n > 1 ? &in[0] : nullptr;
        return b;
    };
    const auto whole = [&] {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const Beside b = beside(k);
            if (b.before && (k > 0 || problem.start)) sum += distance(*b.before, in[k]);
            if (k + 1 == n && b.after) sum += distance(out[k], *b.after);
        }
        return sum;
    };
    double length = whole();
    for (int round = 0; round < most_rounds; ++round) {
        for (std::size_t k = 0; k < n; ++k) {
            if (held[at(steps[k].element)] != 0) continue;
            const std::vector<Point>& ring = problem.elements[at(steps[k].element)].points;
            const Beside b = beside(k);
            double least = b.legs(in[k]);
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                const Point p = shortest_on(ring[j], ring[i], b);
                if (const double legs = b.legs(p); legs < least) {
                    least = legs;
                    in[k] = out[k] = p;
                }
            }
        }
        const double now = whole();
        const bool gained = now < length * (1 - least_gain);
        length = std::min(length, now);
        if (!gained) break;
    }
    return {std::move(in), length};
}

}  // namespace strandline::tour
