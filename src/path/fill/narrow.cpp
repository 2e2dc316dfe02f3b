// Arms: stretches of the medial axis with a disc smaller than the rake, cut at what is not a corridor.
#include "path/fill/narrow.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace strandline::fill {
namespace {

constexpr double least_bare = 0.1;  // of width^2: corners of over 80 degrees leave less
constexpr double axis_step = 0.1;   // of the width: between samples of the outline
constexpr double axis_margin = 1;   // of the width, about bare sand: the islands between arms lie within
constexpr double thinning = 0.02;   // of the width
constexpr double arcs = 0.01;       // of the width: chord errors where only areas are asked for
constexpr double reach = 0.51;      // of the width, from a body: the margin holds the chords' errors
constexpr double overlap = 0.1;     // of the width: an arm that ends on another reaches that far into it
// Of the width: the radius of the disc that fits where two corridors as wide as the rake cross.
constexpr double widest_disc = 0.72;
constexpr double widest_island = 1.3;  // of the width: along a body that is only such a crossing
constexpr double at_body = 0.75;       // of the width: so near to a body's room an arm ends on it

/// The line from its end on to the outline, straight: an arm's pass runs to its end.
Point reached_outline(const Region& region, Point from, Point direction, double farthest) {
    double least = farthest;
    const auto ring = [&](const Polygon& polygon) {
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
            if (const auto hit = crossing(from, from + farthest * direction, polygon[j], polygon[i]))
                least = std::min(least, hit->s * farthest);
    };
    ring(region.outer);
    for (const Polygon& hole : region.holes) ring(hole);
    return from + least * direction;
}

double away_from(const Region& body, Point p) {
    return contains(body, p) ? 0 : distance_to_outline(body.outer, p);
}

int body_near(const NarrowParts& narrow, Point p, double farthest) {
    int nearest = Arm::free;
    for (std::size_t k = 0; k < narrow.bodies.size(); ++k) {
        if (narrow.crossed[k]) continue;
        const double d = away_from(narrow.bodies[k], p);
        if (d < farthest) farthest = d, nearest = static_cast<int>(k);
    }
    return nearest;
}

/// Where a corridor that is narrower than the rake bends or branches, a disc as wide as the rake may fit.
bool is_island(const Region& body, double width) {
    const Box box = bounds(body);
    return std::hypot(box.width(), box.height()) < widest_island * width &&
           inset({body}, (widest_disc - 0.5) * width).empty();
}

/// Edges hardly longer than nothing, of junctions of four and more ways, are taken out with one of their
/// nodes.
Axis contracted(Axis axis, double shortest) {
    std::vector<int> same(axis.nodes.size());
    for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<int>(i);
    const auto root = [&](int i) {
        while (same[i] != i) i = same[i];
        return i;
    };
    for (const Axis::Edge& edge : axis.edges)
        if (distance(axis.nodes[edge.a].at, axis.nodes[edge.b].at) < shortest) {
            const auto [low, high] = std::minmax({root(edge.a), root(edge.b)});
            same[high] = low;
        }
    std::set<std::pair<int, int>> known;
    std::erase_if(axis.edges, [&](Axis::Edge& edge) {
        edge.a = root(edge.a);
        edge.b = root(edge.b);
        return edge.a == edge.b || !known.insert(std::minmax({edge.a, edge.b})).second;
    });
    return axis;
}

/// The axis of what is narrower than the rake, with the islands between, in steps of axis_step.
Axis narrow_axis(const Regions& plain, const Regions& bare, const NarrowParts& narrow, double width) {
    std::vector<Box> near;
    for (const Region& part : bare) near.push_back(grown(bounds(part), axis_margin * width));
    std::vector<const Region*> islands;
    for (const Region& body : narrow.bodies)
        if (is_island(body, width)) islands.push_back(&body);
    const auto at_island = [&](Point p) {
        return std::ranges::any_of(
            islands, [&](const Region* body) { return away_from(*body, p) < thinning * width; });
    };
    Axis axis;
    for (const Region& region : plain) {
        const MedialAxis whole = medial_axis(region, axis_step * width, near, axis_margin * width);
        const int offset = static_cast<int>(axis.nodes.size());
        axis.nodes.insert(axis.nodes.end(), whole.nodes.begin(), whole.nodes.end());
        for (const MedialAxis::Edge& edge : whole.edges) {
            const auto &a = whole.nodes[edge.from], &b = whole.nodes[edge.to];
            const double length = distance(a.at, b.at);
            if (std::min(a.radius, b.radius) > widest_disc * width) continue;
            // A disc grows along the axis by the cosine of half the angle between its feet.
            const double growth = length > 0 ? std::abs(a.radius - b.radius) / length : 0;
            const double opening = 2 * std::acos(std::min(1.0, growth));
            const int steps = std::max(1, static_cast<int>(std::ceil(length / (axis_step * width))));
            int last = offset + edge.from;
            for (int k = 1; k <= steps; ++k) {
                const double t = (k - 0.5) / steps, radius = a.radius + t * (b.radius - a.radius);
                const int next = k == steps ? offset + edge.to : static_cast<int>(axis.nodes.size());
                if (k < steps) {
                    const double share = static_cast<double>(k) / steps;
                    axis.nodes.push_back(
                        {between(a.at, b.at, share), a.radius + share * (b.radius - a.radius)});
                }
                if (radius < (0.5 + thinning / 2) * width || at_island(between(a.at, b.at, t)))
                    axis.edges.push_back({last, next, opening});
                last = next;
            }
        }
    }
    return contracted(std::move(axis), thinning * width);
}

Arm arm_of(const Axis& axis, const Trail& trail, const Region& region, const NarrowParts& narrow,
           const std::map<std::pair<int, int>, double>& openings, const Options& options) {
    const double width = options.width;
    Arm arm;
    std::vector<int> nodes = trail.nodes;
    const auto opening = [&](std::size_t i) { return openings.at(std::minmax({nodes[i], nodes[i + 1]})); };
    const bool closed = nodes.front() == nodes.back();
    arm.start = trail.cut_start || closed ? Arm::free
                                          : body_near(narrow, axis.nodes[nodes.front()].at, at_body * width);
    arm.end =
        trail.cut_end || closed ? Arm::free : body_near(narrow, axis.nodes[nodes.back()].at, at_body * width);
    // Where the sides part or run into a corner the arm is over.
    if (!closed && !trail.cut_end)
        while (nodes.size() > 2 && opening(nodes.size() - 2) < parallel_sides) nodes.pop_back();
    std::size_t first = 0;
    if (!closed && !trail.cut_start)
        while (first + 2 < nodes.size() && opening(first) < parallel_sides) ++first;
    nodes.erase(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(first));
    arm.least = std::numeric_limits<double>::infinity();
    for (int node : nodes) {
        arm.line.push_back(axis.nodes[node].at);
        arm.least = std::min(arm.least, 2 * axis.nodes[node].radius);
        arm.most = std::max(arm.most, 2 * axis.nodes[node].radius);
    }
    arm.aside = aside_of(axis, nodes, options);
    arm.line = thinned(arm.line, thinning * width);
    const double whole = length(arm.line), back = std::max(0.0, width / 2 - overlap * width);
    if (trail.cut_start && trail.cut_end && whole > 2 * back + overlap * width)
        arm.line = slice(arm.line, back, whole - back);
    else if (trail.cut_start && whole > back + overlap * width)
        arm.line = slice(arm.line, back, whole);
    else if (trail.cut_end && whole > back + overlap * width)
        arm.line = slice(arm.line, 0, whole - back);
    const auto lengthened = [&](Polyline& line) {  // at its end
        const Point last = line.back(), inner = point_at(line, std::max(0.0, length(line) - width / 2));
        const Point tip = reached_outline(region, last, normalized(last - inner), arm.most);
        if (distance(tip, last) > thinning * width) line.push_back(tip);
    };
    if (!closed && !trail.cut_end && arm.end == Arm::free) lengthened(arm.line);
    if (!closed && !trail.cut_start && arm.start == Arm::free) {
        std::ranges::reverse(arm.line);
        lengthened(arm.line);
        std::ranges::reverse(arm.line);
    }
    return arm;
}

}  // namespace

