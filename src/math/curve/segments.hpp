#pragma once
// Private to this room: a segment as a function of t in 0..1 from the point where the one before it ends.
#include "math/curve/curve.hpp"

namespace strandline::segments {

/// Position, first and second derivative by t.
struct Jet {
    Point at, velocity, acceleration;
};
Jet jet(Point from, const Segment& segment, double t);
Point point(Point from, const Segment& segment, double t);
/// Arc length from t0 to t1, to about 1e-10 relative.
double length(Point from, const Segment& segment, double t0 = 0, double t1 = 1);
/// The part from t0 to t1, and where it starts.
struct Part {
    Point start;
    Segment segment;
};
Part part(Point from, const Segment& segment, double t0, double t1);
/// An upper bound of |P''| over the whole segment.
double acceleration_bound(Point from, const Segment& segment);

}  // namespace strandline::segments
