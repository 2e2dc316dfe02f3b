// Spirals, inside to outside: one line over all rings that have a seam in common.
// Branches of the nest and rings round holes are spirals of their own, raked before what they lead on to.
#include <algorithm>
#include <utility>

#include "path/fill/corners.hpp"
#include "path/fill/keep_off.hpp"
#include "path/fill/peel.hpp"
#include "path/fill/revolve.hpp"
#include "path/fill/seams.hpp"

namespace strandline::fill {
namespace {

constexpr double longest_step = 1.5;   // of the spacing: from or to a spine's end, raked
constexpr double floor_margin = 0.02;  // of the width
constexpr double least_edge = 1e-3;    // of the width: shorter ones have no direction to speak of

/// The passes of one area as they come, and the sand they have raked.
struct Work {
    Trail trail;
    AreaIndex floor;  // of the rake's centre, with room for chords
    std::vector<Pass> passes;
};

/// Goes on with a line: raked from where the rake is when that is a step to or from a spine, else rake up.
void go_on(Work& work, Polyline line, bool may_step, const Options& options) {
    if (line.size() < 2) return;
    Polyline reach;
    if (!work.passes.empty()) {
        Polyline& last = work.passes.back().line;
        const double gap = distance(last.back(), line.front());
        if (may_step && gap < longest_step * options.spacing && sees(work.floor, last.back(), line.front())) {
            work.trail.add({last.back(), line.front()});
            work.trail.add(line);
            last.insert(last.end(), line.begin(), line.end());
            return;
        }
        if (gap > options.width) reach = work.trail.way_to(line.front());
    }
    work.trail.add(line);
    work.passes.push_back({std::move(reach), std::move(line)});
}

/// The line of a spiral. Only the border has its corners cut: within, the line is not interrupted.
void revolve(Work& work, TurnedLine line, bool may_step, bool border, const Options& options) {
    std::vector<Polyline> lasts{line.last};
    if (border) lasts = with_cut_corners(line.last, false, true, options);
    line.rest.insert(line.rest.end(), lasts.front().begin(), lasts.front().end());
    if (!border) line.rest = work.trail.kept_off(line.rest);
    go_on(work, std::move(line.rest), may_step, options);
    for (std::size_t k = 1; k < lasts.size(); ++k) go_on(work, std::move(lasts[k]), false, options);
}

std::vector<Pass> wound(const std::vector<Ring>& rings, const Tree& tree, Work work, const Wish& wish,
                        const Options& options) {
    for (const auto& [chain, onward] : peel_of(rings, tree, wish.start)) {
        bool may_step = false;  // within a chain only: elsewhere raked sand may lie between
        for (std::size_t i = 0; i < chain.size();) {
            const std::optional<Point> here =
                work.passes.empty() ? wish.start : work.passes.back().line.back();
            if (!chain[i]->closed) {
                const Ring* next = i + 1 < chain.size() ? chain[i + 1] : onward;
                const Seam seam =
                    seams_of({chain[i]}, next, here, wish.exit, work.trail.lattice(), options).front();
                const bool spine = chain[i]->teeth.empty();
                for (Polyline& line : passes_along(*chain[i], seam, options))
                    go_on(work, spine ? work.trail.kept_off(line) : std::move(line), spine && may_step,
                          options);
                ++i;
            } else {
                const bool after_spine = may_step && !chain[i - 1]->closed && chain[i - 1]->teeth.empty();
                const Revolutions turns = revolutions(chain, i, here, onward, work.floor, options);
                i += turns.lanes.size();
                revolve(work, line_of(turns), after_spine, i == chain.size() && !onward, options);
            }
            may_step = true;
        }
    }
    for (Pass& pass : work.passes)
        pass.line = without_duplicates(rounded(pass.line, options.round_corners ? options.turn_radius : 0),
                                       least_edge * options.width);
    return work.passes;
}

}  // namespace

Passes spiral_passes(const Region& region, const std::string& place, const Options& options, Fill& account) {
    const Levels levels = levels_of(region, place, options, account);
    if (levels.room.empty()) return no_passes;
    std::vector<Ring> rings = rings_of(region, levels, options);
    Work work{Trail(lattice_of(region, rings, place, options, account), levels.room, options),
              AreaIndex(inset({region}, (0.5 - floor_margin) * options.width)),
              {}};
    Tree tree = tree_of(rings, work.trail.lattice());
    return [rings = std::move(rings), tree = std::move(tree), work = std::move(work),
            options](const Wish& wish) { return wound(rings, tree, work, wish, options); };
}

}  // namespace strandline::fill
