#pragma once
// Areas to fill, and what a fill leaves: judged by booleans on the swept sand, apart from the code that
// planned it.
#include "path/fill/fill.hpp"
#include "region/shapes.hpp"

namespace strandline::areas {

inline Region of(const std::vector<Polygon>& outlines) {
    return resolved(outlines, FillRule::even_odd).at(0);
}
inline Region square() { return of({shapes::square({0, 0}, 6)}); }
inline Region letter_l() { return of({{{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 6}, {0, 6}}}); }
inline Region ring() { return of({shapes::square({0, 0}, 8), shapes::square({3, 3}, 2.5)}); }
inline Region two_holes() {
    return of({shapes::square({0, 0}, 10), shapes::square({1.5, 2}, 2), {{6, 5}, {8.5, 6}, {6, 8}}});
}
inline std::vector<Region> all() { return {square(), letter_l(), ring(), two_holes()}; }

/// The rake of these tests: 0.4 m wide, passes side by side.
inline fill::Options with(fill::Style style) { return {.style = style, .width = 0.4, .spacing = 0.4}; }

inline Polyline line_of(const Stroke& stroke) {
    Polyline line;
    for (const Curve& curve : stroke.rake_path)
        for (const CurvePoint& p : sampled(curve, 0.02)) line.push_back(p.pose.at);
    return without_duplicates(line, 1e-9);
}

struct Account {
    double coverage = 0, spill = 0;  ///< shares of the area
};
inline Account judged(const Region& region, const fill::Fill& fill, double width) {
    Regions raked;
    for (const Stroke& stroke : fill.strokes)
        raked = united(raked, swept({line_of(stroke)}, false, width / 2, Cap::flat));
    const double whole = area(region);
    return {area(intersected(raked, {region})) / whole, area(subtracted(raked, {region})) / whole};
}

}  // namespace strandline::areas
