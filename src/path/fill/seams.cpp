// Where each ring of a chain is begun and ended.
#include "path/fill/seams.hpp"

#include <algorithm>
#include <array>

#include "path/fill/corners.hpp"

namespace strandline::fill {
namespace {

constexpr double before_closure = 0.5;        // of the width: where the step leaves a ring
constexpr double last_before_closure = 0.25;  // of the width: a ring that is stepped onto and then left by a
                                              // lift closes but for its round wedge
constexpr double most_left = 0.1;             // of a ring: small ones are closed further
constexpr double near_next = 1.06;            // of the spacing: where a ring runs beside the next
constexpr double longest_step = 1.5;          // of the spacing: from a spine's end
constexpr double manoeuvre = 1.0005;          // of the width: a longer move with the rake up is a hop
constexpr double slant = 2.0;  // of the spacing: how far along the next ring the step leads where turns are
                               // bounded, so that both its bends stay below 30 degrees
constexpr int samples = 24;    // places looked at along a ring
constexpr int most_beside = 6;
// What the joints cost, in widths of raked length.
constexpr double step_cost = 0.35, lift_cost = 0.1, hop_cost = 2, way_cost = 0.05, bend_cost = 0.3;
constexpr double shut_in_cost = 1;       // a place that can only be left over raked sand
constexpr double side = 0.75;            // of the width: where the sand beside a pass is looked at
constexpr double exit_cost = 1;          // a width away from the exit that is wished for
constexpr double slanted_bend_cost = 1;  // the same where a step leads along the next ring

struct Place {
    double s = 0;
    bool corner = false;
    Point begin, end;  // of the passes
    double cost = 0;
    bool flipped = false;
};

/// Turning of the ring within `reach` about arc s, radians: a seam in a bend leaves a gap.
double bend(const Ring& ring, double s, double reach) {
    const Point a = at(ring, s - reach), b = at(ring, s), c = at(ring, s + reach);
    return std::abs(std::atan2(cross(b - a, c - b), dot(b - a, c - b)));
}

Place smooth_place(const Ring& ring, double s, const Options& options) {
    const Point p = at(ring, s);
    if (options.turn_radius > 0)
        return {s, false, p, p, bend(ring, s, (slant + 0.5) * options.spacing) * slanted_bend_cost};
    return {s, false, p, p, bend(ring, s, options.width / 2) * bend_cost};
}

std::vector<Place> corners_of(const Ring& ring, const Options& options) {
    std::vector<Place> found;
    const std::size_t n = ring.line.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = ring.line[(i + n - 1) % n], b = ring.line[i], c = ring.line[(i + 1) % n];
        if (const auto cut = cut_corner(a, b, c, ring.level == 0, options))
            found.push_back({ring.arcs[i], true, b + cut->ahead * normalized(c - b),
                             b + cut->onward * normalized(b - a), 0});
    }
    return found;
}

double middle_of_longest_edge(const Ring& ring) {
    double middle = 0, longest = 0;
    for (std::size_t i = 0; i < ring.line.size(); ++i) {
        const double end = i + 1 < ring.line.size() ? ring.arcs[i + 1] : ring.length;
        if (end - ring.arcs[i] > longest * (1 + 1e-9)) {
            longest = end - ring.arcs[i];
            middle = (ring.arcs[i] + end) / 2;
        }
    }
    return middle;
}

/// Places spread over where the ring runs beside the next; none when it does so all round.
std::vector<double> beside(const Ring& ring, const Ring& next, const Options& options) {
    std::vector<double> found;
    for (int k = 0; k < samples; ++k) {
        const double s = ring.length * k / samples;
        if (nearest(next, at(ring, s)).distance < near_next * options.spacing) found.push_back(s);
    }
    if (static_cast<int>(found.size()) == samples) return {};
    if (found.empty()) {  // they touch somewhere: where the next comes nearest
        Foot best;
        for (Point p : next.line)
            if (const Foot foot = nearest(ring, p); foot.distance < best.distance) best = foot;
        return {best.s};
    }
    std::vector<double> spread;
    const int most = std::min(most_beside, static_cast<int>(found.size()));
    for (int k = 0; k < most; ++k)
        spread.push_back(found[found.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(most)]);
    return spread;
}

std::vector<Place> places_on(const Ring& ring, const Ring* next, const std::vector<Place>& before,
                             const Options& options) {
    if (!ring.teeth.empty()) {
        std::vector<Place> ends;
        for (bool backward : {false, true})
            for (bool flipped : {false, true}) {
                const std::vector<Polyline> passes =
                    passes_along(ring, {backward ? ring.length : 0, 0, false, false, flipped}, options);
                ends.push_back({backward ? ring.length : 0, false, passes.front().front(),
                                passes.back().back(), 0, flipped});
            }
        return ends;
    }
    if (!ring.closed)
        return {{0, false, ring.line.front(), ring.line.back(), 0},
                {ring.length, false, ring.line.back(), ring.line.front(), 0}};
    if (options.join == Join::longest_edge)
        return {smooth_place(ring, middle_of_longest_edge(ring), options)};
    std::vector<Place> places;
    if (options.join == Join::half_step) places = corners_of(ring, options);
    const auto add = [&](double s) {
        const double apart = std::min(options.width / 4, ring.length / 16);
        if (std::ranges::none_of(places,
                                 [&](const Place& p) { return !p.corner && std::abs(p.s - s) < apart; }))
            places.push_back(smooth_place(ring, s, options));
    };
    if (next)
        for (double s : beside(ring, *next, options)) add(s);
    for (const Place& p : before) add(nearest(ring, p.end).s);
    if (before.empty())
        for (int k = 0; k < samples / 2; ++k) add(ring.length * (k + 0.5) / (samples / 2));
    return places;
}

bool steps(const Ring& from, const Place& a, const Ring& to, const Place& b, const Options& options) {
    if (a.corner || b.corner || !from.teeth.empty() || !to.teeth.empty()) return false;
    const double d = distance(a.end, b.begin);
    return d < (from.closed && to.closed ? near_next : longest_step) * options.spacing;
}

double joint_cost(const Ring& from, const Place& a, const Ring& to, const Place& b, const Options& options) {
    const double w = options.width, d = distance(a.end, b.begin);
    if (steps(from, a, to, b, options)) return step_cost;
    return d <= manoeuvre * w ? lift_cost : hop_cost + way_cost * d / w;
}

/// Whether the straight way on from where a ring is left crosses what the ring has raked.
bool crosses_itself(const Ring& ring, const Seam& seam, Point next, const Options& options) {
    const double just_now = std::min(options.width / 4, std::abs(seam.span) / 4);
    const Polyline line = along(ring, seam.start, std::copysign(std::abs(seam.span) - just_now, seam.span));
    const Point end = at(ring, seam.start + seam.span);
    for (std::size_t i = 1; i < line.size(); ++i)
        if (crossing(end, next, line[i - 1], line[i])) return true;
    return false;
}

/// Whether a ring that is closed is left onward, over what it raked first; else over what it raked last.
bool leaves_ahead(const Ring& ring, const Seam& seam, Point next, const Options& options) {
    const double ahead = std::copysign(options.width / 4, seam.span);
    const Point end = at(ring, seam.start + seam.span);
    return !seam.corner && dot(next - end, at(ring, seam.start + seam.span + ahead) - end) > 0;
}

/// Whether there is no sand beside the ring at arc length s that is still to be raked.
bool shut_in(const Ring& ring, double s, const Ring* before, const Lattice& lattice, const Options& options) {
    const double w = options.width;
    const Point p = at(ring, s), off = side * w * left_normal(normalized(at(ring, s + 1e-3 * w) - p));
    return std::ranges::none_of(std::array{p + off, p - off}, [&](Point q) {
        return is_free(lattice, q) && !(before && nearest(*before, q).distance < w / 2);
    });
}

}  // namespace

