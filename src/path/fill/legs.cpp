// The middle lines of an area as they look from afar, and parted at their bends.
#include <algorithm>

#include "path/fill/axis.hpp"

namespace strandline::fill {
namespace {

constexpr double bend_tolerance = 0.5;  // of the width: corners of a path as it looks from afar
constexpr double least_bend = 0.6;      // rad

/// Where a path turns, as it looks from afar; not at its ends.
std::vector<std::size_t> bends_of(const AxisPath& path, double width) {
    Polyline line = path.line;
    if (path.closed) line.push_back(line.front());
    const std::vector<std::size_t> kept = strandline::thinned(line, bend_tolerance * width);
    std::vector<std::size_t> bends;
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
        const Point in = line[kept[k]] - line[kept[k - 1]], out = line[kept[k + 1]] - line[kept[k]];
        if (std::abs(std::atan2(cross(in, out), dot(in, out))) > least_bend) bends.push_back(kept[k]);
    }
    return bends;
}

}  // namespace

std::vector<AxisPath> straightened(const std::vector<AxisPath>& paths, const Options& options) {
    std::vector<AxisPath> straight;
    for (const AxisPath& path : paths) {
        AxisPath& plain = straight.emplace_back();
        plain.closed = path.closed;
        for (const std::size_t i : strandline::thinned(path.line, bend_tolerance * options.width)) {
            plain.line.push_back(path.line[i]);
            plain.radius.push_back(path.radius[i]);
        }
    }
    return straight;
}

std::vector<AxisPath> parted_at_bends(const std::vector<AxisPath>& paths, const Options& options) {
    const double w = options.width;
    std::vector<AxisPath> legs;
    for (AxisPath path : paths) {
        std::vector<std::size_t> bends = bends_of(path, w);
        if (path.closed && !bends.empty()) {  // a loop begins at a bend
            const auto first = static_cast<std::ptrdiff_t>(bends.front());
            std::rotate(path.line.begin(), path.line.begin() + first, path.line.end());
            std::rotate(path.radius.begin(), path.radius.begin() + first, path.radius.end());
            bends = bends_of(path, w);
        }
        bends.insert(bends.begin(), 0);
        Polyline line = path.line;
        std::vector<double> radius = path.radius;
        if (path.closed) line.push_back(line.front()), radius.push_back(radius.front());
        bends.push_back(line.size() - 1);
        if (bends.size() == 2) {
            legs.push_back(path);
            continue;
        }
        for (std::size_t k = 1; k < bends.size(); ++k) {
            const auto from = static_cast<std::ptrdiff_t>(bends[k - 1]),
                       to = static_cast<std::ptrdiff_t>(bends[k] + 1);
            legs.push_back({{line.begin() + from, line.begin() + to},
                            {radius.begin() + from, radius.begin() + to},
                            false});
        }
    }
    std::ranges::stable_sort(legs, std::greater{}, [](const AxisPath& leg) { return length(leg.line); });
    return legs;
}

}  // namespace strandline::fill
