// One continuous line over rings: each turn shifts to the next ring along a stretch of its own.
// The stretches of all turns lie beside each other, so neighbouring turns keep their distance while they
// shift; only the first and the last leave a wedge, half as wide as the spacing, that is raked twice.
#include "path/fill/revolve.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {

constexpr double longest_stretch = 0.4;  // of a ring
constexpr double shortest_stretch = 1;   // of the width: below that it is a step
constexpr double knot_step = 0.25;       // of the width
constexpr double near_next = 1.06;       // of the spacing: chords against arcs
constexpr double farthest_next = 1.5;    // of the spacing: beyond, the line would leave bare sand beside it
constexpr double most_skew = 2.5;        // how much longer a stretch may be on one ring than on the other
constexpr double nested_within = 1.75;   // of the spacing: a ring that is nowhere farther from the one inside
constexpr double bare_wedge = 0.2;       // of a shift: what is left when it counts as done
constexpr double eased = 0.25;           // of a stretch, at either end: where the slope grows and fades
constexpr double evened = 0.15;  // of a turn's own arc lengths in the shares that the last turn hands on
constexpr int sight_samples = 8;
constexpr int seams = 32;  // places tried round a chain's first ring and its last
// What a seam costs, in widths.
constexpr double bend_cost = 0.5, gap_cost = 3, way_cost = 0.2, hop_cost = 2;
constexpr double manoeuvre = 1;  // of the width: a longer move is a hop

/// From 0 to 1 in parabola, line and parabola: the least slope for that curvature.
double smooth(double u) {
    const double slope = 1 / (1 - eased);
    if (u < eased) return slope * u * u / (2 * eased);
    if (u > 1 - eased) return 1 - slope * (1 - u) * (1 - u) / (2 * eased);
    return slope * (u - eased / 2);
}

double foot(const Lane& lane, Point p, double near) {
    const double u = lane.sense * nearest(*lane.ring, p).s;
    return u + lane.ring->length * std::round((near - u) / lane.ring->length);
}

/// The sense of `next` in which it runs along beside `lane` at u.
Lane beside(const Lane& lane, double u, const Ring* next, double step) {
    const Point motion = at(lane, u + step) - at(lane, u - step);
    const double s = nearest(*next, at(lane, u)).s;
    const Point theirs = at(*next, s + step) - at(*next, s - step);
    return {next, dot(motion, theirs) < 0 ? -1 : 1};
}

/// Shares in (0, 1) of the stretch from u to v at which the lane has corners.
void add_corners(const Lane& lane, double u, double v, std::vector<double>& shares) {
    const Ring& ring = *lane.ring;
    if (v - u <= 0) return;
    const double low = std::min(lane.sense * u, lane.sense * v), span = v - u;
    for (double turn = std::floor(low / ring.length) * ring.length; turn < low + span; turn += ring.length) {
        const auto from = std::ranges::upper_bound(ring.arcs, low - turn);
        for (auto arc = from; arc != ring.arcs.end() && *arc < low + span - turn; ++arc) {
            const double share = (*arc + turn - low) / span;
            shares.push_back(lane.sense > 0 ? share : 1 - share);
        }
    }
}

/// The stretch of b that faces a's knots; none where the two part.
bool face(const Lane& a, const Lane& b, std::vector<ShiftKnot>& knots, double farthest,
          const AreaIndex& floor) {
    double last = foot(b, at(a, knots.front().a), 0);
    for (ShiftKnot& knot : knots) {
        const Point p = at(a, knot.a);
        knot.b = last = std::max(last, foot(b, p, last));
        if (distance(p, at(b, knot.b)) > farthest || !sees(floor, p, at(b, knot.b))) return false;
    }
    const double mine = knots.back().a - knots.front().a, theirs = knots.back().b - knots.front().b;
    return theirs < most_skew * mine && mine < most_skew * theirs;
}

Shift short_shift(const Lane& a, double centre, const Lane& b, const AreaIndex& floor,
                  const Options& options) {
    const double w = options.width;
    double stretch =
        std::min({options.shift * w, longest_stretch * a.ring->length, longest_stretch * b.ring->length});
    for (;; stretch /= 2) {
        const int n = std::max(2, static_cast<int>(std::ceil(stretch / (knot_step * w))));
        Shift shift;
        for (int k = 0; k <= n; ++k)
            shift.knots.push_back({centre + stretch * (static_cast<double>(k) / n - 0.5), 0,
                                   smooth(static_cast<double>(k) / n)});
        if (face(a, b, shift.knots, farthest_next * options.spacing, floor)) return shift;
        if (stretch < shortest_stretch * w) {
            const double there = foot(b, at(a, centre), 0);
            return {{{centre, there, 0}, {centre, there, 1}}, false};
        }
    }
}

