// A row that was searched before, put right for a job that differs a little.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "path/order/draft.hpp"
#include "path/order/memory.hpp"
#include "path/order/parted.hpp"
#include "path/order/problem.hpp"

namespace strandline::order {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Mender {
  public:
    Mender(const Job& job, const Robot& robot)
        : job_(job), robot_(robot), problem_(problem_of(job)), there_(job.groups.size(), 0) {}

    /// By place in the row; none: it cannot be put right.
    std::optional<std::vector<Going>> mend(const std::vector<Memory::Kept::Place>& last) {
        std::map<std::pair<std::string, int>, int> groups;
        const std::vector<int> numbers = numbers_of(job_);
        for (std::size_t g = 0; g < job_.groups.size(); ++g)
            groups[{job_.groups[g].name, numbers[g]}] = static_cast<int>(g);
        for (const Memory::Kept::Place& place : last) {
            const auto found = groups.find({place.name, place.number});
            if (found == groups.end()) continue;
            Going going = place.going;
            going.step.element = found->second;
            row_.push_back(going);
            there_[at(found->second)] = 1;
        }
        if (row_.empty()) return std::nullopt;
        for (std::size_t k = 0; k < row_.size(); ++k)
            if (!allowed(row_[k])) row_[k] = best_way(row_[k].step.element, k, true);
        for (std::size_t g = 0; g < job_.groups.size(); ++g)
            if (there_[g] == 0) insert(static_cast<int>(g));
        if (!sort_out()) return std::nullopt;
        for (const Tie& tie : job_.ties) tie_up(tie);
        if (!tour::recount(problem_, steps())) return std::nullopt;
        return row_;
    }

  private:
    bool closed(int group) const { return problem_.elements[at(group)].closed; }
    /// As the tour counts: an open group's two ends.
    tour::Step step_of(const Going& going) const {
        tour::Step step = going.step;
        if (!closed(step.element)) step.entry = step.reversed ? 1 : 0;
        return step;
    }
    std::vector<tour::Step> steps() const {
        std::vector<tour::Step> steps;
        for (const Going& going : row_) steps.push_back(step_of(going));
        return steps;
    }
    bool allowed(const Going& going) const {
        const int group = going.step.element;
        if (going.variant >= static_cast<int>(job_.groups[at(group)].variants.size())) return false;
        tour::Step step = step_of(going);
        step.element = 0;
        tour::Problem alone;
        alone.elements = {problem_.elements[at(group)]};
        return tour::recount(alone, {step}).has_value();
    }
    /// Ways through a group by itself that its own wishes allow.
    std::vector<Going> ways(int group) const {
        const std::vector<Stroke>& strokes = job_.groups[at(group)].work.strokes;
        const int nodes = static_cast<int>(strokes.front().nodes.size());
        std::vector<Going> all;
        for (int entry = 0; entry < (closed(group) ? nodes : 1); ++entry)
            for (const bool reversed : {false, true}) {
                const int node = closed(group) ? entry : reversed ? nodes - 1 : 0;
                if (const Going going{{group, node, reversed}}; allowed(going)) all.push_back(going);
            }
        return all;
    }
    /// What lies between the place before k and the next one if the group is gone through like that.
    double gaps(const Going& going, std::size_t k, bool replaces) const {
        const Candidate here = candidate(job_.groups[at(going.step.element)], going, robot_);
        const auto gap = [&](Pose from, Pose to) {
            return robot_.min_radius > 0 ? dubins_length(from, to, robot_.min_radius)
                                         : distance(from.at, to.at);
        };
        const auto other = [&](std::size_t place) {
            return candidate(job_.groups[at(row_[place].step.element)], row_[place], robot_);
        };
        const std::size_t next = replaces ? k + 1 : k;
        return (k > 0 ? gap(other(k - 1).end, here.start) : 0) +
               (next < row_.size() ? gap(here.end, other(next).start) : 0);
    }
    Going best_way(int group, std::size_t k, bool replaces) const {
        Going best{{group, 0, false}};
        double least = std::numeric_limits<double>::infinity();
        for (const Going& way : ways(group))
            if (const double sum = gaps(way, k, replaces); sum < least) {
                least = sum;
                best = way;
            }
        return best;
    }
    Point place_of(const Going& going, bool end) const {
        const tour::Element& element = problem_.elements[at(going.step.element)];
        const int last = static_cast<int>(element.points.size()) - 1, in = step_of(going).entry;
        return element.points[at(end && !element.closed ? last - in : in)];
    }
    /// Where the straight gaps grow least, by the group's nearest point.
    void insert(int group) {
        const std::vector<Point>& points = problem_.elements[at(group)].points;
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k <= row_.size(); ++k) {
            double sum = 0;
            const auto nearest = [&](Point p) {
                double d = std::numeric_limits<double>::infinity();
                for (const Point q : points) d = std::min(d, distance(p, q));
                return d;
            };
            if (k > 0) sum += nearest(place_of(row_[k - 1], true));
            if (k < row_.size()) sum += nearest(place_of(row_[k], false));
            if (k > 0 && k < row_.size())
                sum -= distance(place_of(row_[k - 1], true), place_of(row_[k], false));
            if (sum < least) {
                least = sum;
                best = k;
            }
        }
        row_.insert(row_.begin() + static_cast<std::ptrdiff_t>(best), best_way(group, best, false));
    }
    /// What must come before others does; else as it was. False: contradictory.
    bool sort_out() {
        std::vector<std::vector<int>> later(job_.groups.size());
        std::vector<int> waits(job_.groups.size(), 0);
        for (const auto& [a, b] : job_.before) {
            later[at(a)].push_back(b);
            ++waits[at(b)];
        }
        std::vector<int> place(job_.groups.size(), 0);
        for (std::size_t k = 0; k < row_.size(); ++k) place[at(row_[k].step.element)] = static_cast<int>(k);
        std::priority_queue<int, std::vector<int>, std::greater<>> ready;
        for (std::size_t g = 0; g < waits.size(); ++g)
            if (waits[g] == 0) ready.push(place[g]);
        std::vector<Going> sorted;
        while (!ready.empty()) {
            const Going& going = row_[at(ready.top())];
            ready.pop();
            sorted.push_back(going);
            for (const int next : later[at(going.step.element)])
                if (--waits[at(next)] == 0) ready.push(place[at(next)]);
        }
        if (sorted.size() != row_.size()) return false;
        row_ = std::move(sorted);
        return true;
    }
    /// The second group of a tie comes beside the first one, where the two do not meet as they are.
    void tie_up(const Tie& tie) {
        tour::Problem two;
        two.elements = {problem_.elements[at(tie.a)], problem_.elements[at(tie.b)]};
        const auto link = std::ranges::find_if(problem_.links, [&](const tour::Link& l) {
            return l.element_a == tie.a && l.element_b == tie.b;
        });
        two.links = {{0, link->vertex_a, 1, link->vertex_b}};
        const auto meet = [&](const Going& first, const Going& second) {
            tour::Step a = step_of(first), b = step_of(second);
            a.element = first.step.element == tie.a ? 0 : 1;
            b.element = 1 - a.element;
            return tour::recount(two, {a, b}).has_value();
        };
        for (std::size_t k = 0; k + 1 < row_.size(); ++k) {
            const int g = row_[k].step.element, h = row_[k + 1].step.element;
            if (((g == tie.a && h == tie.b) || (g == tie.b && h == tie.a)) && meet(row_[k], row_[k + 1]))
                return;
        }
        std::erase_if(row_, [&](const Going& going) { return going.step.element == tie.b; });
        const auto found =
            std::ranges::find_if(row_, [&](const Going& going) { return going.step.element == tie.a; });
        const auto place = static_cast<std::size_t>(found - row_.begin());
        double least = std::numeric_limits<double>::infinity();
        std::pair<Going, Going> best{row_[place], {{tie.b, 0, false}}};
        for (const Going& a : ways(tie.a))
            for (const Going& b : ways(tie.b))
                for (const bool a_first : {true, false}) {
                    const Going &first = a_first ? a : b, &second = a_first ? b : a;
                    if (!meet(first, second)) continue;
                    double sum = 0;
                    if (place > 0) sum += distance(place_of(row_[place - 1], true), place_of(first, false));
                    if (place + 1 < row_.size())
                        sum += distance(place_of(second, true), place_of(row_[place + 1], false));
                    if (sum >= least) continue;
                    least = sum;
                    best = {first, second};
                }
        row_[place] = best.first;
        row_.insert(row_.begin() + static_cast<std::ptrdiff_t>(place) + 1, best.second);
    }

