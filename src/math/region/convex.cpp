// The fewest convex parts: Greene 1983, by CGAL. CGAL's own checks stay on in release builds: they are what
// turns an outline that touches itself into an Error instead of an endless loop.
#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <fmt/core.h>

#include <algorithm>
#include <list>

#include "math/region/region.hpp"

namespace strandline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Partition_traits_2<Kernel>;

constexpr std::size_t most_corners =
    120;                             // the method is O(n^4): 0.1 s at 100 corners, 2.2 s at 200, 57 s at 400
constexpr double area_slack = 1e-9;  // relative: parts that do not add up to this were not a partition

/// Without the corners at which the outline runs straight on or straight back: CGAL's partition is O(n^4) in
/// them.
Polygon plain(const Polygon& outline) {
    Polygon kept = without_duplicate_corners(counter_clockwise(outline));
    for (std::size_t i = 0; kept.size() >= 3 && i < kept.size();) {
        const std::size_t n = kept.size();
        const Point a = kept[(i + n - 1) % n], b = kept[i], c = kept[(i + 1) % n];
        if (CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y),
                              Kernel::Point_2(c.x, c.y)) == CGAL::COLLINEAR) {
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
            i -= std::min<std::size_t>(i, 1);
        } else {
            ++i;
        }
    }
    return kept;
}

}  // namespace

Outcome<std::vector<Polygon>> convex_parts(const Region& region) {
    if (!region.holes.empty())
        return fail("",
                    fmt::format("has {} holes; the optimal convex partition takes none", region.holes.size()),
                    "use the monotone partition");
    const Polygon outline = plain(region.outer);
    if (outline.size() < 3) return fail("", "has no area");
    if (outline.size() > most_corners)
        return fail("",
                    fmt::format("has {} corners; the optimal convex partition is too slow beyond {}",
                                outline.size(), most_corners),
                    "simplify it or use the monotone partition");
    std::vector<Kernel::Point_2> corners;
    for (Point p : outline) corners.emplace_back(p.x, p.y);
    if (!CGAL::is_simple_2(corners.begin(), corners.end(), Kernel()))
        return fail("", "crosses or touches itself", "use the monotone partition");
    std::list<Traits::Polygon_2> found;
    const auto before = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
    try {
        CGAL::optimal_convex_partition_2(corners.begin(), corners.end(), std::back_inserter(found), Traits());
    } catch (const std::exception&) {
        CGAL::set_error_behaviour(before);
        return fail("", "is too degenerate for the optimal convex partition", "use the monotone partition");
    }
    CGAL::set_error_behaviour(before);
    std::vector<Polygon> parts;
    double sum = 0;
    for (const Traits::Polygon_2& part : found) {
        Polygon polygon;
        for (auto corner = part.vertices_begin(); corner != part.vertices_end(); ++corner)
            polygon.push_back({corner->x(), corner->y()});
        sum += area(polygon);
        parts.push_back(std::move(polygon));
    }
    if (std::abs(sum - area(outline)) > area_slack * area(outline))
        return fail("", "is too degenerate for the optimal convex partition", "use the monotone partition");
    return parts;
}

}  // namespace strandline
