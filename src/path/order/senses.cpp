#include "path/order/senses.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

namespace strandline::order {

std::vector<Going> with_driven_senses(const Job& job, const std::vector<tour::Step>& steps,
                                      const Choices& choices, const Robot& robot) {
    if (steps.empty()) return {};
    const auto cost = [&](Pose from, Pose to) {
        return robot.min_radius > 0 ? dubins_length(from, to, robot.min_radius) : distance(from.at, to.at);
    };
    std::vector<std::span<const Candidate>> ways;
    for (const tour::Step& step : steps) ways.emplace_back(choices[static_cast<std::size_t>(step.element)]);
    std::vector<std::vector<std::size_t>> came_from(ways.size());
    std::vector<double> best;
    for (const Candidate& way : ways[0])
        best.push_back(way.longer + (job.start ? distance(*job.start, way.start.at) : 0));
    for (std::size_t k = 1; k < ways.size(); ++k) {
        std::vector<double> next(ways[k].size(), std::numeric_limits<double>::infinity());
        came_from[k].assign(ways[k].size(), 0);
        for (std::size_t j = 0; j < ways[k].size(); ++j)
            for (std::size_t i = 0; i < ways[k - 1].size(); ++i) {
                // A straight gap bounds the Dubins length from below: most pairs need not be solved.
                const double so_far = best[i] + ways[k][j].longer;
                if (so_far + distance(ways[k - 1][i].end.at, ways[k][j].start.at) >= next[j]) continue;
                const double sum = so_far + cost(ways[k - 1][i].end, ways[k][j].start);
                if (sum < next[j]) {
                    next[j] = sum;
                    came_from[k][j] = i;
                }
            }
        best = std::move(next);
    }
    if (job.end)
        for (std::size_t i = 0; i < best.size(); ++i) best[i] += distance(ways.back()[i].end.at, *job.end);
    std::size_t at = static_cast<std::size_t>(std::ranges::min_element(best) - best.begin());
    std::vector<Going> chosen(steps.size());
    for (std::size_t k = ways.size(); k-- > 0;) {
        chosen[k] = ways[k][at].going;
        if (k > 0) at = came_from[k][at];
    }
    return chosen;
}

}  // namespace strandline::order
