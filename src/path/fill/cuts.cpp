// Where parallel lines of several directions waste less than those of one.
#include "path/fill/cuts.hpp"

#include <algorithm>

#include "path/fill/waste.hpp"

namespace strandline::fill {
namespace {

constexpr double cut_beyond = 0.3;     // of the width: cuts found in the plain outline must part the true one
constexpr double sharp_turn = pi / 3;  // a reflex corner that turns less is a chord's, of an arc
constexpr int most_cuts = 12;          // in one area, found here
constexpr std::size_t most_corners = 120, most_holes = 4, most_reflex = 40, most_pairs = 150;

struct Halving {
    Regions parts;
    Point a, b;  ///< the cut's ends
};

/// A polygon cut by the chord from `from` along `along`; if `from` is not a corner, both ways.
std::optional<Halving> halved(const Polygon& p, Point from, Point along, double least) {
    const std::size_t n = p.size();
    struct Hit {
        double t;
        std::size_t edge;
        Point at;
    };
    std::optional<std::size_t> corner;
    std::optional<Hit> ahead, behind;
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = p[i], edge = p[(i + 1) % n] - a;
        if (distance(a, from) < 1e-9) corner = i;
        const double across = cross(along, edge);
        if (std::abs(across) < 1e-12) continue;
        const double share = cross(a - from, along) / across, t = cross(a - from, edge) / across;
        if (share < 0 || share >= 1) continue;
        if (t > 1e-7 && (!ahead || t < ahead->t)) ahead = {t, i, a + share * edge};
        if (t < -1e-7 && (!behind || t > behind->t)) behind = {t, i, a + share * edge};
    }
    if (!ahead || (!corner && !behind)) return std::nullopt;
    const Point start = corner ? from : behind->at;
    if (!contains(p, between(start, ahead->at, 0.5)) || !contains(p, between(start, ahead->at, 0.01)))
        return std::nullopt;
    const std::size_t first = corner ? *corner : behind->edge;
    Halving cut{{}, start, ahead->at};
    Polygon one{ahead->at}, other{start};
    for (std::size_t i = (ahead->edge + 1) % n;; i = (i + 1) % n) {
        one.push_back(p[i]);
        if (i == first) break;
    }
    one.push_back(start);
    for (std::size_t i = (first + 1) % n;; i = (i + 1) % n) {
        other.push_back(p[i]);
        if (i == ahead->edge) break;
    }
    other.push_back(ahead->at);
    for (Polygon* half : {&one, &other}) {
        *half = without_duplicate_corners(*half, 1e-9);
        if (half->size() < 3 || signed_area(*half) < least) return std::nullopt;
        cut.parts.push_back({std::move(*half), {}});
    }
    return cut;
}

/// The cuts worth trying: through reflex corners on along their edges, across, and to one another. An area
/// with holes is cut right through, along its long edges.
std::vector<Halving> halvings(const Region& area, const Options& options) {
    const double least = least_part * options.width * options.width;
    std::vector<Halving> cuts;
    if (area.holes.size() > most_holes) return cuts;
    if (!area.holes.empty()) {
        const auto through = [&](const Polygon& polygon) {
            for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
                const Point a = polygon[j], b = polygon[i];
                if (distance(a, b) < options.width) continue;
                for (const auto& [from, to] : {std::pair{a, b}, std::pair{a, a + left_normal(b - a)},
                                               std::pair{b, b + left_normal(b - a)}}) {
                    Halves halves = strandline::cut({area}, from, to);
                    if (halves.left.empty() || halves.right.empty()) continue;
                    const double far = length(bounds(area).high - bounds(area).low);
                    const Point along = normalized(to - from);
                    Halving cut{std::move(halves.left), from - far * along, from + far * along};
                    cut.parts.insert(cut.parts.end(), halves.right.begin(), halves.right.end());
                    cuts.push_back(std::move(cut));
                }
            }
        };
        for (const Polygon& hole : area.holes) through(hole);
        return cuts;
    }
    const Polygon& p = area.outer;
    const std::size_t n = p.size();
    std::vector<std::size_t> reflex;
    for (std::size_t i = 0; i < n; ++i)
        if (cross(p[i] - p[(i + n - 1) % n], p[(i + 1) % n] - p[i]) < 0) reflex.push_back(i);
    if (reflex.size() > most_reflex) return cuts;
    const auto add = [&](Point from, Point along) {
        if (auto cut = halved(p, from, along, least)) cuts.push_back(std::move(*cut));
    };
    for (std::size_t i : reflex) {
        const Point in = normalized(p[i] - p[(i + n - 1) % n]), out = normalized(p[(i + 1) % n] - p[i]);
        for (Point along : {in, -out, left_normal(in), left_normal(out)}) add(p[i], along);
        if (reflex.size() * reflex.size() <= 2 * most_pairs)
            for (std::size_t k : reflex)
                if (k > i) add(p[i], normalized(p[k] - p[i]));
    }
    return cuts;
}