    const Job& job_;
    const Robot& robot_;
    const tour::Problem problem_;
    std::vector<char> there_;
    std::vector<Going> row_;
};

}  // namespace

std::optional<Ordered> mended(const Job& whole, const Robot& robot, const Options& options, Memory& memory,
                              const Progress& progress) {
    Memory::Kept& kept = *memory.kept_;
    if (kept.row.empty()) return std::nullopt;
    const Parted parts = parted(whole, robot.rake_width());
    const Job& job = parts.job;
    const auto goings = Mender(job, robot).mend(kept.row);
    if (!goings) return std::nullopt;
    if (kept.field != job.field || kept.keep_out != job.keep_out) kept.joints.clear();
    kept.begin();
    const bool curved = robot.min_radius > 0 && options.connect.style != connect::Style::straight;
    Options driving = options;
    if (options.straight) driving.avoid.on = false;
    Choices choices(job.groups.size());
    for (const Going& going : *goings)
        choices[at(going.step.element)] = {candidate(job.groups[at(going.step.element)], going, robot)};
    Draft draft;
    if (curved) {
        Pairs pairs(job, choices, robot, driving);
        Made made;
        std::vector<int> row;
        for (const Going& going : *goings) row.push_back(going.step.element);
        const Search search{pairs, made, row, true};
        draft = drafted(job, *goings, robot, driving, &search, kept, progress);
    } else {
        draft = drafted(job, *goings, robot, options, nullptr, kept, progress);
    }
    Ordered answer = std::move(draft.ordered);
    put_together(answer, parts, whole);
    answer.reordered = true;
    answer.tour.stopped = true;
    kept.remember(job, *goings);
    progress.report("driving", 1);
    return answer;
}

}  // namespace strandline::order
