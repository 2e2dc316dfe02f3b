#pragma once
// A drivable way round ground that must not be driven over. Knows no order and no strokes.
#include <cstddef>
#include <span>
#include <vector>

#include "math/curve/curve.hpp"
#include "math/geometry/geometry.hpp"
#include "math/region/region.hpp"

namespace strandline::route {

/// A corner of an outline that a taut string may bend at.
struct Corner {
    Point at;
    Point before, after;  ///< unit normals of the two edges, out of the obstacle; `after` is left of `before`
};

/// A straight part of a string from one corner, turned round to one side, to another. Corner k turned round
/// to the right is node 2 k, to the left 2 k + 1.
struct Link {
    int node;  ///< where it leads
    Point from, to;
    double heading, length;
    enum { unknown, clear, blocked } state = unknown;
};

struct GroundOptions {
    double clearance = 0.35;  ///< metres that the turning point keeps from every obstacle, 0 and above
    double radius = 0.5;      ///< metres: the robot's least one; grids, margins and steps are shares of it
};

/// Obstacles: finished areas, keep-outs, and what lies outside the fields. Built once and added to. Links are
/// found when they are first asked for, and looked at again after something was added near them: so one
/// ground is not for several threads at once.
class Ground {
  public:
    explicit Ground(GroundOptions options);

    /// Not to be driven over. O(its outline x (clearance + 0.5 m)^2 in cells).
    void add(const Region& obstacle);
    void add(const Regions& obstacles);
    /// Not to be left. Several fields: their intersection.
    void add_field(const Region& field);

    /// Whether the point keeps the clearance.
    bool clear(Point p) const;
    /// Whether every point of the curve keeps the clearance: proved by steps no longer than the room there.
    bool clear(const Curve& curve) const;
    /// The same of a straight part from a point that does.
    bool clear(Point from, Point to) const;
    /// How far along the curve that is so.
    double clear_length(const Curve& curve) const;
    /// Metres of the curve that do not keep the clearance, to 1 cm a place.
    double blemish(const Curve& curve) const;
    /// The same of a straight part, to 5 cm.
    double blemish(Point from, Point to) const;

    double clearance() const { return options_.clearance; }
    /// How far from corners strings are drawn, so that they are clear for certain.
    double string_offset() const;
    std::span<const Corner> corners() const { return corners_; }
    /// All of a node, clear or not. O(corners) the first time.
    std::span<const Link> links(int node) const;
    /// Whether a node's link keeps the clearance; looked up once.
    bool link_clear(int node, std::size_t index) const;

  private:
    struct Edge {
        Point a, b;
    };
    struct Cell {
        double distance;         ///< from its middle to the nearest edge, up to reach()
        std::vector<int> edges;  ///< all that come near enough to matter to a point of the cell
    };
    struct Links {
        std::size_t corners = 0, added = 0;  ///< how many of them the list knows
        std::vector<Link> list;
    };
    double room_at(Point p) const;
    bool forbidden(Point p) const;
    double reach() const;
    double share(double of_radius) const { return of_radius * options_.radius; }
    double exact_within() const;
    void add_ring(const Polygon& ring);
    /// A region's rings, with what may not be driven over inside it or all round it.
    void add_outline(const Region& region, bool obstacle_inside);
    void add_links(int node, std::size_t first_corner, std::vector<Link>& list) const;
    void grow_to(Box box);
    void lay_cells(Box box);
    void list_edge(std::size_t number);
    std::size_t cell_of(Point p) const;
    Point middle_of(std::size_t cell) const;
    template <class At>
    double traced_length(double length, At&& at) const;
    template <class At>
    double traced_blemish(double length, double least_step, At&& at) const;

    GroundOptions options_;
    Box box_;  ///< of the cells
    double cell_size_;
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<Cell> cells_;
    std::vector<Edge> edges_;
    std::vector<Corner> corners_;
    Regions obstacles_, fields_;
    std::vector<Box> boxes_;  ///< of the obstacles
    std::vector<Box> added_;  ///< what came near with each of them
    mutable std::vector<Links> links_;
};

struct Options {
    CurveLimits limits{};  ///< radius above 0
    /// What a metre that does not keep the clearance costs, in metres of way.
    double blemish_weight = 20;
};
/// G2 and within the limits always.
struct Way {
    Curve curve;
    /// Metres that do not keep the clearance; 0: proved clear. Above 0: no way was found; this is the least
    /// bad of those tried, by length + blemish_weight x blemish.
    double blemish = 0;
    /// The poses between the corners that the way bends round, in order: what an edit may hold on to.
    std::vector<Pose> through = {};
};
/// From state to state round the obstacles. Taut strings over the corners (tangents between oriented circles,
/// found lazily by A*; Pocchiola and Vegter, The visibility complex, 1996, have the graph), then driven: a
/// continuous-curvature turn at each corner, placed so that it just keeps the clearance, and
/// continuous_curvature at both ends. What cannot be driven is left out of the graph and the next string
/// tried; then detours at the ends. Ends within obstacles or too near to them give a blemish. Some 0.5 ms
/// where there is a way; docs/route.md has the times.
Way way(const Ground& ground, const CurvatureState& from, const CurvatureState& to, const Options& options);

/// Length of the shortest string from point to point at the string's offset from the corners, whatever the
/// headings: a bound to measure ways by. Infinite where there is none.
double taut_length(const Ground& ground, Point from, Point to);

}  // namespace strandline::route
