#pragma once
// Areas to test with.
#include <random>

#include "math/region/region.hpp"

namespace strandline::shapes {

inline double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
inline Polygon square(Point low, double side) {
    return {low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}};
}
/// Corners at random distances around a centre: simple, often concave.
inline Polygon blob(std::mt19937_64& random, Point centre, double radius, int corners) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i)
        polygon.push_back(centre + uniform(random, 0.35, 1) * radius * unit(2 * pi * i / corners));
    return polygon;
}
inline Regions random_regions(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Regions regions = resolved({blob(random, {uniform(random, -9, 9), 3}, 5, 23)}, FillRule::nonzero);
    for (int i = 0; i < 4; ++i) {
        const Point at = bounds(regions).low + Point{uniform(random, 0, 9), uniform(random, 0, 9)};
        const Regions more =
            resolved({blob(random, at, uniform(random, 0.5, 2.5), 7 + i)}, FillRule::nonzero);
        regions = i % 2 ? united(regions, more) : subtracted(regions, more);
    }
    return regions;
}
inline Polygon moved(Polygon polygon, const Affine& map) {
    for (Point& p : polygon) p = apply(map, p);
    return determinant(map) < 0 ? reversed(polygon) : polygon;
}
inline Regions moved(Regions regions, const Affine& map) {
    for (Region& region : regions) {
        region.outer = moved(region.outer, map);
        for (Polygon& hole : region.holes) hole = moved(hole, map);
    }
    return regions;
}
inline const Affine turned{0.8, 0.6, -0.6, 0.8, 3, -2};
inline const Affine mirrored{-1, 0, 0, 1, 5, 0};

}  // namespace strandline::shapes
