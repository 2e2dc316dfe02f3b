#pragma once
// Areas: boolean operations, insets, simplifying, and cutting into parts. Built on
// Clipper 6.4 (an integer grid fitted to the bounding box: about 1e-9 of the extent) and CGAL (optimal convex
// parts). Metres.
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/curve/curve.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline {

using Regions = std::vector<Region>;  ///< disjoint interiors; outers counter-clockwise, holes clockwise

enum class FillRule { nonzero, even_odd };

/// The areas that a set of closed outlines bounds under a fill rule; self-crossings resolved, slivers under
/// the grid dropped, duplicate and collinear points removed. O(n log n) typical.
Regions resolved(const std::vector<Polygon>& outlines, FillRule rule);

/// The same within `area`, at the cost of one operation.
Regions resolved_within(const std::vector<Polygon>& outlines, FillRule rule, const Regions& area);

Regions united(const Regions& a, const Regions& b);
Regions intersected(const Regions& a, const Regions& b);
Regions subtracted(const Regions& from, const Regions& what);
double area(const Regions& regions);
Box bounds(const Regions& regions);
bool contains(const Regions& regions, Point p);
/// A point well inside: the middle of the widest part of a level line. Error-free for a positive area. O(n).
Point point_inside(const Region& region);

/// Every point of the result is at least `by` from the outside: Euclidean, so reflex corners come out as arcs
/// (chord error `arc_tolerance`, metres; 0: by/500). `by` < 0 grows with round corners. `arc_tolerance` is
/// capped at |by|/4.
Regions inset(const Regions& regions, double by, double arc_tolerance = 0);
/// Mitred insets by each of the distances, all above 0, from one straight skeleton (CGAL): every edge moves
/// in parallel, so reflex corners run out to points. Holes are served. At most 1,000 corners and simple
/// outlines: else an Error that says which. About O(n^2).
Outcome<std::vector<Regions>> skeleton_insets(const Region& region, const std::vector<double>& distances);
/// Outline moves at most `tolerance`; a part that vanishes is dropped (area below tolerance^2).
Regions simplified(const Regions& regions, double tolerance);
/// The area within `radius` of an open or closed chain: what a round pen of that radius leaves. Round joins
/// and caps, or flat caps.
enum class Cap { round, flat, square };
Regions swept(const std::vector<Polyline>& lines, bool closed, double radius, Cap cap = Cap::round);
/// The parts of a polyline inside and outside the regions, in order along the line.
struct LineParts {
    std::vector<Polyline> inside, outside;
};
LineParts parted(const Polyline& line, const Regions& regions);

/// The same of an exact path: its pieces stay exact, in order along it. A closed path that is wholly on one
/// side stays closed; one that crosses gives open pieces, the one over its start in one.
struct PathParts {
    std::vector<Path> inside, outside;
};
/// Answers many questions about one area: its edges in level bands. Built in O(edges x bands met), about
/// 2 sqrt(edges) bands; a question reads only the bands it meets. Const after construction.
class AreaIndex {
  public:
    explicit AreaIndex(const Regions& regions);
    /// Even-odd; points exactly on the outline may go either way.
    bool contains(Point p) const;
    enum class Cover { inside, outside, crossed };
    /// Does the area hold the whole box, nothing of it, or does an outline come into it?
    Cover cover_of(Box box) const;
    /// Crossings are sought on chords within `tolerance` of the path, then placed on the path itself to
    /// rounding: a bulge over an edge by less than the tolerance may be missed.
    PathParts parted(const Path& path, double tolerance) const;
    const Box& bounds() const { return box_; }

  private:
    struct Edge {
        Point a, b;
    };
    std::size_t band_of(double y) const;
    Box box_;
    double band_height_ = 0;
    std::vector<Edge> edges_;
    std::vector<std::size_t> band_starts_, band_edges_;  ///< edges of band i: band_edges_[starts[i]..[i + 1])
};

/// The middle lines of an area: the centres of the discs that touch its outline twice or more (Blum 1967), as
/// a graph. It reaches into every convex corner.
struct MedialAxis {
    struct Node {
        Point at;
        double radius = 0;  ///< metres to the outline
    };
    struct Edge {
        int from = 0, to = 0;
    };
    std::vector<Node> nodes;
    std::vector<Edge> edges;
};
/// From the Voronoi diagram of the edges. Curved pieces become chords of at most `step` metres. O(n log n).
MedialAxis medial_axis(const Region& region, double step);
/// Of that, what comes into one of the boxes: right where discs reach at most `reach` beyond their box. From
/// the edges that are so near.
MedialAxis medial_axis(const Region& region, double step, const std::vector<Box>& near, double reach);

/// Where closed outlines touch or cross themselves (a == b), or each other: crossings, corners that lie on
/// another edge, edges on edges, and corners at which an outline turns back on itself. One place for contacts
/// within `tolerance` of each other; at most `most` for a pair. Outlines come without repeated points. A
/// sweep over x: O(n log n + pairs of edges that overlap in x).
struct Contact {
    std::size_t a = 0, b = 0;  ///< outlines, a <= b
    Point at;
    bool operator==(const Contact&) const = default;
};
std::vector<Contact> contacts(const std::vector<Polygon>& outlines, double tolerance, int most = 20);

/// Cut by a straight line through two points: parts on its left, then on its right.
struct Halves {
    Regions left, right;
};
Halves cut(const Regions& regions, Point a, Point b);

/// Parts in each of which every line of direction `direction` (radians) meets the area in one piece (for
/// hatching along `direction`). Boustrophedon sweep (Choset 2000) over vertices; holes are served. Parts tile
/// the region. O(n^2) worst.
std::vector<Polygon> monotone_parts(const Region& region, double direction);
/// The fewest convex parts without new vertices: Greene 1983, by CGAL. Hole-free, simple, at most 120
/// vertices: else an Error that says which.
Outcome<std::vector<Polygon>> convex_parts(const Region& region);

}  // namespace strandline
