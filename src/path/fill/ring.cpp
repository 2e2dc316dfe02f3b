// One ring: places on it by arc length.
#include <algorithm>

#include "path/fill/rings.hpp"

namespace strandline::fill {

Ring ring_of(Polyline line, int level, bool closed) {
    Ring ring{std::move(line), level, closed, 0, {}, {}};
    for (std::size_t i = 0; i < ring.line.size(); ++i) {
        if (i > 0) ring.length += distance(ring.line[i - 1], ring.line[i]);
        ring.arcs.push_back(ring.length);
    }
    if (closed) ring.length += distance(ring.line.back(), ring.line.front());
    ring.box = bounds(ring.line);
    return ring;
}

Foot nearest(const Ring& ring, Point p) {
    Foot best;
    const std::size_t n = ring.line.size();
    if (n == 1) return {0, ring.line[0], distance(p, ring.line[0])};
    double least = std::numeric_limits<double>::infinity();  // squared; the loop is the room's hottest
    std::size_t hit = 0;
    for (std::size_t i = 0; i + (ring.closed ? 0 : 1) < n; ++i) {
        const Point a = ring.line[i], u = ring.line[i + 1 < n ? i + 1 : 0] - a, v = p - a;
        const double uu = dot(u, u), t = uu > 0 ? std::clamp(dot(v, u) / uu, 0.0, 1.0) : 0;
        const Point d = v - t * u;
        if (const double dd = dot(d, d); dd < least) {
            least = dd;
            hit = i;
        }
    }
    const Point a = ring.line[hit];
    best.at = nearest_on_segment(p, a, ring.line[hit + 1 < n ? hit + 1 : 0]);
    best.s = ring.arcs[hit] + distance(a, best.at);
    best.distance = std::sqrt(least);
    return best;
}

Polyline along(const Ring& ring, double from, double span) {
    Polyline loop = ring.line;
    if (ring.closed) loop.push_back(loop.front());
    if (span < 0) {
        std::ranges::reverse(loop);
        from = ring.length - from;
        span = -span;
    }
    if (!ring.closed) return slice(loop, std::max(0.0, from), std::min(ring.length, from + span));
    from = std::fmod(from, ring.length);
    if (from < 0) from += ring.length;
    Polyline part = slice(loop, from, std::min(ring.length, from + span));
    if (from + span > ring.length) {
        const Polyline rest = slice(loop, 0, std::min(from + span - ring.length, ring.length));
        part.insert(part.end(), rest.begin() + 1, rest.end());
    }
    return without_duplicates(part, 1e-9 * ring.length);
}

Point at(const Ring& ring, double s) {
    if (ring.closed) {
        s = std::fmod(s, ring.length);
        if (s < 0) s += ring.length;
    }
    const auto after = std::ranges::upper_bound(ring.arcs, s);
    if (after == ring.arcs.begin()) return ring.line.front();
    const auto i = static_cast<std::size_t>(after - ring.arcs.begin()) - 1;
    if (i + 1 == ring.line.size() && !ring.closed) return ring.line.back();
    const Point a = ring.line[i], b = ring.line[i + 1 < ring.line.size() ? i + 1 : 0];
    const double d = distance(a, b);
    return d > 0 ? between(a, b, std::min(1.0, (s - ring.arcs[i]) / d)) : a;
}

}  // namespace strandline::fill
