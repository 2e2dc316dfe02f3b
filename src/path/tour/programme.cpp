#include "path/tour/programme.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace strandline::tour {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// An arc is cut into so many for the next level.
constexpr int arc_parts = 4;
/// A matrix of all legs is kept: 128 MB at most.
constexpr std::size_t most_options = 4'000;
/// Sets of one size times coarsest arcs, for so much work: 16 MB for the usual one. What needs more is
/// hopeless.
constexpr std::uint64_t work_a_cost = 15;
constexpr std::size_t most_costs = 50'000'000;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Options of one stop that are taken together: a line's one way, or neighbouring vertices of a polygon.
struct Arc {
    int stop, way;
    int first, last;  ///< options
    int begin, end;   ///< the arcs of the next level
};
struct Level {
    std::vector<Arc> arcs;
    std::vector<double> leg;         ///< arc x arc: least from any exit to any entry
    std::vector<double> from, onto;  ///< by arc: the first leg to it, the last from it

    double leg_of(int a, int b) const { return leg[at(a) * arcs.size() + at(b)]; }
};
/// How an arc was come to with the set passed: the cost from the start, or to the end.
struct State {
    int arc;
    double cost;
};
/// Numbers of sets (not empty), in the order they came. Open addressing: looking sets up is half the work.
class Sets {
  public:
    /// -1: not here.
    int find(Mask set) const { return slots_[slot_of(set)].number; }
    int insert(Mask set) {
        if (2 * all_.size() >= slots_.size()) grow();
        Slot& slot = slots_[slot_of(set)];
        if (slot.number < 0) {
            slot = {set, static_cast<int>(all_.size())};
            all_.push_back(set);
        }
        return slot.number;
    }
    const std::vector<Mask>& all() const { return all_; }
    void clear() {
        all_.clear();
        std::ranges::fill(slots_, Slot{});
    }

  private:
    struct Slot {
        Mask set = 0;
        int number = -1;
    };
    std::size_t slot_of(Mask set) const {
        // golden ratio; the upper bits are the mixed ones
        std::size_t k = (set * 0x9e3779b97f4a7c15ULL) >> shift_;
        while (slots_[k].number >= 0 && slots_[k].set != set) k = (k + 1) % slots_.size();
        return k;
    }
    void grow() {
        slots_.assign(2 * slots_.size(), {});
        --shift_;
        for (std::size_t k = 0; k < all_.size(); ++k)
            slots_[slot_of(all_[k])] = {all_[k], static_cast<int>(k)};
    }

    int shift_ = 56;  ///< 64 - log2(slots)
    std::vector<Slot> slots_ = std::vector<Slot>(256);
    std::vector<Mask> all_;
};

struct Table {
    struct Range {
        std::size_t begin = 0, end = 0;
    };
    std::vector<State> states;
    Sets sets;
    std::vector<Range> ranges;              ///< by set: its states
    std::vector<std::vector<Mask>> layers;  ///< by number of stops passed

    Range states_of(Mask set) const {
        const int number = sets.find(set);
        return number < 0 ? Range{} : ranges[at(number)];
    }
    void close(Mask set, std::size_t begin, std::size_t layer) {
        if (states.size() == begin) return;
        sets.insert(set);
        ranges.push_back({begin, states.size()});
        layers[layer].push_back(set);
    }
};

class Programme {
  public:
    Programme(const Gates& gates, Route route, int lead_way, double upper, double slack, Work& work,
              const Progress& progress)
        : gates_(gates),
          route_(std::move(route)),
          bound_(route_, upper, slack),
          lead_way_(lead_way),
          lead_(lead_way < 0 ? 0 : bit(lead_way / 2)),
          limit_(upper - slack),
          work_(work),
          progress_(progress) {
        stops_ = static_cast<std::size_t>(std::popcount(route_.all));
        costs_allowed_ = std::min<std::uint64_t>(most_costs, work.left / work_a_cost);
    }

