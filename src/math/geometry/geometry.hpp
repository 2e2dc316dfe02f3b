#pragma once
// Points, polylines, polygons, regions and what is measured on them. Metres, y up, counter-clockwise
// positive, angles in radians. Everything here is a plain value or a free function.
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace strandline {

inline constexpr double pi = std::numbers::pi;

/// A point, or a vector between two.
struct Point {
    double x = 0, y = 0;
    bool operator==(const Point&) const = default;
};

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator-(Point a) { return {-a.x, -a.y}; }
constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
constexpr Point operator*(Point a, double s) { return {s * a.x, s * a.y}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// z of the cross product: positive when b lies to the left of a.
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double length(Point a) { return std::sqrt(a.x * a.x + a.y * a.y); }
inline double distance(Point a, Point b) { return length(b - a); }
/// The point at share t of the way from a to b.
constexpr Point between(Point a, Point b, double t) { return a + t * (b - a); }
/// A quarter turn to the left.
constexpr Point left_normal(Point a) { return {-a.y, a.x}; }
inline Point unit(double heading) { return {std::cos(heading), std::sin(heading)}; }
inline double heading(Point a) { return std::atan2(a.y, a.x); }
/// a / |a|; the zero vector stays zero.
Point normalized(Point a);
/// The same angle in (-pi, pi].
double wrap_angle(double angle);
bool is_finite(Point p);

/// Axis-parallel box. Invariant once it holds a point: low <= high. An empty box has low > high.
struct Box {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    bool empty() const { return low.x > high.x || low.y > high.y; }
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
    bool operator==(const Box&) const = default;
};
Box grown(Box box, double margin);
Box united(Box a, Box b);
Box including(Box box, Point p);
bool contains(Box box, Point p);
bool overlaps(Box a, Box b);

/// Affine map: x' = a x + c y + e, y' = b x + d y + f (the order of SVG's matrix()).
struct Affine {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
    bool operator==(const Affine&) const = default;
};
constexpr Point apply(const Affine& m, Point p) {
    return {m.a * p.x + m.c * p.y + m.e, m.b * p.x + m.d * p.y + m.f};
}
/// The linear part alone: for vectors.
constexpr Point apply_to_vector(const Affine& m, Point v) {
    return {m.a * v.x + m.c * v.y, m.b * v.x + m.d * v.y};
}
/// first `inner`, then `outer`.
Affine composed(const Affine& outer, const Affine& inner);
constexpr double determinant(const Affine& m) { return m.a * m.d - m.b * m.c; }
/// Factor by which lengths grow on average: sqrt(|det|).
double mean_scale(const Affine& m);

/// An open chain of at least two points.
using Polyline = std::vector<Point>;
/// A closed chain; the first point is not repeated at the end. At least three points where it bounds an area.
using Polygon = std::vector<Point>;
/// An area: one outer polygon (counter-clockwise) and holes (clockwise) inside it that do not cross.
struct Region {
    Polygon outer;
    std::vector<Polygon> holes;
    bool operator==(const Region&) const = default;
};

double length(const Polyline& line);
double perimeter(const Polygon& polygon);
/// Positive for counter-clockwise. O(n).
double signed_area(const Polygon& polygon);
double area(const Polygon& polygon);
/// Outer minus holes.
double area(const Region& region);
Point centroid(const Polygon& polygon);
Box bounds(const std::vector<Point>& points);
Box bounds(const Region& region);
std::vector<Point> reversed(std::vector<Point> points);
/// Counter-clockwise copy.
Polygon counter_clockwise(Polygon polygon);
/// Consecutive points closer than `tolerance` become one (first and last stay; a polygon's end may join its
/// start).
Polyline without_duplicates(const Polyline& line, double tolerance = 0);
Polygon without_duplicate_corners(const Polygon& polygon, double tolerance = 0);
/// The numbers of the points that keep the line within `tolerance` of all of them, first and last among them:
/// Douglas and Peucker (Cartographica 1973). O(n log n) typical, O(n^2) worst.
std::vector<std::size_t> thinned(std::span<const Point> line, double tolerance);
/// The outline thinned so, split at its first corner and the corner farthest from it. May come to touch
/// itself.
Polygon thinned_outline(const Polygon& outline, double tolerance);
/// The part of a polyline between two arc lengths, 0 <= from <= to <= length.
Polyline slice(const Polyline& line, double from, double to);
Point point_at(const Polyline& line, double arc);

/// Even-odd; points exactly on the outline may go either way. O(n).
bool contains(const Polygon& polygon, Point p);
bool contains(const Region& region, Point p);

/// The point of segment ab that is nearest to p.
Point nearest_on_segment(Point p, Point a, Point b);
double distance_to_segment(Point p, Point a, Point b);
double distance_to(const Polyline& line, Point p);
/// Distance to the closed outline.
double distance_to_outline(const Polygon& polygon, Point p);
/// Where the open segments ab and cd cross, if they do in one point (end points count; parallel overlaps do
/// not).
struct Crossing {
    double s, t;  ///< shares along ab and cd, in 0..1
    Point at;
};
std::optional<Crossing> crossing(Point a, Point b, Point c, Point d);

}  // namespace strandline
