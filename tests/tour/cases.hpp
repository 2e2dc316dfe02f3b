#pragma once
// Random problems, and the answer by trying everything.
#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "path/tour/tour.hpp"

namespace strandline::tour {

struct Dice {
    std::mt19937_64 engine;
    int below(int n) { return static_cast<int>((engine() >> 33) % static_cast<std::uint64_t>(n)); }
    double share() { return static_cast<double>(engine() >> 11) / 9007199254740992.0; }
    Point point() { return {10 * share(), 10 * share()}; }
    bool chance(int percent) { return below(100) < percent; }
};

inline Problem random_problem(Dice& dice, int elements) {
    Problem problem;
    for (int i = 0; i < elements; ++i) {
        Element element;
        element.closed = dice.chance(45);
        const int points = element.closed ? 3 + dice.below(3) : 2 + dice.below(2);
        const Point base = dice.point();
        for (int k = 0; k < points; ++k) element.points.push_back(base + 0.3 * dice.point());
        problem.elements.push_back(element);
    }
    if (dice.chance(60)) problem.start = dice.point();
    const int end = dice.below(3);
    problem.end = end == 0 ? End::free : end == 1 ? End::at_point : End::at_start;
    problem.end_point = dice.point();
    return problem;
}

/// Rules of every kind, rarely so many that nothing is left.
inline void add_rules(Dice& dice, Problem& problem) {
    const int n = static_cast<int>(problem.elements.size());
    const auto some = [&] { return dice.below(n); };
    for (Element& element : problem.elements) {
        const int last = static_cast<int>(element.points.size()) - 1;
        if (dice.chance(15))
            element.entry = element.closed ? dice.below(last + 1) : dice.chance(50) ? 0 : last;
        if (dice.chance(15)) element.direction = dice.chance(50) ? Direction::forward : Direction::backward;
        if (dice.chance(15)) element.sense = dice.chance(50) ? Sense::ccw : Sense::cw;
    }
    const auto vertex = [&](int e) {
        const int size = static_cast<int>(problem.elements[static_cast<std::size_t>(e)].points.size());
        return problem.elements[static_cast<std::size_t>(e)].closed ? dice.below(size)
               : dice.chance(50)                                    ? 0
                                                                    : size - 1;
    };
    for (int k = dice.below(3); k > 0; --k) {
        const int i = some(), j = some();
        problem.links.push_back({i, vertex(i), j, vertex(j)});
    }
    for (int k = dice.below(3); k > 0; --k) problem.before.emplace_back(some(), some());
    if (dice.chance(50)) {
        std::vector<int> all(static_cast<std::size_t>(n));
        std::iota(all.begin(), all.end(), 0);
        for (int k = n - 1; k > 0; --k)
            std::swap(all[static_cast<std::size_t>(k)], all[static_cast<std::size_t>(dice.below(k + 1))]);
        const int first = 1 + dice.below(n), second = dice.below(n - first + 1);
        problem.groups.emplace_back(all.begin(), all.begin() + first);
        if (second > 0) problem.groups.emplace_back(all.begin() + first, all.begin() + first + second);
        problem.keep_group_order = dice.chance(50);
    }
}

/// The least length over all orders and entries that recount() accepts; infinite when there is none.
/// Independent of the search: only recount() is shared.
inline double least_by_trying(const Problem& problem) {
    const int n = static_cast<int>(problem.elements.size());
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    double best = std::numeric_limits<double>::infinity();
    std::vector<Step> steps(order.size());
    const auto enter = [&](auto&& self, std::size_t k) -> void {
        if (k == order.size()) {
            if (const auto length = recount(problem, steps)) best = std::min(best, *length);
            return;
        }
        const Element& element = problem.elements[static_cast<std::size_t>(order[k])];
        const int last = static_cast<int>(element.points.size()) - 1;
        for (int v = 0; v <= last; ++v) {
            if (!element.closed && v != 0 && v != last) continue;
            const bool reversed = element.closed
                                      ? element.sense != Sense::any &&
                                            (signed_area(element.points) > 0) != (element.sense == Sense::ccw)
                                      : v == last;
            steps[k] = {order[k], v, reversed};
            self(self, k + 1);
        }
    };
    do enter(enter, 0);
    while (std::next_permutation(order.begin(), order.end()));
    return best;
}

}  // namespace strandline::tour