NarrowParts narrow_parts(const Region& region, const Options& options) {
    const double w = options.width;
    Regions plain = simplified({region}, thinning * w);
    if (plain.empty()) plain = {region};
    NarrowParts narrow{inset(plain, w / 2, arcs * w), {}, {}, {}, {}};
    narrow.crossed.assign(narrow.bodies.size(), false);
    narrow.raked = narrow.crossed;
    narrow.bare = subtracted(plain, inset(narrow.bodies, -reach * w, arcs * w));
    Regions bare = narrow.bare;
    std::erase_if(bare, [&](const Region& part) { return area(part) < least_bare * w * w; });
    if (bare.empty()) return narrow;
    const Axis axis = narrow_axis(plain, bare, narrow, w);
    std::map<std::pair<int, int>, double> openings;
    for (const auto& edge : axis.edges) openings[std::minmax({edge.a, edge.b})] = edge.opening;
    const std::vector<Trail> trails = trails_of(axis, w);
    const int bodies = static_cast<int>(narrow.bodies.size());
    for (int k = 0; k < bodies; ++k)
        narrow.crossed[k] =
            is_island(narrow.bodies[k], w) && std::ranges::any_of(trails, [&](const Trail& trail) {
                return std::ranges::any_of(trail.nodes, [&](int node) {
                    return away_from(narrow.bodies[k], axis.nodes[node].at) < axis_step * w;
                });
            });
    for (const Trail& trail : trails)
        narrow.arms.push_back(arm_of(axis, trail, region, narrow, openings, options));
    std::vector<Polyline> lines;
    for (const Arm& arm : narrow.arms) lines.push_back(arm.line);
    for (int k = 0; k < bodies; ++k)
        narrow.raked[k] =
            narrow.crossed[k] && area(subtracted(inset({narrow.bodies[k]}, -w / 2),
                                                 swept(lines, false, w / 2, Cap::flat))) < least_bare * w * w;
    // What a trail that was cut at a junction rests on: the trail that goes through there.
    for (std::size_t k = 0; k < trails.size(); ++k)
        for (bool start : {true, false}) {
            if (!(start ? trails[k].cut_start : trails[k].cut_end)) continue;
            const int node = start ? trails[k].nodes.front() : trails[k].nodes.back();
            for (std::size_t j = 0; j < trails.size(); ++j) {
                const Trail& other = trails[j];
                const bool ends_too = (other.cut_start && other.nodes.front() == node) ||
                                      (other.cut_end && other.nodes.back() == node);
                if (j != k && !ends_too && std::ranges::find(other.nodes, node) != other.nodes.end())
                    (start ? narrow.arms[k].start : narrow.arms[k].end) = bodies + static_cast<int>(j);
            }
        }
    return narrow;
}

