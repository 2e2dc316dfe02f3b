// What lies inside what: lines in regions, outlines in outlines.
#include <algorithm>
#include <numeric>

#include "math/region/region.hpp"

namespace strandline {
namespace {

constexpr double touching = 1e-7;  // of the extent: a hundred grid steps; outlines nearer than that touch

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

bool encloses(const Polygon& outer, const Polygon& inner, double tolerance) {
    for (Point p : inner)
        if (!contains(outer, p) && distance_to_outline(outer, p) > tolerance) return false;
    // All corners lie inside; an edge may still leave through a bay of the outer one.
    const double outside =
        area(subtracted(resolved({inner}, FillRule::even_odd), resolved({outer}, FillRule::even_odd)));
    return outside <= tolerance * perimeter(inner);
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

std::vector<int> nesting(const std::vector<Polygon>& outlines) {
    const std::size_t n = outlines.size();
    std::vector<double> areas(n);
    std::vector<Box> boxes(n);
    for (std::size_t i = 0; i < n; ++i) areas[i] = area(outlines[i]), boxes[i] = bounds(outlines[i]);
    std::vector<std::size_t> by_area(n);  // smallest first; of equal ones the later first
    std::iota(by_area.begin(), by_area.end(), std::size_t{0});
    std::ranges::sort(by_area, [&](std::size_t i, std::size_t j) {
        return areas[i] != areas[j] ? areas[i] < areas[j] : i > j;
    });

    std::vector<int> parent(n, -1);
    for (std::size_t i = 0; i < n; ++i) {
        const double tolerance = touching * std::max(boxes[i].width(), boxes[i].height());
        const double slack = tolerance * perimeter(outlines[i]);
        for (std::size_t j : by_area) {
            if (j == i || areas[j] < areas[i] - slack) continue;
            if (!contains(grown(boxes[j], tolerance), boxes[i].low) ||
                !contains(grown(boxes[j], tolerance), boxes[i].high))
                continue;
            if (!encloses(outlines[j], outlines[i], tolerance)) continue;
            const bool equal = areas[j] <= areas[i] + slack && encloses(outlines[i], outlines[j], tolerance);
            if (equal && j > i) continue;
            parent[i] = static_cast<int>(j);
            break;
        }
    }
    return parent;
}

}  // namespace strandline
