// Where outlines touch or cross: what makes an area invalid.
#include <algorithm>
#include <map>

#include "math/region/region.hpp"

namespace strandline {
namespace {

struct Edge {
    std::size_t ring, number, count;  // edge `number` of `count` of its outline
    Point a, b;
    Box box;
};

/// A point that both edges come within `tolerance` of.
std::optional<Point> met(const Edge& e, const Edge& f, double tolerance) {
    if (const auto cross = crossing(e.a, e.b, f.a, f.b)) return cross->at;
    for (Point p : {f.a, f.b})
        if (distance_to_segment(p, e.a, e.b) <= tolerance) return p;
    for (Point p : {e.a, e.b})
        if (distance_to_segment(p, f.a, f.b) <= tolerance) return p;
    return {};
}

/// Neighbours of one outline meet in their common corner: that is a contact where the second leads back over
/// the first.
std::optional<Point> turned_back(const Edge& e, const Edge& next, double tolerance) {
    const Point in = e.b - e.a, out = next.b - next.a;
    if (dot(in, out) >= 0) return {};
    const bool within = distance_to_segment(next.b, e.a, e.b) <= tolerance ||
                        distance_to_segment(e.a, next.a, next.b) <= tolerance;
    return within ? std::optional(e.b) : std::nullopt;
}

}  // namespace

std::vector<Contact> contacts(const std::vector<Polygon>& outlines, double tolerance, int most) {
    std::vector<Edge> edges;
    for (std::size_t ring = 0; ring < outlines.size(); ++ring) {
        const Polygon& outline = outlines[ring];
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point a = outline[i], b = outline[i + 1 == outline.size() ? 0 : i + 1];
            edges.push_back(
                {ring, i, outline.size(), a, b, grown(including(including({}, a), b), tolerance)});
        }
    }
    std::ranges::stable_sort(edges, {}, [](const Edge& edge) { return edge.box.low.x; });
    std::vector<Contact> found;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Point>> places;
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size() && edges[j].box.low.x <= edges[i].box.high.x; ++j) {
            if (!overlaps(edges[i].box, edges[j].box)) continue;
            const bool in_order =
                std::pair(edges[i].ring, edges[i].number) < std::pair(edges[j].ring, edges[j].number);
            const Edge &e = in_order ? edges[i] : edges[j], &f = in_order ? edges[j] : edges[i];
            std::optional<Point> at;
            if (e.ring == f.ring && f.number == e.number + 1)
                at = turned_back(e, f, tolerance);
            else if (e.ring == f.ring && e.number == 0 && f.number + 1 == f.count)
                at = turned_back(f, e, tolerance);
            else
                at = met(e, f, tolerance);
            if (!at) continue;
            std::vector<Point>& known = places[{e.ring, f.ring}];
            const auto same = [&](Point p) { return distance(p, *at) <= 4 * tolerance; };
            if (static_cast<int>(known.size()) >= most || std::ranges::any_of(known, same)) continue;
            known.push_back(*at);
            found.push_back({e.ring, f.ring, *at});
        }
    return found;
}

}  // namespace strandline
