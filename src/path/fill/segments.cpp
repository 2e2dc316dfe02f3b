// What is raked by one set of parallel lines, and in which direction.
#include <fmt/core.h>

#include <algorithm>

#include "path/fill/waste.hpp"
#include "path/fill/zigzag.hpp"

namespace strandline::fill {
namespace {

constexpr double plain_share = 0.25;  // of the width: corners that matter to where an area is cut
constexpr double cut_share = 0.001;   // of the width: how wide a cut is
constexpr double cut_beyond = 0.3;    // of the width: cuts found in the plain outline must part the true one
constexpr double least_part = 0.05;   // of width^2: smaller parts are left to their neighbours' overlap
constexpr double cut_cost = 0.3;      // of width^2: a cut costs a way and ends of lines
constexpr std::size_t tried_directions = 3;
constexpr double strip_share = 1.5;  // of the width: the border's strip belongs to the segment beside it
constexpr int most_cuts = 12;        // in one area, found here
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

/// Cuts an area where that wastes less than one direction for all of it does, again and again.
std::vector<Polyline> fitted_cuts(const Region& whole, const Options& options) {
    std::vector<Polyline> cuts;
    Regions open{whole};
    while (!open.empty() && static_cast<int>(cuts.size()) < most_cuts) {
        const Region area = std::move(open.back());
        open.pop_back();
        if (area.outer.size() > most_corners) continue;
        double least =
            least_waste(area, options.direction, options).area - cut_cost * options.width * options.width;
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

Regions without_line(const Regions& regions, const Polyline& cut, const Options& options) {
    return subtracted(regions, swept({cut}, false, cut_share * options.width / 2, Cap::square));
}

/// What the user's cuts leave in one piece each; every cut must part something.
Regions cut_up(Regions target, const std::string& place, const Options& options, Fill& account) {
    for (std::size_t i = 0; i < options.cuts.size(); ++i) {
        if (options.cuts[i].size() < 2) continue;
        Regions parts = without_line(target, options.cuts[i], options);
        if (parts.size() > target.size())
            target = std::move(parts);
        else
            account.warnings.push_back(
                {place, fmt::format("cut {} parts nothing of it: draw it from edge to edge", i + 1)});
    }
    return target;
}

Region plain_of(const Region& area, const Options& options) {
    const Regions plain = simplified({area}, plain_share * options.width);
    return plain.size() == 1 ? plain[0] : area;
}

/// The part with the best direction by its true lines, of those that are best by its edges.
Segment directed(Region part, const Options& options) {
    Segment best{{std::move(part)}, 0};
    double least = std::numeric_limits<double>::infinity();
    Segment trial{best.target, 0};
    for (const Waste& waste :
         least_wastes(plain_of(best.target[0], options), options.direction, tried_directions, options)) {
        trial.direction = waste.direction;
        const double area = options.direction ? 0 : waste_of(trial, options);
        if (area >= least - 1e-9) continue;
        least = area;
        best.direction = waste.direction;
    }
    return best;
}

/// The segments of one piece where that wastes less than one direction for all of it.
std::vector<Segment> fitted_segments(const Region& piece, const Options& options) {
    std::vector<Segment> whole{directed(piece, options)};
    const std::vector<Polyline> cuts = fitted_cuts(plain_of(piece, options), options);
    if (cuts.empty()) return whole;
    Regions cut{piece};
    for (const Polyline& line : cuts) cut = without_line(cut, line, options);
    std::vector<Segment> parts;
    double waste = cut_cost * options.width * options.width * static_cast<double>(cuts.size());
    for (Region& part : cut) {
        if (area(part) < least_part * options.width * options.width) continue;
        parts.push_back(directed(std::move(part), options));
        waste += waste_of(parts.back(), options);
    }
    return waste < waste_of(whole[0], options) ? parts : whole;
}

/// What may have a direction or a style of its own: a part of a piece that the cuts leave.
struct Part {
    Region region;
    std::optional<double> direction = {};  ///< that of the piece it is of
};

std::vector<Part> parts_of(const Regions& target, const std::string& place, const Options& options,
                           Fill& account) {
    std::vector<Part> parts;
    for (const Region& piece : cut_up(target, place, options, account)) {
        Partition partition = options.partition;
        if (partition == Partition::optimal_convex) {
            // Fewer corners than the limit matter more than the last millimetre: thin as far as the rake
            // hides it.
            const Regions plain = simplified({piece}, options.width / 50);
            auto convex = convex_parts(plain.size() == 1 ? plain[0] : piece);
            if (convex) {
                for (Polygon& part : *convex) parts.push_back({{std::move(part), {}}});
                continue;
            }
            account.warnings.push_back(
                {place, fmt::format("{}: the monotone partition is used", convex.error().reason)});
            partition = Partition::monotone;
        }
        // Parts in which every line is in one piece share their rows, unless sand is to stay between them:
        // rows for each by itself would round their number up in every part.
        if (partition == Partition::monotone && options.part_inset > 0) {
            const double direction = directed(piece, options).direction;
            for (Polygon& part : monotone_parts(piece, direction))
                parts.push_back({{std::move(part), {}}, direction});
        } else {
            parts.push_back({piece});
        }
    }
    return parts;
}

double distance_to(const Region& region, Point p) {
    if (contains(region, p)) return 0;
    double least = distance_to_outline(region.outer, p);
    for (const Polygon& hole : region.holes) least = std::min(least, distance_to_outline(hole, p));
    return least;
}

/// What is chosen for each part. A choice beside the parts, in the border's strip, is for the nearest one.
std::vector<SegmentChoice> chosen(const std::vector<Part>& parts, const Region& region,
                                  const std::string& place, const Options& options, Fill& account) {
    std::vector<SegmentChoice> of_part(parts.size());
    for (std::size_t i = 0; i < options.segments.size(); ++i) {
        const SegmentChoice& choice = options.segments[i];
        double least = strip_share * options.width;
        SegmentChoice* best = nullptr;
        for (std::size_t k = 0; contains(region, choice.at) && k < parts.size(); ++k)
            if (const double d = distance_to(parts[k].region, choice.at); d < least)
                least = d, best = &of_part[k];
        if (!best) {
            account.warnings.push_back(
                {place, fmt::format("segment choice {} is for ({:.2f}, {:.2f}), which lies in no segment of "
                                    "it: name a point inside of one",
                                    i + 1, choice.at.x, choice.at.y)});
            continue;
        }
        if (choice.direction) best->direction = choice.direction;
        if (choice.style) best->style = choice.style;
    }
    return of_part;
}

}  // namespace

std::vector<Segment> segments_of(const Region& region, const Regions& target, const std::string& place,
                                 const Options& options, Fill& account) {
    std::vector<Segment> segments;
    const auto add = [&](Segment segment) {
        if (options.part_inset > 0) segment.target = inset(segment.target, options.part_inset);
        if (!segment.target.empty()) segments.push_back(std::move(segment));
    };
    std::vector<Part> parts = parts_of(target, place, options, account);
    const std::vector<SegmentChoice> choices = chosen(parts, region, place, options, account);
    Options own = options;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto& [part, direction] = parts[i];
        own.direction = choices[i].direction ? choices[i].direction : options.direction;
        if (choices[i].style.value_or(Style::zigzag) != Style::zigzag)
            add({{std::move(part)}, 0, choices[i].style});
        else if (direction && !choices[i].direction)
            add({{std::move(part)}, *direction});
        else if (options.partition == Partition::fitted)
            for (Segment& segment : fitted_segments(part, own)) add(std::move(segment));
        else
            add(directed(std::move(part), own));
    }
    return segments;
}

}  // namespace strandline::fill
