// Rings joined by radial steps, inside to outside.
// Each ring stops half a width before it closes: what is left of it is swept by the step to the next ring.
#include <algorithm>

#include "path/fill/rings.hpp"

namespace strandline::fill {
namespace {

constexpr double before_closure = 0.5;        // of the width: where the step leaves a ring
constexpr double last_before_closure = 0.25;  // of the width: the border ring closes but for its round wedge
constexpr double most_left = 0.1;             // of a ring: small ones are closed further
constexpr double longest_step = 1.5;          // of the spacing, raked, within a nesting branch
constexpr double slant = 2.0;  // of the spacing: how far along the next ring the step leads where turns are
                               // bounded, so that both its bends stay below 30 degrees
constexpr double near_next = 1.06;   // of the spacing: where a ring counts as running beside the next
constexpr double bend_weight = 0.5;  // a seam in a bend leaves gaps: its lost arc length counts half
constexpr int seams = 16;            // places tried for the innermost ring's start

/// How a ring is gone through. `shift`: rake-up arc along it to the start, from where the step from the last
/// ring meets it.
struct Seam {
    double start = 0, span = 0, shift = 0;  // arc length; span < 0: against the ring's own sense
};

/// One chain of rings: each leads on to the next, the innermost first.
struct Chain {
    std::vector<int> rings;
    std::vector<Seam> seams;
    double cost = 0;
};

/// The place nearest to `s` along the ring that runs beside the next ring; `s` when there is none.
double beside_next(const Ring& ring, double s, const Ring& next, double limit, double step) {
    for (double off = 0; off <= ring.length / 2; off += step)
        for (double sign : {1.0, -1.0})
            if (nearest(next, at(ring, s + sign * off)).distance < limit) return s + sign * off;
    return s;
}

/// Carries a start on the innermost ring through the chain; the cost counts rake-up metres and seams in
/// bends.
void lay_seams(Chain& chain, const std::vector<Ring>& rings, double start, const Ring* onward,
               const Options& options, double enough = std::numeric_limits<double>::infinity()) {
    const double w = options.width;
    chain.seams.clear();
    chain.cost = 0;
    for (std::size_t i = 0; i < chain.rings.size(); ++i) {
        const Ring& ring = rings[chain.rings[i]];
        const bool first = i == 0, last = i + 1 == chain.rings.size();
        Seam seam{start, ring.length, 0};
        if (ring.closed) {
            const double left = last ? last_before_closure : first ? 0 : before_closure;
            if (!first) {  // go on in the sense in which the last ring was left
                const Ring& before = rings[chain.rings[i - 1]];
                const Seam& came = chain.seams.back();
                const double ahead = std::copysign(1e-3 * w, came.span);
                const Point motion =
                    at(before, came.start + came.span) - at(before, came.start + came.span - ahead);
                const Point mine = at(ring, start + 1e-3 * w) - at(ring, start);
                if (dot(motion, mine) < 0) seam.span = -seam.span;
                if (options.turn_radius > 0)
                    seam.start +=
                        std::copysign(std::min(slant * options.spacing, ring.length / 4), seam.span);
            }
            const double span = ring.length - std::min(left * w, most_left * ring.length);
            seam.span = std::copysign(span, seam.span);
            if (const Ring* next =
                    last ? onward : &rings[chain.rings[i + 1]]) {  // where the ring would end far from the
                                                                   // next one, begin elsewhere
                const double end = seam.start + seam.span;
                const double better = beside_next(ring, end, *next, near_next * options.spacing, w / 4);
                seam.shift = better - end;
                seam.start += seam.shift;
                chain.cost += std::abs(seam.shift);
            }
            const double end = seam.start + seam.span, reach = std::min(w, ring.length / 4);
            chain.cost += bend_weight * (2 * reach - distance(at(ring, end - reach), at(ring, end)) -
                                         distance(at(ring, end), at(ring, end + reach)));
        } else if (start > ring.length / 2) {
            seam = {ring.length, -ring.length, 0};
        } else {
            seam = {0, ring.length, 0};
        }
        chain.seams.push_back(seam);
        if (last || chain.cost > enough) break;
        const Foot foot = nearest(rings[chain.rings[i + 1]], at(ring, seam.start + seam.span));
        chain.cost += std::max(0.0, foot.distance - near_next * options.spacing);
        start = foot.s;
    }
}

/// Whether a and b see each other from where the rake's centre may be.
bool sees(const Regions& floor, Point a, Point b) {
    const LineParts parts = parted({a, b}, floor);
    double outside = 0;
    for (const Polyline& part : parts.outside) outside += length(part);
    return outside <= 1e-6 * distance(a, b);
}

/// The rake-up way from one chain's end to the next one's start, along rings that are raked later.
Polyline way_between(const std::vector<Ring>& rings, const Order& order, int from, Point start, int to,
                     Point goal) {
    std::vector<int> up, down;
    for (int r = order.parent[from]; r >= 0; r = order.parent[r]) up.push_back(r);
    for (int r = order.parent[to]; r >= 0; r = order.parent[r]) down.push_back(r);
    const auto meet = std::ranges::find_first_of(up, down);
    if (meet == up.end()) return {};
    std::vector<int> rest(up.begin(), meet + 1);
    const auto turn = std::ranges::find(down, *meet);
    for (auto it = turn; it != down.begin();) rest.push_back(*--it);
    Polyline way;
    Point here = start;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const Ring& ring = rings[rest[i]];
        const Foot enter = nearest(ring, here);
        // Leave where the next ring is near; of such places the one nearest to the goal.
        const Ring* next = i + 1 < rest.size() ? &rings[rest[i + 1]] : nullptr;
        double closest = std::numeric_limits<double>::infinity(), best = closest;
        Point leave = nearest(ring, goal).at;
        if (next) {
            std::vector<std::pair<double, Point>> places;
            for (Point p : next->line) {
                const double d = nearest(ring, p).distance;
                closest = std::min(closest, d);
                places.emplace_back(d, p);
            }
            for (const auto& [d, p] : places)
                if (d < 1.1 * closest && distance(p, goal) < best)
                    best = distance(p, goal), leave = nearest(ring, p).at;
        }
        double span = nearest(ring, leave).s - enter.s;
        if (ring.closed) {
            if (span > ring.length / 2) span -= ring.length;
            if (span < -ring.length / 2) span += ring.length;
        }
        const Polyline part = along(ring, enter.s, span);
        way.insert(way.end(), part.begin(), part.end());
        here = way.back();
    }
    return way;
}

std::vector<Chain> chains_of(const Order& order) {
    std::vector<Chain> chains;
    for (std::size_t i = 0; i < order.rings.size(); ++i) {
        if (i == 0 || order.parent[order.rings[i - 1]] != order.rings[i]) chains.emplace_back();
        chains.back().rings.push_back(order.rings[i]);
    }
    return chains;
}

}  // namespace

