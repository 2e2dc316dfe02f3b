#pragma once
// Private to this room: a path cut into spans, each smooth inside, with the headings it is to be fitted with.
#include <optional>
#include <vector>

#include "math/curve/curve.hpp"
#include "math/curve/segments.hpp"

namespace strandline::fit {

/// P(t) for t in [t0, t1] of one segment. heading0/1: the path's own one-sided tangents at first; where two
/// spans meet smoothly the shared heading is put in their place.
struct Span {
    Point from;       ///< where the segment starts
    Segment segment;  ///< handles too short to have a direction are drawn in
    double t0, t1;
    Point p0, p1;
    double heading0, heading1;
    double curvature;  ///< of a line or circular arc
    bool exact;        ///< a line or a circular arc
    bool line;
};

/// The path's spans: cut where it has a cusp, without those that have no length.
std::vector<Span> spans(const Path& path, double tolerance);

}  // namespace strandline::fit
