#pragma once
// Private to the room: a smooth curve through measured points of a rake path, its corners kept.
#include <vector>

#include "math/curve/curve.hpp"

namespace strandline::stages {

struct PointsCurve {
    std::vector<Curve>
        curves;             ///< smooth ones end to end, corners between them; empty when all points are one
    std::vector<double> s;  ///< arc length of each point
};
/// Through every point (to 1e-9 m); exact on straight lines and circular arcs, where they meet too, once each
/// has three points. A point is a corner where the tangents from its two sides differ. O(n).
PointsCurve curve_through(const std::vector<Point>& points);

}  // namespace strandline::stages
