// Branches of a medial axis that are corridors, and the trails they make.
#include "path/fill/trails.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace strandline::fill {
namespace {

constexpr double shortest_arm = 1.0 / 3;  // of the width, of parallel sides: less is a corner or a notch

struct Branch {
    std::vector<int> nodes;
    std::vector<double> openings;  // of the edges between them
};

/// The graph with plain joints taken out; cycles without a junction begin anywhere.
std::vector<Branch> branches_of(const Axis& axis, const std::vector<bool>& gone) {
    std::vector<std::vector<std::pair<int, int>>> beside(axis.nodes.size());  // edge, node
    for (int e = 0; e < static_cast<int>(axis.edges.size()); ++e)
        if (!gone[e]) {
            beside[axis.edges[e].a].emplace_back(e, axis.edges[e].b);
            beside[axis.edges[e].b].emplace_back(e, axis.edges[e].a);
        }
    std::vector<bool> used(axis.edges.size(), false);
    std::vector<Branch> branches;
    const auto walk = [&](int node, std::pair<int, int> step) {
        Branch branch{{node}, {}};
        while (true) {
            const auto [edge, next] = step;
            used[edge] = true;
            branch.nodes.push_back(next);
            branch.openings.push_back(axis.edges[edge].opening);
            if (beside[next].size() != 2) break;
            step = beside[next][beside[next][0].first == edge ? 1 : 0];
            if (used[step.first]) break;
        }
        branches.push_back(std::move(branch));
    };
    for (bool joints : {false, true})
        for (int node = 0; node < static_cast<int>(beside.size()); ++node)
            if ((beside[node].size() == 2) == joints)
                for (const auto& step : beside[node])
                    if (!used[step.first]) walk(node, step);
    return branches;
}

double step_length(const Axis& axis, const Branch& branch, std::size_t i) {
    return distance(axis.nodes[branch.nodes[i]].at, axis.nodes[branch.nodes[i + 1]].at);
}

double parallel_length(const Axis& axis, const Branch& branch) {
    double sum = 0;
    for (std::size_t i = 0; i < branch.openings.size(); ++i)
        if (branch.openings[i] >= parallel_sides) sum += step_length(axis, branch, i);
    return sum;
}

std::vector<Branch> corridors(const Axis& axis, double width) {
    std::vector<bool> gone(axis.edges.size(), false);
    std::map<std::pair<int, int>, int> number;
    for (int e = 0; e < static_cast<int>(axis.edges.size()); ++e)
        number[std::minmax({axis.edges[e].a, axis.edges[e].b})] = e;
    while (true) {
        std::vector<Branch> branches = branches_of(axis, gone);
        std::vector<int> degree(axis.nodes.size(), 0);
        for (const Branch& branch : branches) ++degree[branch.nodes.front()], ++degree[branch.nodes.back()];
        bool changed = false;
        for (const Branch& branch : branches) {
            const bool leaf = degree[branch.nodes.front()] == 1 || degree[branch.nodes.back()] == 1;
            if (!leaf || parallel_length(axis, branch) >= shortest_arm * width) continue;
            for (std::size_t i = 0; i + 1 < branch.nodes.size(); ++i)
                gone[number[std::minmax({branch.nodes[i], branch.nodes[i + 1]})]] = true;
            changed = true;
        }
        if (!changed) return branches;
    }
}

}  // namespace

std::vector<Trail> trails_of(const Axis& axis, double width) {
    const std::vector<Branch> branches = corridors(axis, width);
    const auto heading_from = [&](const Branch& branch, bool at_front) {
        double gone = 0;
        const std::size_t n = branch.nodes.size();
        std::size_t i = 0;
        while (i + 1 < n && gone < width / 2)
            gone += step_length(axis, branch, at_front ? i : n - 2 - i), ++i;
        const auto node = [&](std::size_t k) {
            return axis.nodes[branch.nodes[at_front ? k : n - 1 - k]].at;
        };
        return normalized(node(i) - node(0));
    };
    using End = std::pair<std::size_t, bool>;  // branch, at its front
    std::map<int, std::vector<End>> junctions;
    for (std::size_t k = 0; k < branches.size(); ++k) {
        junctions[branches[k].nodes.front()].emplace_back(k, true);
        junctions[branches[k].nodes.back()].emplace_back(k, false);
    }
    std::map<End, End> goes_on;
    std::set<End> cut;
    for (const auto& [node, ends] : junctions) {
        if (ends.size() < 2) continue;
        double straightest = 2;
        std::pair<End, End> best;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const double along = dot(heading_from(branches[ends[i].first], ends[i].second),
                                         heading_from(branches[ends[j].first], ends[j].second));
                if (along < straightest) straightest = along, best = {ends[i], ends[j]};
            }
        goes_on[best.first] = best.second;
        goes_on[best.second] = best.first;
        for (const End& end : ends)
            if (end != best.first && end != best.second) cut.insert(end);
    }
    std::vector<bool> used(branches.size(), false);
    std::vector<Trail> trails;
    const auto follow = [&](End end) {  // from `end`, away from its node
        Trail trail{{}, cut.contains(end), false};
        while (!used[end.first]) {
            used[end.first] = true;
            std::vector<int> nodes = branches[end.first].nodes;
            if (!end.second) std::ranges::reverse(nodes);
            trail.nodes.insert(trail.nodes.end(), nodes.begin() + (trail.nodes.empty() ? 0 : 1), nodes.end());
            const End far{end.first, !end.second};
            trail.cut_end = cut.contains(far);
            const auto next = goes_on.find(far);
            if (next == goes_on.end()) break;
            end = next->second;
        }
        trails.push_back(std::move(trail));
    };
    for (std::size_t k = 0; k < branches.size(); ++k)
        for (bool front : {true, false})
            if (!used[k] && !goes_on.contains({k, front})) follow({k, front});
    for (std::size_t k = 0; k < branches.size(); ++k)  // what is left are cycles
        if (!used[k]) follow({k, true});
    return trails;
}

}  // namespace strandline::fill
