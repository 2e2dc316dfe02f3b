#pragma once
// Private to the room: rings (nested insets) and spines, which is next to which, and in what order they are
// raked.
#include "path/fill/passes.hpp"

namespace strandline::fill {

/// A closed ring at distance width/2 + level x spacing from the outline, or an open spine in a ridge gap.
struct Ring {
    Polyline line;  // closed: first point not repeated
    int level = 0;
    bool closed = true;
    double length = 0;
    Box box;
    std::vector<double> arcs;  // arc length at each point
};
Ring ring_of(Polyline line, int level, bool closed);
struct Foot {
    double s = 0;
    Point at;
    double distance = std::numeric_limits<double>::infinity();
};
Foot nearest(const Ring& ring, Point p);
Point at(const Ring& ring, double s);
/// From arc length `from` over `span`, backwards when negative; wraps on closed rings, stops at a spine's
/// ends.
Polyline along(const Ring& ring, double from, double span);

/// All rings and spines of an area, given as room_for_centre gives it.
std::vector<Ring> rings_of(const Regions& room, const Options& options);

}  // namespace strandline::fill