/// The whole turn, where b lies round a at a spacing everywhere. `before`: the turn that ended on a.
std::optional<Shift> whole_shift(const Lane& a, double begin, const Lane& b, const Shift* before,
                                 const AreaIndex& floor, const Options& options) {
    const double step = knot_step * options.width, round = a.ring->length;
    if (!contains(b.ring->line, at(a, begin))) return std::nullopt;
    for (double u = 0; u < b.ring->length; u += step)
        if (nearest(*a.ring, at(b, u)).distance > nested_within * options.spacing) return std::nullopt;
    Shift shift{{}, true};
    std::size_t i = 1;
    const int n = std::max(8, static_cast<int>(std::ceil(round / step)));
    for (int k = 0; k <= n; ++k) {
        const double own = static_cast<double>(k) / n;
        double share = own;
        if (before && before->whole) {  // the share that the last turn had here, so that the distance holds
            const std::vector<ShiftKnot>& knots = before->knots;
            const double u = knots.front().b + own * round;
            while (i + 1 < knots.size() && knots[i].b < u) ++i;
            const double span = knots[i].b - knots[i - 1].b;
            const double t = span > 0 ? std::clamp((u - knots[i - 1].b) / span, 0.0, 1.0) : 1;
            share = (1 - evened) * std::lerp(knots[i - 1].share, knots[i].share, t) + evened * own;
        }
        shift.knots.push_back({begin + own * round, 0, share});
    }
    std::vector<ShiftKnot>& knots = shift.knots;
    double last = foot(b, at(a, begin), 0);
    const double end = last + b.ring->length;
    for (ShiftKnot& knot : knots) knot.b = last = std::clamp(foot(b, at(a, knot.a), last), last, end);
    if (knots.back().b < end - options.width) knots.back().b = end;
    knots.back().b = end;
    for (const ShiftKnot& knot : knots)
        if (!sees(floor, at(a, knot.a), at(b, knot.b))) return std::nullopt;
    return shift;
}

void shift_over(const Lane& a, const Lane& b, const Shift& shift, Polyline& line) {
    for (std::size_t k = 0; k + 1 < shift.knots.size(); ++k) {
        const ShiftKnot& from = shift.knots[k];
        const ShiftKnot& to = shift.knots[k + 1];
        std::vector<double> shares{0, 1};
        add_corners(a, from.a, to.a, shares);
        add_corners(b, from.b, to.b, shares);
        std::ranges::sort(shares);
        for (double t : shares)
            line.push_back(between(at(a, std::lerp(from.a, to.a, t)), at(b, std::lerp(from.b, to.b, t)),
                                   std::lerp(from.share, to.share, t)));
    }
}

/// A seam as far as it goes: the places at which the lanes face each other, and what that costs.
struct SeamLine {
    std::vector<Lane> lanes;
    std::vector<double> places;
    double cost = 0;
};

double bend(const Lane& lane, double u, double stretch) {
    return (stretch - distance(at(lane, u - stretch / 2), at(lane, u)) -
            distance(at(lane, u), at(lane, u + stretch / 2)));
}

SeamLine seam_from(const std::vector<const Ring*>& chain, std::size_t first, double place,
                   std::optional<Point> from, const Ring* onward, const AreaIndex& floor,
                   const Options& options) {
    const double w = options.width;
    SeamLine seam{{{chain[first], 1}}, {place}, 0};
    for (std::size_t i = first;; ++i) {
        const Lane& here = seam.lanes.back();
        const double u = seam.places.back();
        seam.cost +=
            bend_cost * bend(here, u, std::min(options.shift * w, longest_stretch * here.ring->length)) / w;
        if (i + 1 == chain.size() || !chain[i + 1]->closed) break;
        const Lane next = beside(here, u, chain[i + 1], 0.01 * w);
        const Foot across = nearest(*next.ring, at(here, u));
        const double apart = across.distance;
        if (apart > farthest_next * options.spacing || !sees(floor, at(here, u), across.at)) break;
        seam.cost += gap_cost * std::max(0.0, apart - near_next * options.spacing) / w;
        seam.places.push_back(foot(next, at(here, u), u));
        seam.lanes.push_back(next);
    }
    if (from) {
        const double d = distance(*from, at(seam.lanes.front(), place)) / w;
        seam.cost += way_cost * d + (d > manoeuvre ? hop_cost : 0);
    }
    if (onward && first + seam.lanes.size() == chain.size()) {
        const double d = nearest(*onward, at(seam.lanes.back(), seam.places.back())).distance / w;
        seam.cost += way_cost * d + (d > near_next ? hop_cost : 0);
    }
    return seam;
}

}  // namespace

