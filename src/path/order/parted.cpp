#include "path/order/parted.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace strandline::order {
namespace {

/// Numbers of the parts of a group: `first` to before `end`; those that nothing of the group comes before,
/// and the last.
struct Parts {
    int first = 0, end = 0;
    std::vector<int> foremost = {};
    int last() const { return end - 1; }
};

/// By stroke: the run of strokes that it belongs to, each within `near` of the one before.
std::vector<int> runs_of(const std::vector<Stroke>& strokes, double near) {
    std::vector<int> runs{0};
    for (std::size_t k = 1; k < strokes.size(); ++k) {
        const Point end = end_pose(strokes[k - 1].rake_path.back()).at;
        runs.push_back(runs.back() + (distance(end, strokes[k].rake_path.front().start.at) > near ? 1 : 0));
    }
    return runs;
}

Parts take_apart(const Group& group, bool whole, double near, std::vector<Group>& into,
                 std::vector<std::pair<int, int>>& before) {
    const int first = static_cast<int>(into.size());
    const std::vector<Stroke>& strokes = group.work.strokes;
    const std::vector<int> runs = runs_of(strokes, near);
    const int last = runs.back();
    if (whole || group.before.empty() || last == 0) {
        into.push_back(group);
        return {first, first + 1, {first}};
    }
    std::set<std::pair<int, int>> pairs;
    for (const auto& [a, b] : group.before)
        pairs.emplace(runs[static_cast<std::size_t>(a)], runs[static_cast<std::size_t>(b)]);
    for (int run = 0; run < last; ++run) pairs.emplace(run, last);
    std::vector<char> waits(static_cast<std::size_t>(last) + 1, 0);
    for (const auto& [a, b] : pairs) {
        if (a == b) continue;
        before.emplace_back(first + a, first + b);
        waits[static_cast<std::size_t>(b)] = 1;
    }
    Parts parts{first, first + last + 1};
    for (int run = 0; run <= last; ++run) {
        if (waits[static_cast<std::size_t>(run)] == 0) parts.foremost.push_back(first + run);
        into.push_back({.work = {group.work.element, {}}, .name = group.name});
    }
    for (std::size_t k = 0; k < strokes.size(); ++k)
        into[static_cast<std::size_t>(first + runs[k])].work.strokes.push_back(strokes[k]);
    into.back().area = group.area;
    return parts;
}

}  // namespace

Parted parted(const Job& job, double near) {
    Parted answer;
    std::vector<Parts> parts;
    std::vector<char> tied(job.groups.size(), 0);
    for (const Tie& tie : job.ties)
        tied[static_cast<std::size_t>(tie.a)] = tied[static_cast<std::size_t>(tie.b)] = 1;
    for (std::size_t g = 0; g < job.groups.size(); ++g) {
        parts.push_back(take_apart(job.groups[g], tied[g] != 0, near, answer.job.groups, answer.job.before));
        answer.group_of.resize(answer.job.groups.size(), static_cast<int>(g));
    }
    const auto of = [&](int group) -> const Parts& { return parts[static_cast<std::size_t>(group)]; };
    for (const auto& [a, b] : job.before)
        for (const int begin : of(b).foremost) answer.job.before.emplace_back(of(a).last(), begin);
    for (const Tie& tie : job.ties)
        answer.job.ties.push_back({of(tie.a).first, tie.node_a, of(tie.b).first, tie.node_b});
    answer.job.start = job.start;
    answer.job.end = job.end;
    answer.job.field = job.field;
    answer.job.keep_out = job.keep_out;
    answer.job.parked = job.parked;
    answer.job.exits = job.exits;
    for (const std::vector<int>& batch : job.batches) {
        answer.job.batches.emplace_back();
        for (const int group : batch)
            for (int k = of(group).first; k < of(group).end; ++k) answer.job.batches.back().push_back(k);
    }
    for (std::size_t i = 0; i < job.shapes.size(); ++i) {
        const Shape& shape = job.shapes[i];
        if (shape.hop) {
            answer.job.shapes.push_back({of(shape.a).first, of(shape.a).first, shape.through, shape.hop});
            answer.shape_of.push_back(static_cast<int>(i));
            continue;
        }
        for (int a = of(shape.a).first; a < of(shape.a).end; ++a)
            for (int b = of(shape.b).first; b < of(shape.b).end; ++b) {
                answer.job.shapes.push_back({a, b, shape.through});
                answer.shape_of.push_back(static_cast<int>(i));
            }
    }
    return answer;
}

void put_together(Ordered& answer, const Parted& parted, const Job& job) {
    std::vector<int> variants(job.groups.size(), -1);
    for (std::size_t k = 0; k < answer.variants.size(); ++k)
        variants[static_cast<std::size_t>(parted.group_of[k])] = answer.variants[k];
    answer.variants = std::move(variants);
    // A wish holds where it holds between some two parts; else what is said last is as good as any.
    std::vector<std::string> unshaped(job.shapes.size());
    std::vector<char> holds(job.shapes.size(), 0);
    for (std::size_t i = 0; i < answer.unshaped.size(); ++i) {
        const auto shape = static_cast<std::size_t>(parted.shape_of[i]);
        holds[shape] |= answer.unshaped[i].empty() ? 1 : 0;
        unshaped[shape] = holds[shape] != 0 ? "" : answer.unshaped[i];
    }
    answer.unshaped = std::move(unshaped);
}

}  // namespace strandline::order
