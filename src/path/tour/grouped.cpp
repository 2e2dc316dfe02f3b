#include "path/tour/grouped.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

#include "path/tour/model.hpp"
#include "path/tour/order.hpp"
#include "path/tour/search.hpp"

namespace strandline::tour {
namespace {

constexpr int most_rounds = 12;
constexpr std::uint64_t moves_an_element = 10, moves_a_group = 100;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A group as it is run.
struct Run {
    int group;
    std::vector<Step> steps;
};

class Groups {
  public:
    Groups(const Problem& problem, const std::vector<Step>& steps, std::uint64_t seed,
           const Progress& progress)
        : problem_(problem), seed_(seed), progress_(progress), group_of_(problem.elements.size()) {
        for (std::size_t g = 0; g < problem.groups.size(); ++g)
            for (const int e : problem.groups[g]) group_of_[at(e)] = static_cast<int>(g);
        for (const Step& step : steps) {
            const int group = group_of_[at(step.element)];
            if (runs_.empty() || runs_.back().group != group) runs_.push_back({group, {}});
            runs_.back().steps.push_back(step);
        }
        // What may not be run the other way round.
        one_way_.assign(problem.groups.size(), false);
        for (std::size_t e = 0; e < problem.elements.size(); ++e)
            if (!problem.elements[e].closed &&
                (problem.elements[e].direction != Direction::any || problem.elements[e].entry))
                one_way_[at(group_of_[e])] = true;
        for (const auto& [i, j] : problem.before) {
            if (group_of_[at(i)] == group_of_[at(j)])
                one_way_[at(group_of_[at(i)])] = true;
            else
                before_.insert({group_of_[at(i)], group_of_[at(j)]});
        }
    }

    std::vector<Step> run() {
        double length = length_of(problem_, steps());
        for (int round = 0; round < most_rounds && !progress_.stopped(); ++round) {
            if (!problem_.keep_group_order) order_groups();
            for (std::size_t k = 0; k < runs_.size() && !progress_.stopped(); ++k) order_inside(k);
            const double now = length_of(problem_, steps());
            progress_.report("groups", static_cast<double>(round + 1) / most_rounds);
            if (now > length - least_gain * length) break;
            length = now;
        }
        return steps();
    }

  private:
    static constexpr double least_gain = 1e-9;

    std::vector<Step> steps() const {
        std::vector<Step> all;
        for (const Run& run : runs_) all.insert(all.end(), run.steps.begin(), run.steps.end());
        return all;
    }
    /// The search's answer, if it is shorter than what there is.
    std::vector<Step> shorter(const Problem& part, const std::vector<Step>& now, std::uint64_t moves) const {
        const auto model = build_model(part);
        if (!model) return now;
        const auto first = first_order(*model);
        if (!first) return now;
        const Searched found = improve(*model, *first, seed_, moves, quiet_);
        std::vector<Step> answer = steps_of(*model, found.order);
        return length_of(part, answer) < length_of(part, now) ? answer : now;
    }

    void order_groups() {
        Problem whole;
        whole.start = problem_.start;
        whole.end = problem_.end;
        whole.end_point = problem_.end_point;
        std::vector<Step> now;
        std::vector<int> number(problem_.groups.size());
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            const Run& run = runs_[k];
            Element element;
            element.points = {entry_of(problem_, run.steps.front()), exit_of(problem_, run.steps.back())};
            if (one_way_[at(run.group)]) element.direction = Direction::forward;
            whole.elements.push_back(element);
            now.push_back({static_cast<int>(k), 0, false});
            number[at(run.group)] = static_cast<int>(k);
        }
        for (const auto& [a, b] : before_) whole.before.emplace_back(number[at(a)], number[at(b)]);
        std::vector<Run> runs;
        for (const Step& step : shorter(whole, now, moves_a_group * runs_.size())) {
            runs.push_back(runs_[at(step.element)]);
            if (step.reversed) turn_about(runs.back());
        }
        runs_ = std::move(runs);
    }
    void turn_about(Run& run) const {
        std::ranges::reverse(run.steps);
        for (Step& step : run.steps) {
            const Element& element = problem_.elements[at(step.element)];
            if (element.closed) continue;
            step.reversed = !step.reversed;
            step.entry = static_cast<int>(element.points.size()) - 1 - step.entry;
        }
    }

    void order_inside(std::size_t k) {
        Run& run = runs_[k];
        Problem part;
        if (k > 0)
            part.start = exit_of(problem_, runs_[k - 1].steps.back());
        else
            part.start = problem_.start;
        part.end = End::at_point;
        if (k + 1 < runs_.size())
            part.end_point = entry_of(problem_, runs_[k + 1].steps.front());
        else if (problem_.end == End::at_point)
            part.end_point = problem_.end_point;
        else if (problem_.end == End::at_start && (problem_.start || runs_.size() > 1))
            part.end_point =
                problem_.start ? *problem_.start : entry_of(problem_, runs_.front().steps.front());
        else
            part.end = problem_.end;
        std::vector<int> number(problem_.elements.size(), -1);
        std::vector<Step> now;
        for (const Step& step : run.steps) {
            number[at(step.element)] = static_cast<int>(part.elements.size());
            now.push_back(step);
            now.back().element = static_cast<int>(part.elements.size());
            part.elements.push_back(problem_.elements[at(step.element)]);
        }
        for (const Link& link : problem_.links)
            if (number[at(link.element_a)] >= 0)
                part.links.push_back(
                    {number[at(link.element_a)], link.vertex_a, number[at(link.element_b)], link.vertex_b});
        for (const auto& [i, j] : problem_.before)
            if (number[at(i)] >= 0 && number[at(j)] >= 0)
                part.before.emplace_back(number[at(i)], number[at(j)]);
        const std::vector<Step> old = run.steps;
        run.steps = shorter(part, now, moves_an_element * now.size());
        for (Step& step : run.steps) step.element = old[at(step.element)].element;
    }

    const Problem& problem_;
    std::uint64_t seed_;
    const Progress& progress_;
    const Progress quiet_ = {};
    std::vector<int> group_of_;  ///< by element
    std::vector<bool> one_way_;  ///< by group
    std::set<std::pair<int, int>> before_;
    std::vector<Run> runs_;
};

}  // namespace

std::vector<Step> improve_groups(const Problem& problem, std::vector<Step> steps, std::uint64_t seed,
                                 const Progress& progress) {
    if (steps.empty()) return steps;
    return Groups(problem, steps, seed, progress).run();
}

}  // namespace strandline::tour