Point at(const Lane& lane, double u) { return at(*lane.ring, lane.sense * u); }

bool sees(const AreaIndex& floor, Point a, Point b) {
    for (int k = 1; k < sight_samples; ++k)
        if (!floor.contains(between(a, b, static_cast<double>(k) / sight_samples))) return false;
    return true;
}

Revolutions revolutions(const std::vector<const Ring*>& chain, std::size_t first, std::optional<Point> from,
                        const Ring* onward, const AreaIndex& floor, const Options& options) {
    const Ring& innermost = *chain[first];
    std::optional<SeamLine> best;
    const auto attempt = [&](double place) {
        SeamLine seam = seam_from(chain, first, place, from, onward, floor, options);
        if (!best || seam.lanes.size() > best->lanes.size() ||
            (seam.lanes.size() == best->lanes.size() && seam.cost < best->cost - 1e-9))
            best = std::move(seam);
    };
    for (int k = 0; k < seams; ++k) attempt(innermost.length * k / seams);
    if (from) attempt(nearest(innermost, *from).s);
    // From the outer rings in as well: what is beside the last ring's straight parts, and its way on.
    std::size_t last = first;
    while (last + 1 < chain.size() && chain[last + 1]->closed) ++last;
    const auto inwards = [&](Point p) {
        for (std::size_t i = last + 1; i-- > first;) p = nearest(*chain[i], p).at;
        attempt(nearest(innermost, p).s);
    };
    for (int k = 0; k < seams; ++k) inwards(at(*chain[last], chain[last]->length * k / seams));

    Revolutions found{best->lanes, {}, best->places.front()};
    double arrival = 0;
    for (std::size_t i = 0; i + 1 < found.lanes.size(); ++i) {
        const Lane &a = found.lanes[i], &b = found.lanes[i + 1];
        const Shift* before = i > 0 ? &found.shifts.back() : nullptr;
        std::optional<Shift> whole;
        if (options.shift * options.width >= b.ring->length)
            whole = whole_shift(a, i > 0 ? arrival : best->places[0], b, before, floor, options);
        found.shifts.push_back(whole ? std::move(*whole)
                                     : short_shift(a, best->places[i], b, floor, options));
        arrival = found.shifts.back().knots.back().b;
    }
    if (!found.shifts.empty()) {
        const auto bare = std::ranges::find_if(
            found.shifts.front().knots, [](const ShiftKnot& knot) { return knot.share >= bare_wedge; });
        found.begin = bare->a;
    }
    return found;
}

TurnedLine line_of(const Revolutions& r) {
    TurnedLine line;
    const auto part = [&](const Lane& lane, double from, double to) {
        return along(*lane.ring, lane.sense * from, lane.sense * (to - from));
    };
    double here = r.begin;
    for (std::size_t i = 0; i < r.lanes.size(); ++i) {
        const Lane& lane = r.lanes[i];
        const double round = lane.ring->length;
        if (i + 1 == r.lanes.size()) {
            double end = here + round;
            if (i > 0)
                for (const ShiftKnot& knot : r.shifts[i - 1].knots)
                    if (knot.share >= 1 - bare_wedge) {
                        end = knot.b + round;
                        break;
                    }
            line.last = part(lane, here, end);
            break;
        }
        const Shift& next = r.shifts[i];
        if (!(i > 0 && r.shifts[i - 1].whole && next.whole)) {
            const double leave = next.knots.front().a;
            const double turns = std::ceil((here - leave) / round + longest_stretch / 2);
            const Polyline turn = part(lane, here, leave + turns * round);
            line.rest.insert(line.rest.end(), turn.begin(), turn.end());
        }
        shift_over(lane, r.lanes[i + 1], next, line.rest);
        here = next.knots.back().b;
    }
    return line;
}

}  // namespace strandline::fill