std::vector<Seam> seams_of(const std::vector<const Ring*>& chain, const Ring* onward,
                           std::optional<Point> from, std::optional<Point> exit, const Lattice& lattice,
                           const Options& options) {
    const std::size_t n = chain.size();
    std::vector<std::vector<Place>> places(n);
    std::vector<std::vector<double>> cost(n);
    std::vector<std::vector<std::size_t>> came(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Ring* next = i + 1 < n ? chain[i + 1] : onward;
        places[i] = places_on(*chain[i], next, i > 0 ? places[i - 1] : std::vector<Place>{}, options);
        const bool leaves = i + 1 == n && !onward && exit;
        if (leaves && chain[i]->closed && chain[i]->teeth.empty())
            places[i].push_back(smooth_place(*chain[i], nearest(*chain[i], *exit).s, options));
        cost[i].assign(places[i].size(), std::numeric_limits<double>::infinity());
        came[i].assign(places[i].size(), 0);
        for (std::size_t b = 0; b < places[i].size(); ++b) {
            const Place& here = places[i][b];
            if (i == 0) cost[i][b] = from ? way_cost * distance(*from, here.begin) / options.width : 0;
            for (std::size_t a = 0; i > 0 && a < places[i - 1].size(); ++a) {
                const double total =
                    cost[i - 1][a] + joint_cost(*chain[i - 1], places[i - 1][a], *chain[i], here, options);
                if (total < cost[i][b]) cost[i][b] = total, came[i][b] = a;
            }
            cost[i][b] += here.cost;
            if (!options.masked && chain[i]->closed &&
                shut_in(*chain[i], here.s, i > 0 ? chain[i - 1] : nullptr, lattice, options))
                cost[i][b] += shut_in_cost;
            if (leaves) cost[i][b] += exit_cost * distance(here.end, *exit) / options.width;
            if (i + 1 == n && onward)
                cost[i][b] += way_cost * nearest(*onward, here.end).distance / options.width;
        }
    }
    std::vector<std::size_t> chosen(n);
    chosen[n - 1] = static_cast<std::size_t>(std::ranges::min_element(cost[n - 1]) - cost[n - 1].begin());
    for (std::size_t i = n - 1; i > 0; --i) chosen[i - 1] = came[i][chosen[i]];

    std::vector<Seam> seams;
    for (std::size_t i = 0; i < n; ++i) {
        const Ring& ring = *chain[i];
        const Place& place = places[i][chosen[i]];
        Seam seam{place.s, ring.length, place.corner, false, place.flipped};
        const bool leaves_stepping =
            i + 1 < n && steps(ring, place, *chain[i + 1], places[i + 1][chosen[i + 1]], options);
        if (i > 0) seam.stepped = steps(*chain[i - 1], places[i - 1][chosen[i - 1]], ring, place, options);
        if (!ring.closed) {
            if (place.s > 0) seam.span = -ring.length;
            seams.push_back(seam);
            continue;
        }
        const double left = options.join == Join::nearest     ? 0
                            : leaves_stepping                 ? before_closure
                            : seam.stepped && !options.masked ? last_before_closure
                                                              : 0;
        if (i > 0) {  // go on in the sense in which the last ring was left
            const Ring& before = *chain[i - 1];
            const Seam& came_from = seams.back();
            const double ahead = std::copysign(1e-3 * options.width, came_from.span);
            const double end = came_from.start + came_from.span;
            const Point motion = at(before, end) - at(before, end - ahead);
            const Point mine = at(ring, seam.start + 1e-3 * options.width) - at(ring, seam.start);
            if ((dot(motion, mine) < 0) != (options.join == Join::alternating)) seam.span = -seam.span;
        }
        const auto cut_to = [&](double sense) {
            Seam cut = seam;
            cut.span =
                std::copysign(ring.length - std::min(left * options.width, most_left * ring.length), sense);
            return cut;
        };
        if (!options.masked && i + 1 < n &&
            (i == 0 || (options.turn_radius == 0 && options.join != Join::alternating))) {
            const Point next = places[i + 1][chosen[i + 1]].begin;
            const auto meets_itself = [&](double sense) {
                return leaves_stepping ? crosses_itself(ring, cut_to(sense), next, options)
                                       : leaves_ahead(ring, cut_to(sense), next, options);
            };
            if (meets_itself(seam.span) && !meets_itself(-seam.span)) seam.span = -seam.span;
        }
        if (seam.stepped && options.turn_radius > 0)  // never of the first ring
            seam.start += std::copysign(std::min(slant * options.spacing, ring.length / 4), seam.span);
        seam = cut_to(seam.span);
        if (seam.corner) seam.span = std::copysign(ring.length, seam.span);
        seams.push_back(seam);
    }
    return seams;
}

std::vector<Polyline> passes_along(const Ring& ring, const Seam& seam, const Options& options) {
    if (!ring.teeth.empty()) {
        std::vector<Polyline> teeth = ring.teeth;
        if (seam.start > 0) std::ranges::reverse(teeth);
        for (std::size_t i = seam.flipped ? 0 : 1; i < teeth.size(); i += 2) std::ranges::reverse(teeth[i]);
        return teeth;
    }
    Polyline line = along(ring, seam.start, seam.span);
    return with_cut_corners(line, seam.corner, ring.level == 0, options);
}

}  // namespace strandline::fill
