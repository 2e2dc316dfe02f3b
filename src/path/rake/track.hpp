#pragma once
// Private to the room: a stroke as chords that know their place along it, and a rake's lowered pins as bars.
#include "math/raster/raster.hpp"
#include "path/rake/rake.hpp"

namespace strandline::rake {

/// Chords of a rake path; `arcs`: each point's arc length on the path itself.
struct Track {
    Polyline line;
    std::vector<double> arcs;
};
Track track_of(const std::vector<Curve>& curves, double tolerance);
/// Between two arc lengths; a single point where they are one place.
Polyline part_of(const Track& track, double from, double to);

/// Neighbouring pins that are down, as one bar: how far it reaches to the left and to the right of the path,
/// metres; one of them may be negative.
struct Bar {
    double left = 0, right = 0;
};
/// A bar half way through a step of a drive.
struct Middle {
    Point at, left;  ///< and which way its left end is
};
std::vector<Bar> bars_of(unsigned mask, int pins, double width);
/// Whether a path that looks along one unit vector and then another has a corner there.
bool turns(Point before, Point after);
/// What a bar sweeps that turns there, on the outer side of the corner; `outer` <= `inner`: nothing.
Wedge wedge_of(Point at, Point before, Point after, double left, double right);

}  // namespace strandline::rake
