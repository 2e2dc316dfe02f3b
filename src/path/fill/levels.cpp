// The insets whose outlines are rings.
#include <algorithm>

#include "path/fill/passes.hpp"

namespace strandline::fill {
namespace {

constexpr double sand_arcs = 200, centre_arcs = 100;  // of the width: chord errors

/// The parts that lie in the whole.
Regions parts_in(const Regions& whole, const Regions& parts) {
    Regions found;
    for (const Region& part : parts)
        if (contains(whole, point_inside(part))) found.push_back(part);
    return found;
}

}  // namespace

Levels levels_of(const Region& region, const std::string& place, const Options& options, Fill& account) {
    Levels levels{room_for_centre(region, place, options, account), {}, {}};
    if (options.insets == Insets::offset || levels.room.empty()) return levels;
    const Box box = bounds(region);
    std::vector<double> distances;
    for (double by = options.width / 2; by < std::min(box.width(), box.height()) / 2; by += options.spacing) {
        distances.push_back(by);
        distances.push_back(by + options.spacing - options.width / 2);
    }
    auto mitred = skeleton_insets(region, distances);
    if (!mitred) {
        ++account.skeletons_replaced;
        account.warnings.push_back({place, mitred.error().reason + ": Euclidean insets are used"});
        return levels;
    }
    levels.sand.push_back({region});
    for (std::size_t i = 0; i < mitred->size(); ++i)
        (i % 2 == 0 ? levels.centre : levels.sand).push_back(std::move((*mitred)[i]));
    // A mitred inset lies in the Euclidean one: what that has dropped is dropped here too.
    levels.centre[0] = parts_in(levels.room, levels.centre[0]);
    levels.room = levels.centre[0];
    return levels;
}

Regions sand_within(const Levels& levels, const Regions& centre, int level, const Options& options) {
    if (levels.sand.empty())
        return inset(centre, options.spacing - options.width / 2, options.width / sand_arcs);
    const auto next = static_cast<std::size_t>(level) + 1;
    return next < levels.sand.size() ? parts_in(centre, levels.sand[next]) : Regions{};
}

Regions centre_of(const Levels& levels, const Region& sand, int level, const Options& options) {
    if (levels.sand.empty()) return inset({sand}, options.width / 2, options.width / centre_arcs);
    const auto here = static_cast<std::size_t>(level);
    return here < levels.centre.size() ? parts_in({sand}, levels.centre[here]) : Regions{};
}

}  // namespace strandline::fill
