// Spirals, inside to outside: one line over all rings that have a seam in common.
// Branches of the nest and rings round holes are spirals of their own, raked before what they lead on to.
#include <algorithm>
#include <utility>

#include "path/fill/peel.hpp"
#include "path/fill/revolve.hpp"

namespace strandline::fill {
namespace {

constexpr double longest_step = 1.5;  // of the spacing: from or to a spine's end, raked

/// The passes of one area as they come, and the sand they have raked.
struct Work {
    Lattice lattice;
    std::vector<Pass> passes;
};

/// Goes on with a line: raked from where the rake is when that is a step to or from a spine, else rake up.
void go_on(Work& work, Polyline line, bool may_step, const Options& options) {
    if (line.size() < 2) return;
    Polyline reach;
    if (!work.passes.empty()) {
        Polyline& last = work.passes.back().line;
        const double gap = distance(last.back(), line.front());
        if (may_step && gap < longest_step * options.spacing) {
            rake(work.lattice, {last.back(), line.front()}, options);
            rake(work.lattice, line, options);
            last.insert(last.end(), line.begin(), line.end());
            return;
        }
        if (gap > options.width) reach = way(work.lattice, last.back(), line.front());
    }
    rake(work.lattice, line, options);
    work.passes.push_back({std::move(reach), std::move(line)});
}

/// The spine from the end that is nearer to `here`, or that is farther from where it goes on.
Polyline along_spine(const Ring& spine, std::optional<Point> here, const Ring* next) {
    const auto away = [&](Point p) {
        return (here ? distance(*here, p) : 0) - (next ? nearest(*next, p).distance : 0);
    };
    return away(spine.line.back()) < away(spine.line.front()) ? reversed(spine.line) : spine.line;
}

}  // namespace

std::vector<Pass> spiral_passes(const Region& region, const std::string& place, const Options& options,
                                Fill& account) {
    const Regions room = room_for_centre(region, place, options, account);
    if (room.empty()) return {};
    const std::vector<Ring> rings = rings_of(room, options);
    Work work{lattice_of(region, rings, options), {}};
    for (const auto& [chain, onward] : peel_of(rings, work.lattice)) {
        bool may_step = false;  // within a chain only: elsewhere raked sand may lie between
        for (std::size_t i = 0; i < chain.size();) {
            std::optional<Point> here;
            if (!work.passes.empty()) here = work.passes.back().line.back();
            if (!chain[i]->closed) {
                const Ring* next = i + 1 < chain.size() ? chain[i + 1] : onward;
                go_on(work, along_spine(*chain[i], may_step ? here : std::nullopt, next), may_step, options);
                ++i;
            } else {
                const Revolutions turns = revolutions(chain, i, here, onward, options);
                go_on(work, line_of(turns), may_step && i > 0 && !chain[i - 1]->closed, options);
                i += turns.tracks.size();
            }
            may_step = true;
        }
    }
    for (Pass& pass : work.passes)
        pass.line = without_duplicates(
            rounded(pass.line, options.round_corners ? options.turn_radius : 0), 1e-9 * options.width);
    return work.passes;
}

}  // namespace strandline::fill
