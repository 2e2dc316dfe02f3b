// Parts in which every line of one direction meets the area in one piece.
// Key: the region is turned so that the lines lie level. A slab is what lies between two neighbouring corner
// heights; in it the edges do not cross, and neighbouring pairs of them bound spans. A span that has one
// neighbour above, whose only neighbour below it is, goes on as the same part: that merges the trapezoids of
// the classic decomposition into boustrophedon cells.
#include <algorithm>

#include "math/region/region.hpp"

namespace strandline {
namespace {

constexpr double same_height = 1e-9;  // of the extent: corners nearer in height than that share one level

struct Edge {
    Point low, high;
    double x_at(double y) const {
        if (y <= low.y) return low.x;
        if (y >= high.y) return high.x;
        return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
    }
};

/// One side of a part, bottom up; remembers its last edge so that passing a level in mid-edge leaves no
/// corner.
struct Side {
    std::vector<Point> points;
    int edge = -1;
    void go(int next, const Edge& line, double bottom, double top) {
        if (next == edge) {
            points.back() = {line.x_at(top), top};
            return;
        }
        const Point foot{line.x_at(bottom), bottom};
        if (points.empty() || points.back() != foot) points.push_back(foot);
        points.push_back({line.x_at(top), top});
        edge = next;
    }
};
struct Span {
    int left, right;  // edges
    int part;
};
struct Part {
    Side left, right;
};

/// Turned by -direction about `middle`, heights that agree but for rounding made equal: a horizontal edge
/// stays horizontal.
std::vector<Polygon> levelled(const Region& region, Point middle, double direction, double gap,
                              std::vector<double>& levels) {
    const Affine turn{
        std::cos(direction), -std::sin(direction), std::sin(direction), std::cos(direction), 0, 0};
    std::vector<Polygon> rings{region.outer};
    rings.insert(rings.end(), region.holes.begin(), region.holes.end());
    for (Polygon& ring : rings)
        for (Point& p : ring) p = apply(turn, p - middle), levels.push_back(p.y);
    std::ranges::sort(levels);
    std::vector<double> distinct;
    for (double y : levels)
        if (distinct.empty() || y > distinct.back() + gap) distinct.push_back(y);
    levels = std::move(distinct);
    for (Polygon& ring : rings)
        for (Point& p : ring) p.y = *std::prev(std::ranges::upper_bound(levels, p.y));
    return rings;
}

/// Links each span to the part it continues, or begins a new one.
void link(std::vector<Span>& above, const std::vector<Span>& below, const std::vector<Edge>& edges, double y,
          double gap, std::vector<Part>& parts) {
    std::vector<int> ups(below.size(), 0);
    std::vector<int> downs(above.size(), 0), only(above.size(), -1);
    for (std::size_t a = 0, b = 0; a < above.size(); ++a) {
        const double left = edges[above[a].left].x_at(y), right = edges[above[a].right].x_at(y);
        while (b > 0 && b >= below.size()) --b;
        while (b > 0 && edges[below[b].right].x_at(y) > left) --b;  // spans are in order: step back a little
        for (; b < below.size(); ++b) {
            const double l = edges[below[b].left].x_at(y), r = edges[below[b].right].x_at(y);
            if (l >= right) break;
            if (std::min(right, r) - std::max(left, l) <= gap) continue;
            ++ups[b];
            ++downs[a];
            only[a] = static_cast<int>(b);
        }
    }
    for (std::size_t a = 0; a < above.size(); ++a) {
        const bool goes_on = downs[a] == 1 && ups[only[a]] == 1;
        above[a].part = goes_on ? below[only[a]].part : static_cast<int>(parts.size());
        if (!goes_on) parts.emplace_back();
    }
}

}  // namespace

std::vector<Polygon> monotone_parts(const Region& region, double direction) {
    if (region.outer.size() < 3) return {};
    const Box box = bounds(region);
    const Point middle = between(box.low, box.high, 0.5);
    const double gap = same_height * (box.width() + box.height());
    std::vector<double> levels;
    const std::vector<Polygon> rings = levelled(region, middle, direction, gap, levels);
    std::vector<Edge> edges;
    for (const Polygon& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            if (ring[i].y == ring[j].y) continue;
            edges.push_back(ring[i].y > ring[j].y ? Edge{ring[j], ring[i]} : Edge{ring[i], ring[j]});
        }
    std::ranges::sort(edges, {}, [](const Edge& e) { return e.low.y; });

    std::vector<Part> parts;
    std::vector<Span> below;
    std::vector<std::pair<double, int>> active;  // x at mid-slab, edge
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        const double bottom = levels[k], top = levels[k + 1], half = (bottom + top) / 2;
        std::erase_if(active, [&](const auto& entry) { return edges[entry.second].high.y <= bottom; });
        while (next < edges.size() && edges[next].low.y <= bottom)
            active.emplace_back(0, static_cast<int>(next++));
        for (auto& [x, edge] : active) x = edges[edge].x_at(half);
        std::ranges::sort(active);
        std::vector<Span> above;
        for (std::size_t i = 0; i + 1 < active.size(); i += 2)
            if (active[i + 1].first - active[i].first > gap)
                above.push_back({active[i].second, active[i + 1].second, -1});
        link(above, below, edges, bottom, gap, parts);
        for (const Span& span : above) {
            parts[span.part].left.go(span.left, edges[span.left], bottom, top);
            parts[span.part].right.go(span.right, edges[span.right], bottom, top);
        }
        below = std::move(above);
    }

    const Affine back{
        std::cos(direction), std::sin(direction), -std::sin(direction), std::cos(direction), 0, 0};
    std::vector<Polygon> polygons;
    for (Part& part : parts) {
        Polygon polygon = std::move(part.right.points);
        polygon.insert(polygon.end(), part.left.points.rbegin(), part.left.points.rend());
        for (Point& p : polygon) p = middle + apply(back, p);
        polygon = without_duplicate_corners(polygon);
        if (polygon.size() >= 3) polygons.push_back(std::move(polygon));
    }
    return polygons;
}

}  // namespace strandline
