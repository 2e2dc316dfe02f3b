// Parallel lines, part by part, and rings along the outline last.
// Key: everything is turned by -direction, so that lines lie level; `room` is where the rake's centre may be,
// `target` what the lines must cover (with a border: what its rings leave).
#include <fmt/core.h>

#include <algorithm>

#include "path/fill/rings.hpp"

namespace strandline::fill {
namespace {

constexpr int most_directions = 12;     // of the longest edges, beside level and upright
constexpr double line_slack = 0.01;     // of the spacing: a part that is higher by less gets no further line
constexpr double shortest_line = 0.05;  // of the width: shorter ones are left to the border
constexpr double bar_slack = 1e-3;      // of half the width: a bar flush with an edge is inside
constexpr double missing_cost = 3;      // metres raked that a metre not raked counts for
constexpr double turn_cost = 0.5;       // of the width, against metres raked: fewer and longer lines

Regions turned(Regions regions, double angle) {
    const Affine map{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
    for (Region& region : regions) {
        for (Point& p : region.outer) p = apply(map, p);
        for (Polygon& hole : region.holes)
            for (Point& p : hole) p = apply(map, p);
    }
    return regions;
}

struct Row {
    double y, low, high;  // the line's height and the band it answers for
};
/// As few rows as keep the spacing, the first and last flush with the ends: none rakes beyond what is asked
/// for.
std::vector<Row> rows_of(double low, double high, const Options& options) {
    const double between_ends = high - low - options.width;
    if (between_ends <= 0) return {{(low + high) / 2, low, high}};
    const int steps = std::max(1, static_cast<int>(std::ceil(between_ends / options.spacing - line_slack)));
    const double step = between_ends / steps;
    std::vector<Row> rows;
    for (int i = 0; i <= steps; ++i) {
        const double y = low + options.width / 2 + i * step;
        rows.push_back({y, i == 0 ? low : y - step / 2, i == steps ? high : y + step / 2});
    }
    return rows;
}

struct Interval {
    double from, to;
};
/// Where a level line meets the regions. O(corners).
std::vector<Interval> met(const Regions& regions, double y) {
    std::vector<double> xs;
    const auto ring = [&](const Polygon& polygon) {
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            const Point a = polygon[j], b = polygon[i];
            if ((a.y > y) != (b.y > y)) xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    };
    for (const Region& region : regions) {
        ring(region.outer);
        for (const Polygon& hole : region.holes) ring(hole);
    }
    std::ranges::sort(xs);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) intervals.push_back({xs[i], xs[i + 1]});
    return intervals;
}

/// Where the rake's whole bar, upright at height y, lies inside the regions. O(corners log corners).
std::vector<Interval> fits(const Regions& regions, double y, double width) {
    const double half = width / 2 * (1 - bar_slack);
    std::vector<Interval> blocked;
    const auto ring = [&](const Polygon& polygon) {
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            Point a = polygon[j], b = polygon[i];
            if (a.y > b.y) std::swap(a, b);
            if (b.y <= y - half || a.y >= y + half) continue;
            const auto at = [&](double height) { return a.x + (height - a.y) / (b.y - a.y) * (b.x - a.x); };
            const double from = a.y < y - half ? at(y - half) : a.x, to = b.y > y + half ? at(y + half) : b.x;
            blocked.push_back({std::min(from, to), std::max(from, to)});
        }
    };
    for (const Region& region : regions) {
        ring(region.outer);
        for (const Polygon& hole : region.holes) ring(hole);
    }
    std::ranges::sort(blocked, {}, &Interval::from);
    std::vector<Interval> free;
    for (Interval open : met(regions, y)) {
        for (const Interval& wall : blocked) {
            if (wall.to <= open.from) continue;
            if (wall.from >= open.to) break;
            if (wall.from > open.from) free.push_back({open.from, wall.from});
            open.from = std::max(open.from, wall.to);
        }
        if (open.to > open.from) free.push_back(open);
    }
    return free;
}

/// What of the band a part reaches, left to right.
Interval reach(const Polygon& part, const Row& row) {
    Interval whole{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto take = [&](double x) { whole = {std::min(whole.from, x), std::max(whole.to, x)}; };
    for (std::size_t i = 0, j = part.size() - 1; i < part.size(); j = i++) {
        const Point a = part[j], b = part[i];
        if (a.y >= row.low && a.y <= row.high) take(a.x);
        for (double y : {row.low, row.high})
            if ((a.y > y) != (b.y > y)) take(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    return whole;
}

/// The lines of each part, bottom up, each left to right. All parts share one set of rows: where two parts
/// need the same row, their pieces become one line, which goes to the part that needs more of it.
std::vector<std::vector<Polyline>> lines_of(const std::vector<Polygon>& parts, const Regions& inside,
                                            bool rows_shared, const Options& options) {
    struct Piece {
        Interval span;
        std::size_t part;
        double share;
    };
    std::vector<std::vector<Polyline>> lines(parts.size());
    std::vector<Box> boxes;
    Box whole;
    for (const Polygon& part : parts) {
        boxes.push_back(bounds(part));
        whole = united(whole, boxes.back());
    }
    const auto rake = [&](const Row& row, std::size_t from, std::size_t to) {
        std::vector<Interval> open;
        std::vector<Piece> pieces;
        for (std::size_t k = from; k < to; ++k) {
            if (std::min(boxes[k].high.y, row.high) - std::max(boxes[k].low.y, row.low) <=
                line_slack * options.spacing)
                continue;
            if (open.empty()) open = fits(inside, row.y, options.width);
            const Interval wish = reach(parts[k], row);
            Interval best{0, 0};
            for (const Interval& free : open) {
                const Interval both{std::max(free.from, wish.from), std::min(free.to, wish.to)};
                if (both.to - both.from > best.to - best.from) best = both;
            }
            if (best.to - best.from > shortest_line * options.width)
                pieces.push_back({best, k, best.to - best.from});
        }
        std::ranges::sort(pieces, {}, [](const Piece& p) { return std::pair(p.span.from, p.part); });
        std::vector<Piece> merged;
        for (const Piece& piece : pieces) {
            const bool same = !merged.empty() && piece.span.from <= merged.back().span.to;
            if (!same) {
                merged.push_back(piece);
                continue;
            }
            Piece& last = merged.back();
            last.span.to = std::max(last.span.to, piece.span.to);
            if (piece.share > last.share) {
                last.part = piece.part;
                last.share = piece.share;
            }
        }
        for (const Piece& piece : merged)
            lines[piece.part].push_back({{piece.span.from, row.y}, {piece.span.to, row.y}});
    };
    if (rows_shared) {
        for (const Row& row : rows_of(whole.low.y, whole.high.y, options)) rake(row, 0, parts.size());
    } else {
        for (std::size_t k = 0; k < parts.size(); ++k)
            for (const Row& row : rows_of(boxes[k].low.y, boxes[k].high.y, options)) rake(row, k, k + 1);
    }
    std::erase_if(lines, [](const auto& of_part) { return of_part.empty(); });
    return lines;
}

struct Split {
    std::vector<Polygon> parts;  // turned level
    std::optional<std::string> replaced;
};
Split split(const Regions& target, const Options& options) {
    Split result;
    for (const Region& region : target) {
        std::vector<Polygon> parts;
        if (options.partition == Partition::optimal_convex) {
            // Fewer corners than the limit matter more than the last millimetre: thin as far as the rake
            // hides it.
            const Regions plain = simplified({region}, options.width / 50);
            auto convex = plain.size() == 1 ? convex_parts(plain[0]) : convex_parts(region);
            if (convex)
                parts = std::move(*convex);
            else
                result.replaced = convex.error().reason;
        }
        if (parts.empty()) parts = monotone_parts(region, 0);
        for (Polygon& part : parts) {
            if (options.part_inset <= 0) {
                result.parts.push_back(std::move(part));
                continue;
            }
            for (Region& smaller : inset({{std::move(part), {}}}, options.part_inset))
                result.parts.push_back(std::move(smaller.outer));
        }
    }
    return result;
}

/// The least raked length, with turns and what the lines leave bare counted in; of equals the first.
double best_direction(const Region& region, const Regions& target, const Options& options) {
    const Regions plain = simplified({region}, options.width / 4);
    std::vector<std::pair<double, double>> edges;  // -length, direction
    for (const Region& part : plain.empty() ? Regions{region} : plain)
        for (std::size_t i = 0, n = part.outer.size(); i < n; ++i) {
            const Point edge = part.outer[(i + 1) % n] - part.outer[i];
            double direction = heading(edge);
            if (direction < 0) direction += pi;
            if (direction >= pi - 1e-9) direction = 0;
            edges.emplace_back(-length(edge), direction);
        }
    std::ranges::sort(edges);
    std::vector<double> candidates;
    const auto add = [&](double direction) {
        if (std::ranges::none_of(candidates, [&](double c) { return std::abs(c - direction) < 0.01; }))
            candidates.push_back(direction);
    };
    for (const auto& [minus_length, direction] : edges) {
        if (static_cast<int>(candidates.size()) >= most_directions) break;
        add(direction);
    }
    add(0);
    add(pi / 2);
    double best = 0, least = std::numeric_limits<double>::infinity();
    const Regions plain_target = simplified(target, options.width / 50);
    for (double direction : candidates) {
        std::vector<Polygon> parts;
        for (const Region& part : turned(plain_target, -direction))
            for (Polygon& cell : monotone_parts(part, 0)) parts.push_back(std::move(cell));
        double raked = 0, turns = 0;
        for (const auto& lines : lines_of(parts, turned({region}, -direction), true, options))
            for (const Polyline& line : lines) {
                raked += length(line);
                turns += turn_cost * options.width;
            }
        const double missing = std::max(0.0, area(plain_target) / options.width - raked);
        const double cost = raked + turns + missing_cost * missing;
        if (cost < least - 1e-9) {
            least = cost;
            best = direction;
        }
    }
    return best;
}

/// Whether the rake's centre may go straight from a to b.
bool free_way(const Regions& floor, Point a, Point b) {
    const LineParts parts = parted({a, b}, floor);
    double outside = 0;
    for (const Polyline& part : parts.outside) outside += length(part);
    return outside <= 1e-6 * (1 + distance(a, b));
}

/// A part's lines as passes, begun at the first or last line, at its left or right end: the nearest of the
/// four to `here`.
std::vector<Polyline> driven(std::vector<Polyline> lines, Point here, const Regions& floor,
                             const Options& options) {
    double best = std::numeric_limits<double>::infinity();
    bool from_top = false, from_right = false;
    for (bool top : {false, true})
        for (bool right : {false, true}) {
            const Polyline& line = top ? lines.back() : lines.front();
            if (const double d = distance(here, right ? line.back() : line.front()); d < best) {
                best = d;
                from_top = top;
                from_right = right;
            }
        }
    if (from_top) std::ranges::reverse(lines);
    std::vector<Polyline> passes;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Polyline line = (i % 2 == 0) == from_right ? reversed(lines[i]) : lines[i];
        const bool goes_on = options.rake_turns && !passes.empty() &&
                             distance(passes.back().back(), line.front()) < 3 * options.spacing &&
                             free_way(floor, passes.back().back(), line.front());
        if (goes_on)
            passes.back().insert(passes.back().end(), line.begin(), line.end());
        else
            passes.push_back(std::move(line));
    }
    return passes;
}

}  // namespace

std::vector<Pass> zigzag_passes(const Region& region, const std::string& place, const Options& options,
                                Fill& account) {
    const double w = options.width;
    const Regions room = room_for_centre(region, place, options, account);
    if (room.empty()) return {};
    // With a border the lines reach a little into its rings, so that no hairline stays between; without one
    // they serve the whole.
    const Regions target = options.border ? inset(room, 0.495 * w) : Regions{region};
    const double direction = options.direction.value_or(best_direction(region, target, options));
    const Regions level = turned({region}, -direction), floor = inset(turned(room, -direction), -0.01 * w);

    std::vector<std::vector<Polyline>> parts;
    if (options.partition == Partition::none) {
        for (const Region& part : turned(target, -direction)) {
            std::vector<Polyline> lines;
            const Box box = bounds(part);
            for (const Row& row : rows_of(box.low.y, box.high.y, options))
                for (const Interval& piece : met({part}, row.y))
                    for (const Interval& free : fits(level, row.y, w)) {
                        const double from = std::max(piece.from, free.from), to = std::min(piece.to, free.to);
                        if (to - from > shortest_line * w) lines.push_back({{from, row.y}, {to, row.y}});
                    }
            if (!lines.empty()) parts.push_back(std::move(lines));
        }
    } else {
        Split cells = split(turned(target, -direction), options);
        if (cells.replaced)
            account.warnings.push_back(
                {place, fmt::format("{}: the monotone partition is used", *cells.replaced)});
        // Parts that keep a distance from each other cannot share rows: there is sand between them that no
        // row is for.
        parts = lines_of(cells.parts, level, options.part_inset <= 0, options);
    }

    std::vector<Pass> passes;
    const Affine back{
        std::cos(direction), std::sin(direction), -std::sin(direction), std::cos(direction), 0, 0};
    Point here = parts.empty() ? Point{} : parts.front().front().front();
    while (!parts.empty()) {
        const auto away = [&](const std::vector<Polyline>& lines) {
            return std::min({distance(here, lines.front().front()), distance(here, lines.front().back()),
                             distance(here, lines.back().front()), distance(here, lines.back().back())});
        };
        const auto next = std::ranges::min_element(parts, {}, away);
        for (Polyline& line : driven(std::move(*next), here, floor, options)) {
            here = line.back();
            const double turn =
                options.turn_radius > 0 ? std::min(options.turn_radius, options.spacing / 2) : 0;
            line = rounded(line, turn);
            for (Point& p : line) p = apply(back, p);
            passes.push_back({{}, std::move(line)});
        }
        parts.erase(next);
    }

    if (options.border) {
        std::vector<Ring> holes, outers;
        for (const Region& part : simplified(room, std::min(options.tolerance, w / 200))) {
            outers.push_back(ring_of(part.outer, 0, true));
            for (const Polygon& hole : part.holes) holes.push_back(ring_of(hole, 0, true));
        }
        for (std::vector<Ring>* rings : {&holes, &outers})
            while (!rings->empty()) {
                const Point from = passes.empty() ? rings->front().line.front() : passes.back().line.back();
                const auto next = std::ranges::min_element(
                    *rings, {}, [&](const Ring& ring) { return nearest(ring, from).distance; });
                const Polyline line = along(*next, nearest(*next, from).s, next->length);
                passes.push_back({{}, rounded(line, options.round_corners ? options.turn_radius : 0)});
                rings->erase(next);
            }
    }
    return passes;
}

}  // namespace strandline::fill
