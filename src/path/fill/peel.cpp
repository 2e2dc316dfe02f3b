// Rings, inside to outside: the reverse of a connected peel from the outline in.
// A tree over neighbouring rings, its root the outline's, is raked from its leaves; each ring before its
// parent. What is not raked yet is then one connected piece that holds the way out, so every rake-up way can
// run over sand that is raked later.
#include "path/fill/peel.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "path/fill/keep_off.hpp"
#include "path/fill/seams.hpp"

namespace strandline::fill {
namespace {

constexpr double off_raked =
    0.045;                          // of the width: half the diagonal of the raster on which fills are judged
constexpr double beyond_end = 0.3;  // of the width
constexpr double bow_share =
    1.5;  // of off_raked, in its middle: where less than two thirds of a way run nearer, none is a drive over

using Neighbours = std::vector<std::vector<Contact>>;  // by ring; `second` is the other one

Neighbours neighbours_of(std::size_t rings, const std::vector<Contact>& contacts) {
    Neighbours beside(rings);
    for (const Contact& c : contacts) {
        beside[static_cast<std::size_t>(c.first)].push_back(c);
        beside[static_cast<std::size_t>(c.second)].push_back({c.second, c.first, c.edges});
    }
    return beside;
}

enum class Rank { fewest_left, deepest, longest_contact };

/// Depth first from the outermost ring of each component; the next neighbour by `rank`. O(contacts x degree).
Tree depth_first(const std::vector<Ring>& rings, const Neighbours& beside, Rank rank) {
    Tree tree{std::vector<int>(rings.size(), -1), 0};
    std::vector<char> peeled(rings.size(), 0);
    const auto free_about = [&](int ring) {
        return static_cast<double>(std::ranges::count_if(
            beside[static_cast<std::size_t>(ring)],
            [&](const Contact& c) { return !peeled[static_cast<std::size_t>(c.second)]; }));
    };
    for (std::size_t root = 0; root < rings.size(); ++root) {
        if (peeled[root]) continue;
        std::vector<int> stack{static_cast<int>(root)};
        peeled[root] = 1;
        bool advanced = true;
        while (!stack.empty()) {
            const int here = stack.back();
            const Contact* best = nullptr;
            double least = 0;
            for (const Contact& c : beside[static_cast<std::size_t>(here)]) {
                if (peeled[static_cast<std::size_t>(c.second)]) continue;
                const Ring& ring = rings[static_cast<std::size_t>(c.second)];
                const double value = rank == Rank::fewest_left ? free_about(c.second) - 1e-6 * c.edges
                                     : rank == Rank::deepest   ? -ring.level - 1e-6 * c.edges
                                                               : -c.edges;
                if (!best || value < least) best = &c, least = value;
            }
            if (best) {
                tree.parent[static_cast<std::size_t>(best->second)] = here;
                peeled[static_cast<std::size_t>(best->second)] = 1;
                stack.push_back(best->second);
                advanced = true;
            } else {
                if (advanced) ++tree.leaves;
                advanced = false;
                stack.pop_back();
            }
        }
    }
    return tree;
}

/// The tree with the fewest leaves of a few: each leaf but one costs a hop.
Tree fewest_leaves(const std::vector<Ring>& rings, const Neighbours& beside) {
    Tree best = depth_first(rings, beside, Rank::fewest_left);
    for (Rank rank : {Rank::deepest, Rank::longest_contact})
        if (Tree tree = depth_first(rings, beside, rank); tree.leaves < best.leaves) best = std::move(tree);
    return best;
}

/// Without a lattice: each ring leads on to the nearest one a level further out. O(rings a level squared x
/// points).
Tree by_levels(const std::vector<Ring>& rings) {
    Tree tree{std::vector<int>(rings.size(), -1), 0};
    std::map<int, std::vector<int>> levels;
    for (std::size_t r = 0; r < rings.size(); ++r) levels[rings[r].level].push_back(static_cast<int>(r));
    for (std::size_t r = 0; r < rings.size(); ++r) {
        double least = std::numeric_limits<double>::infinity();
        const auto outer = levels.find(rings[r].level - 1);
        if (outer == levels.end()) continue;
        for (int other : outer->second) {
            const double d = nearest(rings[static_cast<std::size_t>(other)], rings[r].line.front()).distance;
            if (d < least) least = d, tree.parent[r] = other;
        }
    }
    return tree;
}

/// Chains of rings that lead on to each other, in driving order: always the nearest leaf next, and on from
/// ring to parent as long as that is free.
std::vector<std::vector<int>> chains_of(const std::vector<Ring>& rings, const Tree& tree,
                                        std::optional<Point> start) {
    std::vector<int> children(rings.size(), 0);
    for (int p : tree.parent)
        if (p >= 0) ++children[static_cast<std::size_t>(p)];
    std::vector<int> leaves;
    for (std::size_t r = rings.size(); r-- > 0;)
        if (children[r] == 0) leaves.push_back(static_cast<int>(r));
    std::vector<std::vector<int>> chains;
    while (!leaves.empty()) {
        auto next = leaves.begin();
        if (!chains.empty()) {
            const Ring& last = rings[static_cast<std::size_t>(chains.back().back())];
            const auto away = [&](int leaf) {
                const Ring& ring = rings[static_cast<std::size_t>(leaf)];
                double least = std::numeric_limits<double>::infinity();
                for (std::size_t i = 0; i < ring.line.size(); i += 1 + ring.line.size() / 16)
                    least = std::min(least, nearest(last, ring.line[i]).distance);
                return least;
            };
            next = std::ranges::min_element(leaves, {}, away);
        } else if (start) {
            next = std::ranges::min_element(leaves, {}, [&](int leaf) {
                return nearest(rings[static_cast<std::size_t>(leaf)], *start).distance;
            });
        }
        std::vector<int> chain{*next};
        leaves.erase(next);
        for (int p = tree.parent[static_cast<std::size_t>(chain.back())];
             p >= 0 && --children[static_cast<std::size_t>(p)] == 0;
             p = tree.parent[static_cast<std::size_t>(p)])
            chain.push_back(p);
        chains.push_back(std::move(chain));
    }
    return chains;
}

/// Whether there is raked sand beyond a tooth's start and beyond its end.
std::pair<bool, bool> meets_raked(const Polyline& tooth, const Trail& trail, double width) {
    const Point beyond = beyond_end * width * normalized(tooth.back() - tooth.front());
    return {trail.raked(tooth.front() - beyond), trail.raked(tooth.back() + beyond)};
}

/// The way from a tooth's end to the start of the next one beside it, where those ends meet raked sand: it
/// bows off it, as far as that makes it no hop; where that is not far enough, both ends are drawn back a
/// hair.
Polyline way_off_raked(Polyline& tooth, Polyline& next, double width) {
    const double apart = distance(tooth.back(), next.front());
    if (apart > width) return {};
    const Point along = normalized(tooth.back() - tooth.front());
    const Point ahead = normalized(next.back() - next.front());
    const double shorter =
        std::min(distance(tooth.front(), tooth.back()), distance(next.front(), next.back())) / 2;
    const double bow = std::min(std::sqrt(width * width - apart * apart) / 2, shorter);
    const double back =
        std::clamp(bow_share * off_raked * width - bow, 0.0, std::min(off_raked * width, shorter / 2));
    tooth.back() = tooth.back() - back * along;
    next.front() = next.front() + back * ahead;
    return {between(tooth.back(), next.front(), 0.5) + bow * normalized(ahead - along)};
}

}  // namespace

Tree tree_of(const std::vector<Ring>& rings, const Lattice& lattice) {
    return lattice.inside.empty() ? by_levels(rings)
                                  : fewest_leaves(rings, neighbours_of(rings.size(), contacts(lattice)));
}

Peel peel_of(const std::vector<Ring>& rings, const Tree& tree, std::optional<Point> start) {
    Peel peel;
    for (const std::vector<int>& numbers : chains_of(rings, tree, start)) {
        Chain chain;
        for (int r : numbers) chain.rings.push_back(&rings[static_cast<std::size_t>(r)]);
        if (const int parent = tree.parent[static_cast<std::size_t>(numbers.back())]; parent >= 0)
            chain.onward = &rings[static_cast<std::size_t>(parent)];
        peel.push_back(std::move(chain));
    }
    return peel;
}

namespace {

/// The rings in the order of their peel, with the ways between.
std::vector<Pass> raked(const std::vector<Ring>& rings, const Tree& tree, Trail trail, const Wish& wish,
                        const Options& options) {
    std::vector<Pass> passes;
    for (const auto& [chain, onward] : peel_of(rings, tree, wish.start)) {
        const std::optional<Point> here = passes.empty() ? wish.start : passes.back().line.back();
        const std::vector<Seam> seams = seams_of(chain, onward, here, wish.exit, trail.lattice(), options);
        for (std::size_t i = 0; i < chain.size(); ++i) {
            bool joined = seams[i].stepped;
            std::vector<Polyline> lines = passes_along(*chain[i], seams[i], options);
            std::vector<std::pair<bool, bool>> meets;
            if (!chain[i]->teeth.empty())
                for (const Polyline& line : lines) meets.push_back(meets_raked(line, trail, options.width));
            for (std::size_t k = 0; k < lines.size(); ++k) {
                Polyline& line = lines[k];
                // The border stays where it makes the outline crisp; teeth end flush with raked sand.
                if (line.size() > 1 && chain[i]->level > 0 && chain[i]->teeth.empty())
                    line = trail.kept_off(line);
                if (line.size() < 2) {
                    joined = false;
                    continue;
                }
                Polyline reach;
                if (k > 0 && k < meets.size() && (meets[k - 1].second || meets[k].first))
                    reach = way_off_raked(passes.back().line, line, options.width);
                if (!joined && !passes.empty() &&
                    distance(passes.back().line.back(), line.front()) > options.width)
                    reach = trail.way_to(line.front());
                if (std::exchange(joined, false)) {
                    Polyline& last = passes.back().line;
                    trail.add({last.back(), line.front()});
                    trail.add(line);
                    last.insert(last.end(), line.begin(), line.end());
                } else {
                    trail.add(line);
                    passes.push_back({std::move(reach), std::move(line)});
                }
            }
        }
    }
    for (Pass& pass : passes) pass.line = rounded(pass.line, options.round_corners ? options.turn_radius : 0);
    return passes;
}

}  // namespace

Passes ring_passes(const Region& region, const std::string& place, const Options& options, Fill& account) {
    const Levels levels = levels_of(region, place, options, account);
    if (levels.room.empty()) return no_passes;
    std::vector<Ring> rings = rings_of(region, levels, options);
    Lattice lattice = lattice_of(region, rings, place, options, account);
    Tree tree = tree_of(rings, lattice);
    return [rings = std::move(rings), tree = std::move(tree),
            trail = Trail(std::move(lattice), levels.room, options),
            options](const Wish& wish) { return raked(rings, tree, trail, wish, options); };
}

}  // namespace strandline::fill
