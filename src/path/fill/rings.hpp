#pragma once
// Private to the room: rings (nested insets) and spines, which is next to which, and in what order they are
// raked.
#include "path/fill/passes.hpp"

namespace strandline::fill {

/// A closed ring at distance width/2 + level x spacing from the outline; or what serves a place too narrow
/// for one: an open spine along it, or a comb of teeth across it.
struct Ring {
    Polyline line;  // closed: first point not repeated; of a comb, its spine
    int level = 0;
    bool closed = true;
    double length = 0;
    Box box;
    std::vector<double> arcs;          // arc length at each point
    std::vector<Polyline> teeth = {};  // of a comb, in order along its spine, side by side
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

/// All rings, spines and combs of an area, by its insets: outermost first. Where insets
/// leave less than about two widths between them, rings, a spine, a comb and nothing are tried on a raster,
/// and what leaves least bare and rakes least twice is taken.
std::vector<Ring> rings_of(const Region& region, const Levels& levels, const Options& options);

}  // namespace strandline::fill