    /// Lowers `upper` to the length of what it finds.
    std::vector<Visit> run(double& upper) {
        if (bound_.root() > limit_) return {};
        if (route_.options.size() > most_options) {
            work_.spent = true;
            return {};
        }
        measure_options();
        Level level = coarsest();
        Table table = first_table(level);
        bool forward = true;
        while (!work_.spent && !table.layers[forward ? stops_ : 1].empty() && split(level)) {
            forward = !forward;
            table = forward ? forward_table(level, table) : backward_table(level, table);
        }
        if (work_.spent || table.layers[forward ? stops_ : 1].empty()) return {};
        const std::vector<int> arcs = forward ? traced_back(level, table) : traced_on(level, table);
        std::vector<Visit> visits;
        double length = level.from[at(arcs.front())] + level.onto[at(arcs.back())];
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            if (k > 0) length += level.leg_of(arcs[k - 1], arcs[k]);
            const Option& option = route_.options[at(level.arcs[at(arcs[k])].first)];
            visits.push_back({option.stop, option.backward, option.choice});
        }
        // The coarser costs let it pass; its own may not.
        if (length > limit_) return {};
        upper = length;
        return visits;
    }

  private:
    bool spend(std::uint64_t legs) {
        if (work_.left < legs || progress_.stopped()) {
            work_.spent = true;
            return false;
        }
        work_.left -= legs;
        return true;
    }
    int stop_of(const Level& level, int arc) const { return level.arcs[at(arc)].stop; }
    bool lets(const Level& level, Mask set, int before, int after) const {
        return gates_.lets(set | lead_, before < 0 ? lead_way_ : level.arcs[at(before)].way,
                           level.arcs[at(after)].way);
    }

    void measure_options() {
        const std::size_t n = route_.options.size();
        option_leg_.resize(n * n);
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b)
                option_leg_[a * n + b] = distance(route_.options[a].out, route_.options[b].in);
    }

    Level coarsest() const {
        Level level;
        for (int s = 0; s < route_.stops(); ++s) {
            if (!(route_.all & bit(s))) continue;
            const int first = route_.first[at(s)], last = route_.first[at(s + 1)];
            // A polygon's options run one way; a line's do not.
            const bool together =
                last > first && !route_.options[at(first)].backward && !route_.options[at(last - 1)].backward;
            for (int o = first; o < last; o = together ? last : o + 1)
                level.arcs.push_back(
                    {s, 2 * s + (route_.options[at(o)].backward ? 1 : 0), o, together ? last : o + 1, 0, 0});
        }
        measure(level);
        return level;
    }

    void measure(Level& level) const {
        const std::size_t n = route_.options.size(), count = level.arcs.size();
        level.leg.assign(count * count, infinite);
        level.from.assign(count, infinite);
        level.onto.assign(count, infinite);
        for (std::size_t a = 0; a < count; ++a) {
            const Arc& arc = level.arcs[a];
            for (int o = arc.first; o < arc.last; ++o) {
                const Option& option = route_.options[at(o)];
                level.from[a] = std::min(level.from[a], route_.from ? distance(*route_.from, option.in) : 0);
                level.onto[a] = std::min(level.onto[a], route_.to ? distance(option.out, *route_.to) : 0);
                for (std::size_t b = 0; b < count; ++b) {
                    double& leg = level.leg[a * count + b];
                    for (int p = level.arcs[b].first; p < level.arcs[b].last; ++p)
                        leg = std::min(leg, option_leg_[at(o) * n + at(p)]);
                }
            }
        }
    }

    /// False when every arc is a single option already.
    bool split(Level& level) {
        Level next;
        for (Arc& arc : level.arcs) {
            const int size = arc.last - arc.first, parts = std::min(size, arc_parts);
            arc.begin = static_cast<int>(next.arcs.size());
            for (int k = 0; k < parts; ++k)
                next.arcs.push_back({arc.stop, arc.way, arc.first + size * k / parts,
                                     arc.first + size * (k + 1) / parts, 0, 0});
            arc.end = static_cast<int>(next.arcs.size());
        }
        if (next.arcs.size() == level.arcs.size()) return false;
        measure(next);
        parents_ = std::move(level.arcs);
        level = std::move(next);
        return true;
    }

    Table first_table(const Level& level) {
        const std::size_t count = level.arcs.size();
        std::vector<std::vector<double>> reach;
        for (const Arc& arc : level.arcs) reach.push_back(bound_.reach(arc.first, arc.last));
        Table table;
        table.layers.resize(stops_ + 1);
        Sets rows;                  // of the next layer
        std::vector<double> costs;  // row x arc
        const auto row_of = [&](Mask set) {
            const std::size_t row = at(rows.insert(set)) * count;
            if (costs.size() == row) costs.resize(row + count, infinite);
            return row;
        };
        for (std::size_t a = 0; a < count; ++a)
            if (lets(level, 0, -1, static_cast<int>(a)))
                costs[row_of(bit(level.arcs[a].stop)) + a] = level.from[a];
        for (std::size_t layer = 1; layer <= stops_; ++layer) {
            if (!spend(rows.all().size() * count)) return table;
            for (std::size_t r = 0; r < rows.all().size(); ++r) {
                const Mask set = rows.all()[r], open = route_.all & ~set;
                const std::size_t begin = table.states.size();
                std::optional<double> tree;
                for (std::size_t a = 0; a < count; ++a) {
                    const double cost = costs[r * count + a];
                    if (cost > limit_) continue;
                    if (open != 0 && !tree) tree = bound_.tree(open);
                    const double rest = open == 0 ? level.onto[a] : bound_.first_leg(reach[a], open) + *tree;
                    if (cost + rest <= limit_) table.states.push_back({static_cast<int>(a), cost});
                }
                table.close(set, begin, layer);
            }
            rows.clear();
            costs.clear();
            for (const Mask set : table.layers[layer]) {
                const Table::Range range = table.states_of(set);
                if (costs.size() > costs_allowed_) work_.left = 0;
                if (!spend((range.end - range.begin) * count)) return table;
                int stop = -1;
                std::size_t row = 0;
                for (std::size_t b = 0; b < count; ++b) {
                    if (set & bit(level.arcs[b].stop)) continue;
                    double best = infinite;
                    for (std::size_t k = range.begin; k < range.end; ++k) {
                        const State& state = table.states[k];
                        const double cost = state.cost + level.leg_of(state.arc, static_cast<int>(b));
                        if (cost < best && lets(level, set, state.arc, static_cast<int>(b))) best = cost;
                    }
                    if (best > limit_) continue;
                    if (stop != level.arcs[b].stop) {
                        stop = level.arcs[b].stop;
                        row = row_of(set | bit(stop));
                    }
                    costs[row + b] = std::min(costs[row + b], best);
                }
            }
        }
        return table;
    }

    /// From the start, each state within the limit together with what the coarser one needs to the end.
    Table forward_table(const Level& level, const Table& coarse) {
        Table table;
        table.layers.resize(stops_ + 1);
        for (std::size_t layer = 1; layer <= stops_; ++layer)
            for (const Mask set : coarse.layers[layer]) {
                const Table::Range parents = coarse.states_of(set);
                const std::size_t begin = table.states.size();
                Mask before = set;
                Table::Range range;
                for (std::size_t k = parents.begin; k < parents.end; ++k) {
                    const State parent = coarse.states[k];
                    const Arc& arc = parents_[at(parent.arc)];
                    if (before != (set & ~bit(arc.stop))) {
                        before = set & ~bit(arc.stop);
                        range = table.states_of(before);
                    }
                    if (!spend((range.end - range.begin + 1) * at(arc.end - arc.begin))) return table;
                    for (int a = arc.begin; a < arc.end; ++a) {
                        double best = layer == 1 ? level.from[at(a)] : infinite;
                        for (std::size_t s = range.begin; s < range.end; ++s) {
                            const State& state = table.states[s];
                            const double cost = state.cost + level.leg_of(state.arc, a);
                            if (cost < best && lets(level, before, state.arc, a)) best = cost;
                        }
                        if (best + parent.cost <= limit_) table.states.push_back({a, best});
                    }
                }
                table.close(set, begin, layer);
            }
        return table;
    }

    /// From the end, likewise.
    Table backward_table(const Level& level, const Table& coarse) {
        Table table;
        table.layers.resize(stops_ + 1);
        std::vector<State> after;
        for (std::size_t layer = stops_; layer >= 1; --layer)
            for (const Mask set : coarse.layers[layer]) {
                const Table::Range parents = coarse.states_of(set);
                const std::size_t begin = table.states.size();
                gather_after(level, table, set, after);
                for (std::size_t k = parents.begin; k < parents.end; ++k) {
                    const State parent = coarse.states[k];
                    const Arc& arc = parents_[at(parent.arc)];
                    if (!spend((after.size() + 1) * at(arc.end - arc.begin))) return table;
                    for (int a = arc.begin; a < arc.end; ++a) {
                        double best = layer == stops_ ? level.onto[at(a)] : infinite;
                        for (const State& state : after) {
                            const double cost = state.cost + level.leg_of(a, state.arc);
                            if (cost < best && lets(level, set, a, state.arc)) best = cost;
                        }
                        if (best + parent.cost <= limit_) table.states.push_back({a, best});
                    }
                }
                table.close(set, begin, layer);
            }
        return table;
    }

    /// The states that can follow the set.
    void gather_after(const Level& level, const Table& table, Mask set, std::vector<State>& after) const {
        after.clear();
        for (Mask open = route_.all & ~set; open != 0; open &= open - 1) {
            const Mask stop = open & (~open + 1);
            const Table::Range range = table.states_of(set | stop);
            for (std::size_t s = range.begin; s < range.end; ++s)
                if (bit(stop_of(level, table.states[s].arc)) == stop) after.push_back(table.states[s]);
        }
    }

    std::vector<int> traced_back(const Level& level, const Table& table) const {
        std::vector<int> arcs;
        Mask set = route_.all;
        int arc = -1;
        while (set != 0) {
            const Table::Range range = table.states_of(set);
            int best = -1;
            double least = infinite;
            for (std::size_t s = range.begin; s < range.end; ++s) {
                const State& state = table.states[s];
                const double cost =
                    state.cost + (arc < 0 ? level.onto[at(state.arc)] : level.leg_of(state.arc, arc));
                if (cost >= least || (arc >= 0 && !lets(level, set, state.arc, arc))) continue;
                least = cost;
                best = state.arc;
            }
            arcs.push_back(best);
            set &= ~bit(stop_of(level, best));
            arc = best;
        }
        std::ranges::reverse(arcs);
        return arcs;
    }

    std::vector<int> traced_on(const Level& level, const Table& table) const {
        std::vector<int> arcs;
        std::vector<State> after;
        Mask set = 0;
        int arc = -1;
        while (set != route_.all) {
            gather_after(level, table, set, after);
            int best = -1;
            double least = infinite;
            for (const State& state : after) {
                const double cost =
                    state.cost + (arc < 0 ? level.from[at(state.arc)] : level.leg_of(arc, state.arc));
                if (cost >= least || !lets(level, set, arc, state.arc)) continue;
                least = cost;
                best = state.arc;
            }
            arcs.push_back(best);
            set |= bit(stop_of(level, best));
            arc = best;
        }
        return arcs;
    }

    const Gates& gates_;
    Route route_;
    Bound bound_;  ///< of the route
    int lead_way_;
    Mask lead_;
    double limit_;
    Work& work_;
    const Progress& progress_;
    std::size_t stops_;
    std::size_t costs_allowed_;
    std::vector<double> option_leg_;  ///< option x option
    std::vector<Arc> parents_;        ///< of the level before
};

}  // namespace

std::vector<Visit> shortest(const Gates& gates, Route route, int lead_way, double& upper, double slack,
                            Work& work, const Progress& progress) {
    Programme programme(gates, std::move(route), lead_way, upper, slack, work, progress);
    return programme.run(upper);
}

}  // namespace strandline::tour
