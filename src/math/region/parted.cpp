// What of a line lies in regions.
#include <algorithm>

#include "math/region/region.hpp"

namespace strandline {
namespace {

void for_rings(const Regions& regions, const auto& what) {
    for (const Region& region : regions) {
        what(region.outer);
        for (const Polygon& hole : region.holes) what(hole);
    }
}

/// The piece goes on where the last one ended, or begins a new part.
void extend(std::vector<Polyline>& parts, bool fresh, Point from, Point to) {
    if (fresh) parts.push_back({from});
    parts.back().push_back(to);
}

}  // namespace

LineParts parted(const Polyline& line, const Regions& regions) {
    LineParts parts;
    int last = -1;  // 1: the previous piece was inside, 0: outside, -1: none yet
    std::vector<double> shares;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point a = line[i - 1], b = line[i];
        if (a == b) continue;
        const Box reach = bounds({a, b});
        shares = {0, 1};
        for_rings(regions, [&](const Polygon& ring) {
            for (std::size_t k = 0, j = ring.size() - 1; k < ring.size(); j = k++) {
                const Point c = ring[j], d = ring[k];
                if (std::max(c.x, d.x) < reach.low.x || std::min(c.x, d.x) > reach.high.x ||
                    std::max(c.y, d.y) < reach.low.y || std::min(c.y, d.y) > reach.high.y)
                    continue;
                if (const auto hit = crossing(a, b, c, d)) shares.push_back(hit->s);
            }
        });
        std::ranges::sort(shares);
        for (std::size_t k = 1; k < shares.size(); ++k) {
            if (shares[k] <= shares[k - 1]) continue;
            const Point from = between(a, b, shares[k - 1]),
                        to = shares[k] == 1 ? b : between(a, b, shares[k]);
            const int inside = contains(regions, between(a, b, (shares[k - 1] + shares[k]) / 2)) ? 1 : 0;
            extend(inside ? parts.inside : parts.outside, inside != last, from, to);
            last = inside;
        }
    }
    return parts;
}

}  // namespace strandline
