#pragma once
// Exact paths (lines, elliptic arcs, cubic Beziers) as drawings hold them, and clothoid curves as robots
// drive them; fitting the first by the second; Dubins and continuous-curvature curves between poses, with and
// without backing up. Metres,
// radians, counter-clockwise; curvature in 1/m, positive to the left; sharpness = d curvature / d s in 1/m^2.
#include <optional>
#include <variant>
#include <vector>

#include "math/geometry/geometry.hpp"

namespace strandline {

// ---- exact paths

struct LineSegment {
    Point to;
    bool operator==(const LineSegment&) const = default;
};
struct CubicSegment {
    Point control1, control2, to;
    bool operator==(const CubicSegment&) const = default;
};
/// P(t) = center + cos(t) u + sin(t) v for t from `start` to `start + sweep`. u and v need not be
/// perpendicular, so any affine image of an elliptic arc is one. `to` = P(start + sweep).
struct ArcSegment {
    Point center, u, v;
    double start, sweep;
    Point to;
    bool operator==(const ArcSegment&) const = default;
};
using Segment = std::variant<LineSegment, CubicSegment, ArcSegment>;

/// One subpath. A closed path ends where it starts: its last segment's `to` equals `start` (a closing line is
/// written out when the last point was elsewhere; it may be absent when there is no gap).
struct Path {
    Point start;
    std::vector<Segment> segments;
    bool closed = false;
    bool operator==(const Path&) const = default;
};

Point end_of(const Segment& segment);
Point end_of(const Path& path);
/// Exact for every segment kind.
Path transformed(const Path& path, const Affine& map);
Path reversed(const Path& path);
/// A path through the points by straight lines.
Path path_through(const std::vector<Point>& points, bool closed);
/// Chords that leave the path by at most `tolerance` (metres, > 0). For a closed path the first point is not
/// repeated at the end. At most about 1e6 points; Bezier and arc counts follow from their second derivative.
std::vector<Point> flattened(const Path& path, double tolerance);
/// By quadrature of |P'|, to about 1e-9 relative.
double length(const Path& path);
/// Exact bounding box (extrema of each segment).
Box bounds(const Path& path);

/// A place on a path is a number: i + t is t in 0..1 along segment i.
Point point_at(const Path& path, double place);
/// The places at these arc lengths, which are sorted; clamped to the ends. About 1e-9 of the segment's
/// length.
std::vector<double> places_at(const Path& path, const std::vector<double>& arc_lengths);
/// The path cut at sorted places, exactly: lines, arcs and cubics stay what they are. One more open path than
/// places, without segments where two places agree. O(segments + places).
std::vector<Path> split(const Path& path, const std::vector<double>& places);

// ---- clothoid curves

/// Where something is and where it looks.
struct Pose {
    Point at;
    double heading = 0;
    bool operator==(const Pose&) const = default;
};

/// Curvature runs linearly from `curvature` with slope `sharpness` over `length`. Lines and circular
/// arcs are clothoids with sharpness 0. A length below 0 is driven backwards: heading and curvature stay
/// those of the robot's body (to the left of its nose), s runs down from 0.
struct Clothoid {
    double length = 0, curvature = 0, sharpness = 0;
    double end_curvature() const { return curvature + sharpness * length; }
    bool operator==(const Clothoid&) const = default;
};

/// Clothoids end to end: position and heading are continuous by construction; curvature is where the pieces
/// agree. Where the sense changes (a cusp) the robot stands. Arc lengths along a curve count what is driven,
/// forward or back.
struct Curve {
    Pose start;
    std::vector<Clothoid> pieces;
    bool operator==(const Curve&) const = default;
};

/// The state of a point on a curve.
struct CurvePoint {
    double s;  ///< arc length from the curve's start
    Pose pose;
    double curvature;
};

/// Where a clothoid from `start` has come after `s`. Absolute error below 1e-12 x (1 + s) for |turning| < 50
/// rad: Gauss-Legendre panels. O(1 + turning).
Pose advanced(Pose start, const Clothoid& piece, double s);
Pose end_pose(const Curve& curve);
double length(const Curve& curve);
/// Of all of them together.
double length(const std::vector<Curve>& curves);
double max_curvature(const Curve& curve);
double max_sharpness(const Curve& curve);
/// Largest jump of curvature between neighbouring pieces: 0 is G2. What planned curves are tested with. Where
/// the robot stands and turns about the curvature is free.
double max_curvature_jump(const Curve& curve);
/// State at arc length s, clamped to the ends. O(pieces).
CurvePoint point_at(const Curve& curve, double s);
/// Both ends and equal steps of at most `step` between: at least `least` points. O(points + pieces).
std::vector<CurvePoint> sampled(const Curve& curve, double step, int least = 2);
/// The same points backwards: the robot turned about.
Curve reversed(const Curve& curve);
/// From arc length `from` to `to` (clamped).
Curve slice(const Curve& curve, double from, double to);
/// `second` moved to the end of `first` is not checked: the caller says they meet.
Curve joined(Curve first, const Curve& second);
Curve straight(Pose start, double length);
/// Whether a piece is driven backwards.
bool backs(const Clothoid& piece);
/// How often a robot that comes to the curve and leaves it driving forward changes its sense.
int stands(const Curve& curve);
/// The curve cut at its cusps: each part is driven one way. O(pieces).
std::vector<Curve> sections(const Curve& curve);

/// One clothoid from pose to pose (G1 Hermite): Bertolazzi and Frego, "G1 fitting with clothoids", Math.
/// Meth. Appl. Sci. 2015, section 3 (Newton on one unknown from their guess). Position error below 1e-10 x
/// chord. Poses at distinct points.
Curve hermite_clothoid(Pose from, Pose to);

// ---- fitting

struct FitOptions {
    double tolerance = 0.002;  ///< metres: largest distance between path and fit
    /// radians: heading jumps above this stay corners; smaller ones are smoothed over
    double corner_angle = 0.02;
    /// radians: chains of straight lines that turn by no more than this at a vertex are smoothed over as well
    /// where the bulge stays within the tolerance (drawings that were flattened before). 0: off.
    double smooth_angle = 0;
};
/// The path as smooth curves with corners between them: curves[i] ends where curves[i+1] starts. Lines and
/// circular arcs come out as one piece each; the rest as G1 clothoid Hermite pieces between points of the
/// path, halved until the tolerance holds. Zero-length segments are dropped; a path without length gives an
/// empty vector. A closed path's fit starts at its start; a smooth closed path meets itself in heading.
std::vector<Curve> fitted(const Path& path, const FitOptions& options);

// ---- curves between poses

/// The shortest curve with |curvature| <= 1/radius: Dubins, Am. J. Math. 1957; words by Shkel and Lumelsky
/// 2001. Curvature jumps. Never fails. About 0.5 us.
Curve dubins(Pose from, Pose to, double radius);
double dubins_length(Pose from, Pose to, double radius);
/// All of Dubins' six words that exist (turn, straight, turn, or three turns), the shortest first: other ways
/// between the poses, where the shortest is not wanted. 1 us.
std::vector<Curve> dubins_words(Pose from, Pose to, double radius);

/// Where a continuous-curvature curve starts or ends.
struct CurvatureState {
    Pose pose;
    double curvature = 0;
};
/// What a curve keeps: curvature from -1/right_radius to 1/radius, |sharpness| <= sharpness.
struct CurveLimits {
    double radius = 0.5;      ///< metres, > 0: least radius to the left
    double sharpness = 10.0;  ///< 1/m^2, > 0
    double right_radius = 0;  ///< metres: least radius to the right; 0: as to the left
};
/// A short G2 curve within the limits; end curvatures are met exactly (clamped to the limits when outside:
/// the caller's fault, asserted in debug). Never fails. CC turns after Fraichard and Scheuer, IEEE Trans.
/// Robotics 2004, with end curvatures as in Banzhaf et al., ITSC 2017 (HC/CC with given curvature); the
/// shortest of those families that is found quickly. Position and heading of the end are met to 1e-9. Some
/// 10 us.
Curve continuous_curvature(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits);
/// The same, searched for thoroughly where that can pay: direct optimisation finds nothing shorter
/// (docs/curve.md). Some 300 us.
Curve refined_continuous_curvature(const CurvatureState& from, const CurvatureState& to,
                                   const CurveLimits& limits);

/// A robot that may back up, too: the cheapest curve found that does, each stand() of it counted as
/// `stand_cost` metres. Driven forward, back, forward or back, forward, back; the first and the last of the
/// three may be left out. Each is within the limits; where the robot stands between them, and at an end that
/// it backs from or to, the curvature is free. nullopt: nothing cheaper than `below` was found. As Reeds and
/// Shepp's words (Pacific J. Math. 1990) with at most two cusps, searched over the lengths of the first and
/// the last part. Some 1 ms.
std::optional<Curve> backing_curve(const CurvatureState& from, const CurvatureState& to,
                                   const CurveLimits& limits, double stand_cost, double below);
/// The same guessed with Dubins' arcs and lines for the middle part, and few lengths: curvature jumps. Some
/// 20 us.
std::optional<Curve> backing_guess(Pose from, Pose to, double radius, double stand_cost, double below);

}  // namespace strandline
