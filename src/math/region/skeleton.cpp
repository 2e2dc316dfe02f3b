// Mitred insets from the straight skeleton (Aichholzer et al., J. UCS 1995), by CGAL. CGAL's own checks stay
// on in release builds: they are what turns a degenerate outline into an Error.
#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/create_offset_polygons_2.h>
#include <CGAL/create_straight_skeleton_2.h>
#include <fmt/core.h>

#include <algorithm>

#include "math/region/region.hpp"

namespace strandline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Outline = CGAL::Polygon_2<Kernel>;

constexpr std::size_t most_corners = 1000;  // near O(n^2): see docs/region.md

Outline outline_of(const Polygon& ring) {
    Outline outline;
    for (Point p : without_duplicate_corners(ring)) outline.push_back({p.x, p.y});
    return outline;
}

}  // namespace

Outcome<std::vector<Regions>> skeleton_insets(const Region& region, const std::vector<double>& distances) {
    std::size_t corners = region.outer.size();
    for (const Polygon& hole : region.holes) corners += hole.size();
    if (corners > most_corners)
        return fail(
            "",
            fmt::format("has {} corners; the straight skeleton is too slow beyond {}", corners, most_corners),
            "simplify it or use Euclidean insets");
    if (std::ranges::any_of(distances, [](double by) { return !(by > 0); }))
        return fail("", "insets need a distance above 0");
    const auto before = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
    const auto degenerate = [&] {
        CGAL::set_error_behaviour(before);
        return fail("", "is too degenerate for a straight skeleton", "use Euclidean insets");
    };
    std::vector<Regions> levels;
    try {
        const Outline outer = outline_of(region.outer);
        std::vector<Outline> holes;
        bool simple = outer.is_simple();
        for (const Polygon& hole : region.holes) {
            holes.push_back(outline_of(hole));
            simple = simple && holes.back().is_simple();
        }
        if (!simple) return degenerate();
        const auto skeleton = CGAL::create_interior_straight_skeleton_2(
            outer.vertices_begin(), outer.vertices_end(), holes.begin(), holes.end(), Kernel());
        if (!skeleton) return degenerate();
        for (double by : distances) {
            std::vector<Polygon> outlines;
            for (const auto& ring : CGAL::create_offset_polygons_2<Outline>(by, *skeleton, Kernel())) {
                Polygon polygon;
                for (const auto& corner : ring->container()) polygon.push_back({corner.x(), corner.y()});
                outlines.push_back(std::move(polygon));
            }
            levels.push_back(resolved(outlines, FillRule::even_odd));
        }
    } catch (const std::exception&) {
        return degenerate();
    }
    CGAL::set_error_behaviour(before);
    return levels;
}

}  // namespace strandline
