#include <algorithm>

#include "path/tour/order.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool keeps_rules(const Model& model, const std::vector<Visit>& order) {
    const Rules& rules = model.rules;
    if (!rules.any) return true;
    std::vector<int> place(model.piece_of.size());
    std::vector<int> begun(rules.group_size.size(), 0);
    int counter = 0, open_group = -1, highest_group = -1;
    for (const Visit& visit : order) {
        const Piece& piece = model.pieces[at(visit.piece)];
        if (piece.direction != 0 && visit.backward != (piece.direction < 0)) return false;
        const int size = static_cast<int>(piece.members.size());
        for (int k = 0; k < size; ++k) {
            const int element = piece.members[at(visit.backward ? size - 1 - k : k)].element;
            place[at(element)] = counter++;
            const int group = rules.group_of[at(element)];
            if (group != open_group) {
                if (open_group >= 0 && begun[at(open_group)] < rules.group_size[at(open_group)]) return false;
                if (group >= 0 && rules.keep_group_order && group < highest_group) return false;
                highest_group = std::max(highest_group, group);
                open_group = group;
            }
            if (group >= 0) ++begun[at(group)];
        }
    }
    return std::all_of(rules.before.begin(), rules.before.end(),
                       [&](const auto& pair) { return place[at(pair.first)] < place[at(pair.second)]; });
}

std::vector<std::size_t> find_circle(int nodes, const std::vector<std::pair<int, int>>& edges) {
    // Peel off what has no predecessor; in what is left, walking back from anywhere must run into a circle.
    std::vector<int> pending(at(nodes), 0);
    std::vector<std::vector<std::size_t>> out(at(nodes));
    for (std::size_t e = 0; e < edges.size(); ++e) {
        out[at(edges[e].first)].push_back(e);
        ++pending[at(edges[e].second)];
    }
    std::vector<int> ready;
    for (int v = 0; v < nodes; ++v)
        if (pending[at(v)] == 0) ready.push_back(v);
    for (std::size_t k = 0; k < ready.size(); ++k)
        for (const std::size_t e : out[at(ready[k])])
            if (--pending[at(edges[e].second)] == 0) ready.push_back(edges[e].second);
    if (static_cast<int>(ready.size()) == nodes) return {};

    std::vector<std::size_t> into(at(nodes), edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (pending[at(edges[e].first)] > 0) into[at(edges[e].second)] = e;
    int v = 0;
    while (pending[at(v)] == 0) ++v;
    for (int k = 0; k < nodes; ++k) v = edges[into[at(v)]].first;
    std::vector<std::size_t> circle;
    for (int w = v; circle.empty() || w != v; w = edges[into[at(w)]].first) circle.push_back(into[at(w)]);
    std::reverse(circle.begin(), circle.end());
    return circle;
}

}  // namespace strandline::tour
