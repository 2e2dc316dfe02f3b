#pragma once
// Areas to rake.
#include "math/region/region.hpp"
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

}  // namespace strandline::areas
