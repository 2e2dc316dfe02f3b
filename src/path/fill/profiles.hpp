#pragma once
// Private to the room: how much of level bands lies in an area.
// Key: a band is what lies between two heights; its profile is the height of it that lies in the area, as a
// function of x: piecewise linear.
#include <vector>

#include "math/region/region.hpp"

namespace strandline::fill {

/// Evenly spaced bands; band i begins at low + i x pitch.
struct Bands {
    double low, pitch, height;
    int count;
};
/// A piece of an edge within a band.
struct Portion {
    Point a, b;
    bool opens;  ///< the area is on its right
};
using Portions = std::vector<std::vector<Portion>>;  // by band

/// The pieces of the outlines in each band. O(edges + pieces).
Portions portions_of(const Regions& regions, const Bands& bands);

/// A corner of a profile. Steps are two at one x.
struct Knot {
    double x, height;
};
/// O(portions log portions).
std::vector<Knot> profile_of(const std::vector<Portion>& portions);

struct Interval {
    double from, to;
};
/// Where a profile is at least `height`.
std::vector<Interval> above(const std::vector<Knot>& profile, double height);
double integral(const std::vector<Knot>& profile, double from, double to);
double highest(const std::vector<Knot>& profile, const Interval& within);

/// How far an edge near x at the heights y -+ h/4 leans over a unit of height; 0 where there is none nearby.
double slant_at(const std::vector<Portion>& portions, double x, double y, double h);

}  // namespace strandline::fill
