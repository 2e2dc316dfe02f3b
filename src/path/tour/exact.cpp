#include "path/tour/exact.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "path/tour/bound.hpp"

namespace strandline::tour {
namespace {

using Mask = std::uint64_t;
std::size_t at(int i) { return static_cast<std::size_t>(i); }
Mask bit(int i) { return Mask{1} << i; }

/// Rounding: bounds and costs are sums of some dozens of terms.
constexpr double slack_share = 1e-10;

/// The rules as masks: what must and must not have been passed before a piece is run one way or the other.
struct Gates {
    struct Way {
        Mask must = 0, must_not = 0;
        int entry_group = -1, exit_group = -1;
        bool open = true;
    };
    std::vector<Way> ways;  ///< 2 * piece + backward
    std::vector<Mask> groups;

    bool lets(Mask passed, int last_way, int way) const {
        const Way& w = ways[at(way)];
        if ((w.must & ~passed) || (w.must_not & passed)) return false;
        const int left = last_way < 0 ? -1 : ways[at(last_way)].exit_group;
        // A group begun is finished first; one is entered in its midst only from itself.
        if (left >= 0 && left != w.entry_group && (groups[at(left)] & ~passed)) return false;
        if (w.entry_group >= 0 && left != w.entry_group && (groups[at(w.entry_group)] & passed)) return false;
        return true;
    }
};

Gates build_gates(const Model& model) {
    const Rules& rules = model.rules;
    Gates gates;
    gates.ways.resize(2 * model.pieces.size());
    gates.groups.assign(rules.group_size.size(), 0);
    for (std::size_t e = 0; e < model.piece_of.size(); ++e)
        if (const int g = rules.group_of[e]; g >= 0) gates.groups[at(g)] |= bit(model.piece_of[e]);
    for (int p = 0; p < model.piece_count(); ++p) {
        const Piece& piece = model.pieces[at(p)];
        const int size = static_cast<int>(piece.members.size());
        for (int backward = 0; backward < 2; ++backward) {
            Gates::Way& way = gates.ways[at(2 * p + backward)];
            way.open = piece.direction == 0 || (piece.direction < 0) == (backward == 1);
            const auto group_at = [&](int k) {
                return rules.group_of[at(piece.members[at(backward ? size - 1 - k : k)].element)];
            };
            way.entry_group = group_at(0);
            way.exit_group = group_at(size - 1);
            for (int k = 0; k < size; ++k) {
                const int g = group_at(k);
                if (g < 0) continue;
                const Mask others = gates.groups[at(g)] & ~bit(p);
                if (k > 0 && group_at(k - 1) != g) way.must_not |= others;
                if (k + 1 < size && group_at(k + 1) != g) way.must |= others;
                if (rules.keep_group_order)
                    for (int h = 0; h < g; ++h) way.must |= gates.groups[at(h)] & ~bit(p);
            }
        }
    }
    for (const auto& [i, j] : rules.before)
        for (int backward = 0; backward < 2; ++backward)
            gates.ways[at(2 * model.piece_of[at(j)] + backward)].must |= bit(model.piece_of[at(i)]);
    return gates;
}

Route build_route(const Model& model, const Gates& gates) {
    Route route;
    for (int p = 0; p < model.piece_count(); ++p) {
        const Piece& piece = model.pieces[at(p)];
        route.first.push_back(static_cast<int>(route.options.size()));
        route.polygon.push_back(piece.choices > 0 || model.ends[at(2 * p)] == model.ends[at(2 * p + 1)]);
        for (int c = 0; c < piece.choices; ++c) {
            const Point v = model.choices[at(piece.first_choice + c)].at;
            route.options.push_back({p, false, c, v, v});
        }
        for (const bool backward : {false, true})
            if (piece.choices == 0 && gates.ways[at(2 * p + backward)].open)
                route.options.push_back(
                    {p, backward, 0, model.ends[at(2 * p + backward)], model.ends[at(2 * p + 1 - backward)]});
        route.all |= bit(p);
    }
    route.first.push_back(static_cast<int>(route.options.size()));
    return route;
}

struct State {
    Mask passed;
    int option, parent;
    double cost;
};
struct Key {
    Mask passed;
    int option;
    bool operator==(const Key&) const = default;
};
struct KeyHash {
    std::size_t operator()(const Key& key) const {
        Mask h = key.passed * 0x9e3779b97f4a7c15ULL +
                 static_cast<Mask>(key.option);  // golden ratio, then mixed down
        h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ULL;
        return h ^ (h >> 32);
    }
};

/// What a run of the programme shares with the next.
struct Budget {
    std::uint64_t left;
    bool spent = false;
};

/// The best path shorter than `upper`, which it lowers; empty when there is none. `lead`: a piece passed
/// already, and how.
std::vector<Visit> shortest(const Gates& gates, Route route, int lead_way, double& upper, double slack,
                            Budget& budget, const Progress& progress) {
    const Bound bound(route, upper, slack);
    if (bound.root() > upper - slack) return {};
    const auto way_of = [&](int option) {
        return 2 * route.options[at(option)].stop + (route.options[at(option)].backward ? 1 : 0);
    };
    const Mask lead = lead_way < 0 ? 0 : bit(lead_way / 2);
    const Mask all = route.all;
    std::vector<std::vector<State>> layers(1, {{lead, -1, -1, 0}});
    std::vector<Visit> best;
    std::unordered_map<Mask, double> trees;
    std::unordered_map<Key, int, KeyHash> met;
    while (!layers.back().empty()) {
        const std::vector<State>& layer = layers.back();
        std::vector<State> next;
        trees.clear();
        met.clear();
        for (std::size_t k = 0; k < layer.size(); ++k) {
            const State state = layer[k];
            const int last_way = state.option < 0 ? lead_way : way_of(state.option);
            const Point* here = state.option < 0 ? route.from : &route.options[at(state.option)].out;
            for (int stop = 0; stop < route.stops(); ++stop) {
                if (!(all & bit(stop)) || (state.passed & bit(stop))) continue;
                const Mask passed = state.passed | bit(stop), open = all & ~passed;
                for (int o = route.first[at(stop)]; o < route.first[at(stop + 1)]; ++o) {
                    if (!gates.lets(state.passed, last_way, way_of(o))) continue;
                    if (budget.left == 0 || (budget.left % 65536 == 0 && progress.stopped())) {
                        budget.spent = true;
                        return {};
                    }
                    --budget.left;
                    const double cost = state.cost + (here ? distance(*here, route.options[at(o)].in) : 0);
                    if (cost > upper - slack) continue;
                    if (open == 0) {
                        const double total =
                            cost + (route.to ? distance(route.options[at(o)].out, *route.to) : 0);
                        if (total > upper - slack) continue;
                        upper = total;
                        best.clear();
                        best.push_back({stop, route.options[at(o)].backward, route.options[at(o)].choice});
                        int parent = static_cast<int>(k);
                        for (std::size_t l = layers.size() - 1; l > 0; --l) {
                            const State& s = layers[l][at(parent)];
                            const Option& option = route.options[at(s.option)];
                            best.push_back({option.stop, option.backward, option.choice});
                            parent = s.parent;
                        }
                        continue;
                    }
                    const auto [found, fresh] = met.try_emplace({passed, o}, -1);
                    if (!fresh) {
                        // -1: its bound was too high at a cost that was not higher, or has not been looked at
                        // since
                        if (found->second >= 0 && next[at(found->second)].cost <= cost) continue;
                        if (found->second >= 0) {
                            next[at(found->second)].cost = cost;
                            next[at(found->second)].parent = static_cast<int>(k);
                            continue;
                        }
                    }
                    const auto [tree, new_mask] = trees.try_emplace(open, 0.0);
                    if (new_mask) tree->second = bound.tree(open);
                    if (cost + bound.from_option(o, open, tree->second) > upper - slack) continue;
                    found->second = static_cast<int>(next.size());
                    next.push_back({passed, o, static_cast<int>(k), cost});
                }
            }
        }
        layers.push_back(std::move(next));
    }
    std::reverse(best.begin(), best.end());
    return best;
}

}  // namespace

std::optional<std::vector<Visit>> prove(const Model& model, const std::vector<Visit>& known, double upper,
                                        std::uint64_t work, const Progress& progress) {
    if (model.piece_count() > most_exact_pieces) return std::nullopt;
    if (model.pieces.empty()) return known;
    const Gates gates = build_gates(model);
    const Route route = build_route(model, gates);
    const double slack = std::max(model.tolerance, slack_share * upper);
    std::vector<Visit> best = known;
    Budget budget{work};
    if (model.gate) {
        Route open = route;
        const Problem& problem = *model.problem;
        if (problem.start) open.from = &model.ends[at(model.gate_start)];
        if (problem.end != End::free) open.to = &model.ends[at(model.gate_end)];
        const auto found = shortest(gates, std::move(open), -1, upper, slack, budget, progress);
        if (!found.empty()) best = found;
    } else {
        // A ring: opened at one piece, in each way of passing it. Rules count from the first piece, so then
        // every piece may be it.
        int fewest = 0;
        for (int p = 1; p < model.piece_count(); ++p)
            if (route.first[at(p + 1)] - route.first[at(p)] <
                route.first[at(fewest + 1)] - route.first[at(fewest)])
                fewest = p;
        for (int p = 0; p < model.piece_count() && !budget.spent; ++p) {
            if (!model.rules.any && p != fewest) continue;
            for (int o = route.first[at(p)]; o < route.first[at(p + 1)] && !budget.spent; ++o) {
                const Option& lead = route.options[at(o)];
                const int way = 2 * p + (lead.backward ? 1 : 0);
                if (!gates.lets(0, -1, way)) continue;
                if (model.piece_count() == 1) {
                    const double length = distance(lead.out, lead.in);
                    if (length < upper - slack) {
                        upper = length;
                        best = {{p, lead.backward, lead.choice}};
                    }
                    continue;
                }
                Route rest = route;
                rest.all &= ~bit(p);
                rest.from = &lead.out;
                rest.to = &lead.in;
                const auto found = shortest(gates, std::move(rest), way, upper, slack, budget, progress);
                if (found.empty()) continue;
                best = {{p, lead.backward, lead.choice}};
                best.insert(best.end(), found.begin(), found.end());
            }
        }
    }
    if (budget.spent) return std::nullopt;
    return best;
}

}  // namespace strandline::tour
