// Rings from nested insets, and what is left between them.
#include "path/fill/rings.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {

// All of these are shares of the rake's width.
constexpr double thinnest_ring =
    0.12;  // half the width of an area whose ring would be two passes over one place: a spine serves it
constexpr double gap_margin = 0.02;  // gaps thinner than twice that are chords against arcs
constexpr double gap_opening =
    0.06;  // a gap that vanishes when shrunk by that is a corner's tip, not a ridge
constexpr double core_share =
    0.1;  // of width^2: a smaller gap in the middle of the innermost ring is not worth a pass
constexpr double ridge_share = 0.6;    // of width^2: nor is one between rings; a 36 degree corner leaves 0.46
constexpr double beside_gap = 0.6;     // half a width and a little: where a ring rakes beside a gap
constexpr double widest_spine = 1.15;  // one pass serves a gap that is nowhere wider than that
constexpr double spine_thinning = 0.03;  // the middle line of a jagged gap is not jagged
constexpr int most_levels = 4000;

/// The one ring in the middle of a ring-shaped gap.
Polygon middle_ring(const Region& gap) {
    double low = 0, high = std::max(bounds(gap).width(), bounds(gap).height());
    Polygon best = gap.outer;
    for (int i = 0; i < 12; ++i) {
        const double by = (low + high) / 2;
        const Regions thin = inset({gap}, by);
        if (thin.size() == 1 && thin[0].holes.size() == gap.holes.size()) {
            best = thin[0].outer;
            low = by;
        } else
            high = by;
    }
    return best;
}

void add_spines(const Regions& gaps, const Regions& next, int level, const Options& options,
                std::vector<Ring>& rings) {
    const double w = options.width;
    std::vector<Ring> beside;
    for (const Region& region : next) {
        beside.push_back(ring_of(region.outer, level, true));
        for (const Polygon& hole : region.holes) beside.push_back(ring_of(hole, level, true));
    }
    for (const Region& gap : inset(gaps, gap_opening * w)) {
        const Regions whole = inset({gap}, -gap_opening * w);
        if (area(whole) < core_share * w * w) continue;
        // In the middle of an innermost ring nothing else comes near; elsewhere the next rings lie beside the
        // gap.
        const bool core = std::ranges::none_of(beside, [&](const Ring& ring) {
            return overlaps(grown(ring.box, beside_gap * w), bounds(whole)) &&
                   std::ranges::any_of(whole[0].outer, [&](Point p) {
                       return contains(grown(ring.box, beside_gap * w), p) &&
                              nearest(ring, p).distance < beside_gap * w;
                   });
        });
        if (area(whole) < (core ? core_share : ridge_share) * w * w) continue;
        for (const Region& part : whole) {
            if (part.holes.size() == 1) {
                rings.push_back(ring_of(middle_ring(part), level, true));
                continue;
            }
            Polyline spine = thinned(middle_line(part.outer, widest_spine * w), spine_thinning * w);
            if (part.holes.empty() && spine.size() >= 2)
                rings.push_back(ring_of(std::move(spine), level, false));
            else if (area(part) > w * w / 4)
                rings.push_back(ring_of(part.outer, level, true));
        }
    }
}

}  // namespace

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

std::vector<Ring> rings_of(const Regions& room, const Options& options) {
    const double w = options.width, thinning = std::min(options.tolerance, w / 200);
    std::vector<Ring> rings;
    Regions here = simplified(room, thinning);
    if (here.empty()) here = room;
    for (int level = 0; level < most_levels && !here.empty(); ++level) {
        for (const Region& region : here) {
            rings.push_back(ring_of(region.outer, level, true));
            for (const Polygon& hole : region.holes) rings.push_back(ring_of(hole, level, true));
        }
        Regions next = simplified(inset(here, options.spacing), thinning);
        std::erase_if(next, [&](const Region& part) { return inset({part}, thinnest_ring * w).empty(); });
        const Regions bare = inset(here, (0.5 + gap_margin) * w);
        add_spines(subtracted(bare, inset(next, -(0.5 + gap_margin) * w)), next, level + 1, options, rings);
        here = std::move(next);
    }
    return rings;
}

}  // namespace strandline::fill
