#include "math/geometry/geometry.hpp"

#include <algorithm>
#include <utility>

namespace strandline {

Point normalized(Point a) {
    const double n = length(a);
    return n > 0 ? (1 / n) * a : a;
}

double wrap_angle(double angle) {
    double r = std::remainder(angle, 2 * pi);
    return r <= -pi ? r + 2 * pi : r;
}

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

Box grown(Box box, double margin) {
    return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}
Box united(Box a, Box b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}
Box including(Box box, Point p) { return united(box, {p, p}); }
bool contains(Box box, Point p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}
bool overlaps(Box a, Box b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

Affine composed(const Affine& m, const Affine& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
}
double mean_scale(const Affine& m) { return std::sqrt(std::abs(determinant(m))); }

double length(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}
double perimeter(const Polygon& polygon) {
    return polygon.empty() ? 0 : length(polygon) + distance(polygon.back(), polygon.front());
}
double signed_area(const Polygon& polygon) {
    if (polygon.size() < 3) return 0;
    double twice = 0;  // around the first corner: keeps digits for outlines far from the origin
    const Point o = polygon.front();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += cross(polygon[i] - o, polygon[i + 1] - o);
    return twice / 2;
}
double area(const Polygon& polygon) { return std::abs(signed_area(polygon)); }
double area(const Region& region) {
    double sum = area(region.outer);
    for (const Polygon& hole : region.holes) sum -= area(hole);
    return sum;
}
Point centroid(const Polygon& polygon) {
    if (polygon.empty()) return {};
    const Point o = polygon.front();
    Point sum{};
    double twice = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Point u = polygon[i] - o, v = polygon[i + 1] - o;
        const double w = cross(u, v);
        sum = sum + w * (u + v);
        twice += w;
    }
    return twice == 0 ? o : o + (1 / (3 * twice)) * sum;
}
Box bounds(const std::vector<Point>& points) {
    Box box;
    for (Point p : points) box = including(box, p);
    return box;
}
Box bounds(const Region& region) { return bounds(region.outer); }
std::vector<Point> reversed(std::vector<Point> points) {
    std::reverse(points.begin(), points.end());
    return points;
}
Polygon counter_clockwise(Polygon polygon) {
    return signed_area(polygon) < 0 ? reversed(std::move(polygon)) : polygon;
}
Polyline without_duplicates(const Polyline& line, double tolerance) {
    Polyline kept;
    for (Point p : line)
        if (kept.empty() || distance(kept.back(), p) > tolerance) kept.push_back(p);
    if (kept.size() > 1 && kept.back() != line.back()) kept.back() = line.back();
    return kept;
}
Polygon without_duplicate_corners(const Polygon& polygon, double tolerance) {
    Polygon kept;
    for (Point p : polygon)
        if (kept.empty() || distance(kept.back(), p) > tolerance) kept.push_back(p);
    while (kept.size() > 1 && distance(kept.back(), kept.front()) <= tolerance) kept.pop_back();
    return kept;
}
Point point_at(const Polyline& line, double arc) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double d = distance(line[i - 1], line[i]);
        if (arc <= d && d > 0) return between(line[i - 1], line[i], std::max(0.0, arc / d));
        arc -= d;
    }
    return line.back();
}
std::vector<std::size_t> thinned(std::span<const Point> line, double tolerance) {
    if (line.empty()) return {};
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double farthest = tolerance;
        std::size_t at = from;
        for (std::size_t i = from + 1; i < to; ++i)
            if (const double d = distance_to_segment(line[i], line[from], line[to]); d > farthest) {
                farthest = d;
                at = i;
            }
        if (at == from) continue;
        kept[at] = true;
        open.emplace_back(from, at);
        open.emplace_back(at, to);
    }
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (kept[i]) numbers.push_back(i);
    return numbers;
}

Polygon thinned_outline(const Polygon& ring, double tolerance) {
    const std::size_t n = ring.size();
    if (n < 4) return ring;
    std::size_t opposite = 0;
    for (std::size_t i = 1; i < n; ++i)
        if (distance(ring[0], ring[i]) > distance(ring[0], ring[opposite])) opposite = i;
    Polygon round = ring;
    round.push_back(ring[0]);
    const std::span<const Point> chain(round);
    Polygon rest;
    for (const std::size_t i : thinned(chain.first(opposite + 1), tolerance)) rest.push_back(ring[i]);
    const std::vector<std::size_t> back = thinned(chain.subspan(opposite), tolerance);
    for (std::size_t k = 1; k + 1 < back.size(); ++k) rest.push_back(ring[opposite + back[k]]);
    return rest;
}

Polyline slice(const Polyline& line, double from, double to) {
    Polyline part{point_at(line, from)};
    double arc = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        arc += distance(line[i - 1], line[i]);
        if (arc > from && arc < to) part.push_back(line[i]);
    }
    part.push_back(point_at(line, to));
    return part;
}

bool contains(const Polygon& polygon, Point p) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point a = polygon[j], b = polygon[i];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}
bool contains(const Region& region, Point p) {
    return contains(region.outer, p) &&
           std::ranges::none_of(region.holes, [&](const Polygon& hole) { return contains(hole, p); });
}

Point nearest_on_segment(Point p, Point a, Point b) {
    const Point u = b - a;
    const double n = dot(u, u);
    return n > 0 ? a + std::clamp(dot(p - a, u) / n, 0.0, 1.0) * u : a;
}
double distance_to_segment(Point p, Point a, Point b) { return distance(p, nearest_on_segment(p, a, b)); }
double distance_to(const Polyline& line, Point p) {
    double best = line.empty() ? std::numeric_limits<double>::infinity() : distance(line.front(), p);
    for (std::size_t i = 1; i < line.size(); ++i)
        best = std::min(best, distance_to_segment(p, line[i - 1], line[i]));
    return best;
}
double distance_to_outline(const Polygon& polygon, Point p) {
    return polygon.empty()
               ? std::numeric_limits<double>::infinity()
               : std::min(distance_to(polygon, p), distance_to_segment(p, polygon.back(), polygon.front()));
}
std::optional<Crossing> crossing(Point a, Point b, Point c, Point d) {
    const Point u = b - a, v = d - c;
    const double det = cross(u, v);
    if (det == 0) return std::nullopt;
    const double s = cross(c - a, v) / det, t = cross(c - a, u) / det;
    if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
    return Crossing{s, t, a + s * u};
}

}  // namespace strandline