std::vector<Pass> with_arms(std::vector<Pass> passes, const NarrowParts& narrow, const Options& options) {
    if (narrow.arms.empty()) return passes;
    // Exactly as wide as the rake: the style's passes lie along the middle of what the coarse inset sees as
    // arms alone.
    if (narrow.bodies.empty()) passes.clear();
    const int bodies = static_cast<int>(narrow.bodies.size()),
              all = bodies + static_cast<int>(narrow.arms.size());
    std::vector<std::vector<int>> beside(all);  // bodies and arms that touch
    for (int k = bodies; k < all; ++k)
        for (int other : {narrow.arms[k - bodies].start, narrow.arms[k - bodies].end})
            if (other != Arm::free) {
                beside[k].push_back(other);
                beside[other].push_back(k);
            }
    std::vector<std::vector<Pass>> of_body(bodies);
    for (Pass& pass : passes) {
        int body = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < bodies; ++k) {
            const double d = away_from(narrow.bodies[k], pass.line.back());
            if (d < least) least = d, body = k;
        }
        // A pass may come from an island and go on to a body.
        const auto beside_body = [&](Point p) {
            return away_from(narrow.bodies[body], p) < options.width / 2;
        };
        if (!narrow.raked[body] || !std::ranges::all_of(pass.line, beside_body))
            of_body[body].push_back(std::move(pass));
    }
    std::vector<int> roots(all);
    for (int k = 0; k < all; ++k) roots[k] = k;
    std::ranges::stable_sort(roots, std::greater{}, [&](int k) {  // bodies first, the largest of all first
        return k < bodies ? std::pair(1, area(narrow.bodies[k]))
                          : std::pair(0, length(narrow.arms[k - bodies].line));
    });

    std::vector<Pass> ordered;
    std::vector<bool> done(all, false);
    const auto rake_arm = [&](int k, int towards, bool beyond) {
        const Arm& arm = narrow.arms[k - bodies];
        if (arm.line.empty()) return;
        const Polyline middle = moved_aside(arm.line, arm.aside);
        const Polyline line = towards != Arm::free && arm.start == towards ? reversed(middle) : middle;
        Polyline way;  // there is none but through the arm, when nothing lies beyond it
        if (!beyond && !ordered.empty()) way.assign(line.rbegin(), line.rend() - 1);
        ordered.push_back({std::move(way), rounded(line, options.round_corners ? options.turn_radius : 0)});
    };
    // Depth first from each root, written down on the way back.
    struct Visit {
        int what, from;
        std::size_t next = 0;
        bool beyond = false;
    };
    for (int root : roots) {
        if (done[root]) continue;
        done[root] = true;
        std::vector<Visit> open{{root, Arm::free}};
        while (!open.empty()) {
            Visit& here = open.back();
            if (here.next < beside[here.what].size()) {
                const int child = beside[here.what][here.next++];
                if (done[child]) continue;
                done[child] = here.beyond = true;
                open.push_back({child, here.what});
                continue;
            }
            if (here.what >= bodies)
                rake_arm(here.what, here.from, here.beyond);
            else
                std::ranges::move(of_body[here.what], std::back_inserter(ordered));
            open.pop_back();
        }
    }
    return ordered;
}

}  // namespace strandline::fill