std::vector<Pass> ring_passes(const Region& region, const std::string& place, const Options& options,
                              Fill& account) {
    const Regions room = room_for_centre(region, place, options, account);
    const std::vector<Ring> rings = rings_of(room, options);
    const Order order = driving_order(rings, options);
    const Regions floor = inset(room, -0.02 * options.width);
    const double longest = options.turn_radius > 0 ? std::hypot(longest_step, slant + 1) : longest_step;
    std::vector<Pass> passes;
    int last_ring = -1;
    for (Chain& chain : chains_of(order)) {
        const Ring& innermost = rings[chain.rings.front()];
        const int parent = order.parent[chain.rings.back()];
        const Ring* onward = parent < 0 ? nullptr : &rings[parent];
        double best = std::numeric_limits<double>::infinity(), best_start = 0;
        for (int k = 0; k < seams; ++k) {
            const double start = innermost.length * (k + 0.5) / seams;
            lay_seams(chain, rings, start, onward, options, best);
            if (chain.cost < best - 1e-9 * options.width) best = chain.cost, best_start = start;
        }
        lay_seams(chain, rings, best_start, onward, options);

        Polyline line;
        const auto finish = [&](Polyline way) {
            if (line.size() >= 2)
                passes.push_back(
                    {std::move(way), rounded(line, options.round_corners ? options.turn_radius : 0)});
            line.clear();
        };
        Polyline way;
        if (last_ring >= 0 && !passes.empty())
            way = way_between(rings, order, last_ring, passes.back().line.back(), chain.rings.front(),
                              at(innermost, chain.seams.front().start));
        for (std::size_t i = 0; i < chain.rings.size(); ++i) {
            const Ring& ring = rings[chain.rings[i]];
            const Seam& seam = chain.seams[i];
            const Polyline part = along(ring, seam.start, seam.span);
            const bool shifted = i > 0 && std::abs(seam.shift) > options.width / 4;
            if (!line.empty() &&
                (shifted || distance(line.back(), part.front()) > longest * options.spacing ||
                 !sees(floor, line.back(), part.front()))) {
                finish(std::exchange(way, {}));
                if (shifted) way = along(ring, seam.start - seam.shift, seam.shift);
            }
            line.insert(line.end(), part.begin(), part.end());
        }
        finish(std::move(way));
        last_ring = chain.rings.back();
    }
    return passes;
}

}  // namespace strandline::fill