/// The fewest convex parts of an outline, and their edges that are no edges of it.
struct Convex {
    struct Joint {
        std::size_t a, b;  ///< parts
        Polyline edge;
        bool at_arc;  ///< neither end is a corner of the area's own: they lie on arcs
    };
    std::vector<Polygon> parts;
    std::vector<Joint> joints;
};
Convex with_joints(std::vector<Polygon> parts, const Polygon& outline) {
    Convex convex{std::move(parts), {}};
    const auto sharp = [&](Point p) {
        const std::size_t n = outline.size();
        const auto i = static_cast<std::size_t>(std::ranges::find(outline, p) - outline.begin());
        if (i == n) return false;
        const Point in = p - outline[(i + n - 1) % n], out = outline[(i + 1) % n] - p;
        return std::atan2(cross(in, out), dot(in, out)) < -sharp_turn;
    };
    const auto& all = convex.parts;
    const auto join = [&](std::size_t k, Point from, Point to) {
        for (std::size_t other = k + 1; other < all.size(); ++other)
            for (std::size_t i = 0, j = all[other].size() - 1; i < all[other].size(); j = i++)
                if (all[other][j] == to && all[other][i] == from)
                    convex.joints.push_back({k, other, {from, to}, !sharp(from) && !sharp(to)});
    };
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t i = 0, j = all[k].size() - 1; i < all[k].size(); j = i++)
            join(k, all[k][j], all[k][i]);
    return convex;
}

/// Which parts are raked together, by number: those that only an arc's chords part, where one direction
/// serves both at no more waste than the cut between them costs.
std::vector<std::size_t> merged(const Convex& convex, const Options& options) {
    std::vector<std::size_t> group(convex.parts.size());
    std::vector<Region> whole;
    std::vector<double> waste;
    const auto waste_in = [&](const Region& part) {
        return least_waste(part, options.direction, options).area;
    };
    for (std::size_t k = 0; k < group.size(); ++k) {
        group[k] = k;
        whole.push_back({convex.parts[k], {}});
        waste.push_back(waste_in(whole[k]));
    }
    struct Merger {
        std::size_t a = 0, b = 0;
        Region whole;
        double waste = 0, saved = 0;
    };
    while (true) {
        Merger best;
        for (const Convex::Joint& joint : convex.joints) {
            const std::size_t a = group[joint.a], b = group[joint.b];
            if (a == b || !joint.at_arc) continue;
            const Regions both = united({whole[a]}, {whole[b]});
            if (both.size() != 1) continue;
            const double together = waste_in(both[0]);
            const double saved = waste[a] + waste[b] + cut_cost(options) - together;
            if (saved > best.saved + 1e-9) best = {a, b, both[0], together, saved};
        }
        if (best.saved <= 0) return group;
        std::ranges::replace(group, best.b, best.a);
        whole[best.a] = std::move(best.whole);
        waste[best.a] = best.waste;
    }
}

}  // namespace

std::vector<Polyline> fitted_cuts(const Region& plain, const Options& options) {
    std::vector<Polyline> cuts;
    Regions open{plain};
    while (!open.empty() && static_cast<int>(cuts.size()) < most_cuts) {
        const Region area = std::move(open.back());
        open.pop_back();
        if (area.outer.size() > most_corners) continue;
        double least = least_waste(area, options.direction, options).area - cut_cost(options);
        std::optional<Halving> best;
        for (Halving& cut : halvings(area, options)) {
            double sum = 0;
            for (const Region& part : cut.parts) sum += least_waste(part, options.direction, options).area;
            if (sum >= least - 1e-9) continue;
            least = sum;
            best = std::move(cut);
        }
        if (!best) continue;
        const Point over = cut_beyond * options.width * normalized(best->b - best->a);
        for (Polyline& piece : parted({best->a, best->b}, {area}).inside)
            cuts.push_back({piece.front() - over, piece.back() + over});
        open.insert(open.end(), best->parts.rbegin(), best->parts.rend());
    }
    return cuts;
}

Outcome<std::vector<Polyline>> convex_cuts(const Region& plain, const Options& options) {
    auto found = convex_parts(plain);
    if (!found) return tl::unexpected(found.error());
    const Convex convex = with_joints(std::move(*found), plain.outer);
    const std::vector<std::size_t> group = merged(convex, options);
    std::vector<Polyline> cuts;
    for (const Convex::Joint& joint : convex.joints) {
        if (group[joint.a] == group[joint.b]) continue;
        const Point over = cut_beyond * options.width * normalized(joint.edge[1] - joint.edge[0]);
        cuts.push_back({joint.edge[0] - over, joint.edge[1] + over});
    }
    return cuts;
}

}  // namespace strandline::fill
