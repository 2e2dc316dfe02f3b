#pragma once
// What a fill leaves: judged by booleans on the swept sand, apart from the code that planned it.
#include "path/fill/fill.hpp"
#include "region/areas.hpp"

namespace strandline::areas {

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
