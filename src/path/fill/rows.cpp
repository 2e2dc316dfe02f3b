// The parallel lines of one segment.
// Key: everything is turned by -direction, so that lines lie level. A row's band is the sand it answers for.
#include <algorithm>

#include "path/fill/profiles.hpp"
#include "path/fill/waste.hpp"
#include "path/fill/zigzag.hpp"

namespace strandline::fill {
namespace {

constexpr double bar_slack = 1e-3;  // of the width: a bar flush with an edge is inside
constexpr double least_share =
    0.06;                            // of a band: rows that would rake less are left to the neighbours' edges
constexpr double full_share = 0.95;  // of a band: less anywhere in a line, and it goes to the middle of that
constexpr double shortest_line = 0.1;  // of the width: shorter ones are left to the border
constexpr double missing_cost = 3;     // metres raked that a metre not raked counts for
constexpr double end_gap_cost = 2;     // the same at line ends
constexpr double half_cost =
    0.5;  // metres raked that a metre counts for in a band less than half to be raked
constexpr double line_slack = 0.01;    // of the spacing: an area that is higher by less gets no further row
constexpr int most_phases = 6;         // edges along the lines that rows are tried flush with
constexpr double bare_budget = 0.003;  // of the segment: what line ends at slanted edges may leave
// Shares of a band at which a line ends, best first: half way gap and overlap are least together, and nothing
// that reaches less than half into the border's pass is driven over by it.
constexpr double end_shares[] = {0.5, 0.42, 0.35, 0.28, 0.21, 0.14, 0.07, 0.02};
constexpr int absolute_shares = 3;                       // tried of the whole band first
constexpr double least_slant = 0.27, most_slant = 1.75;  // of ends the bar turns at: tangents of 15, 60 deg
constexpr double steep_slant = 1;                        // 45 degrees
constexpr double turn_step = 0.04;                       // of the width, driven after turning

/// Where a line ends: at a share of its band, or, so that no row is left out, of the band's highest place
/// nearby.
struct Ends {
    double share;
    bool of_highest;
};
std::vector<Interval> wanted(const std::vector<Knot>& profile, double height, Ends ends) {
    if (!ends.of_highest) return above(profile, ends.share * height);
    std::vector<Interval> lines;
    for (const Interval& piece : above(profile, 1e-6 * height)) {
        const double most = highest(profile, piece);
        if (most < least_share * height) continue;
        for (const Interval& line : above(profile, std::max(ends.share * most, 1e-6 * height)))
            if (line.to > piece.from && line.from < piece.to)
                lines.push_back({std::max(line.from, piece.from), std::min(line.to, piece.to)});
    }
    return lines;
}

/// The bar turns flush with an edge at a line's end where the rake is lifted after it: one that goes on
/// turns anyway. How far the edge leans there, 0: no turn.
double turn_at_end(const std::vector<Portion>& portions, double x, double y, double h,
                   const Options& options) {
    if (options.turn_radius > 0 || options.rake_turns || options.one_stroke) return 0;
    const double slant = slant_at(portions, x, y, h);
    return std::abs(slant) < least_slant ? 0 : std::clamp(slant, -most_slant, most_slant);
}
/// What such a turn rakes beyond an end at `share` of a band.
double turned_area(double lean, double share, double h) {
    return share * share * h * h / 2 * std::atan(std::abs(lean));
}

/// Overlap and bare sand of the rows, m^2, weighed.
double waste_of(const Regions& target, const Bands& bands, const Options& options) {
    double waste = 0, y = bands.low + bands.height / 2 - bands.pitch;
    for (const auto& portions : portions_of(target, bands)) {
        y += bands.pitch;
        const std::vector<Knot> profile = profile_of(portions);
        if (profile.empty()) continue;
        double left = integral(profile, profile.front().x, profile.back().x);  // by rows not raked at all
        for (const Interval& piece : above(profile, 1e-6 * bands.height))
            if (highest(profile, piece) >= least_share * bands.height)
                left -= integral(profile, piece.from, piece.to);
        double raked = 0, served = 0, half = 0, turned_flush = 0;
        for (const Interval& line : wanted(profile, bands.height, {end_shares[0], true})) {
            raked += bands.height * (line.to - line.from);
            served += integral(profile, line.from, line.to);
            half += bands.height * (line.to - line.from);
            waste +=
                line_cost(options) + std::max(0.0, options.spacing - bands.pitch) * (line.to - line.from);
            for (double x : {line.from, line.to})
                turned_flush += turned_area(turn_at_end(portions, x, y, bands.height, options), end_shares[0],
                                            bands.height);
            // Less than half a band: the border's own pass would go over raked sand.
            for (const Interval& full : above(profile, bands.height / 2))
                half -=
                    bands.height * std::max(0.0, std::min(full.to, line.to) - std::max(full.from, line.from));
        }
        const double ends =
            integral(profile, profile.front().x, profile.back().x) - left - served - turned_flush;
        waste += raked - served + missing_cost * left + end_gap_cost * std::max(0.0, ends) + half_cost * half;
    }
    return waste;
}

struct Layout {
    Bands bands;
    double waste;
};
/// Rows a spacing apart, flush with the edge along the lines that wastes least. Without a border the first
/// and the last row are flush with the ends and the others between: none may reach beyond.
Layout layout_of(const Regions& target, const Options& options) {
    const Box box = bounds(target);
    const double s = options.spacing;
    if (!options.border) {
        const double between_ends = box.height() - options.width;
        Bands bands{box.low.y, box.height(), box.height(), 1};
        if (between_ends <= 0) return {bands, waste_of(target, bands, options)};
        const int steps = std::max(1, static_cast<int>(std::ceil(between_ends / s - line_slack)));
        const double pitch = between_ends / steps;
        bands = {box.low.y + (options.width - pitch) / 2, pitch, pitch, steps + 1};
        return {bands, waste_of(target, bands, options)};
    }
    std::vector<std::pair<double, double>> flush{{-std::numeric_limits<double>::infinity(), box.low.y},
                                                 {-std::numeric_limits<double>::infinity(), box.high.y}};
    const auto ring = [&](const Polygon& polygon) {
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            const Point edge = polygon[i] - polygon[j];
            if (std::abs(edge.y) < 0.02 * std::abs(edge.x) && std::abs(edge.x) > s)
                flush.emplace_back(-std::abs(edge.x), (polygon[i].y + polygon[j].y) / 2);
        }
    };
    for (const Region& region : target) {
        ring(region.outer);
        for (const Polygon& hole : region.holes) ring(hole);
    }
    std::ranges::sort(flush);
    Layout best{{}, std::numeric_limits<double>::infinity()};
    std::vector<double> tried;
    for (std::size_t i = 0; i < flush.size() && tried.size() < most_phases; ++i) {
        const double phase = flush[i].second - box.low.y;
        const double low = box.low.y + phase - s * std::ceil(phase / s - line_slack);
        if (std::ranges::any_of(tried, [&](double other) { return std::abs(other - low) < line_slack * s; }))
            continue;
        tried.push_back(low);
        const Bands bands{low, s, s,
                          std::max(1, static_cast<int>(std::ceil((box.high.y - low) / s - line_slack)))};
        if (const double waste = waste_of(target, bands, options); waste < best.waste - 1e-9)
            best = {bands, waste};
    }
    return best;
}

struct Piece {
    int row;
    double from, to, y;
    double lean_from, lean_to;  ///< of the edges at its ends, 0: none to turn at
};

/// The middle of what a band holds of an area, mean over the line.
double middle_of(const Regions& target, const Interval& line, double low, double high) {
    double sum = 0;
    constexpr double places[] = {0.25, 0.5, 0.75};
    for (double share : places) {
        const double x = line.from + share * (line.to - line.from);
        std::vector<double> heights;
        const auto ring = [&](const Polygon& polygon) {
            for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
                const Point a = polygon[j], b = polygon[i];
                if ((a.x > x) == (b.x > x)) continue;
                heights.push_back(std::clamp(a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y), low, high));
            }
        };
        for (const Region& region : target) {
            ring(region.outer);
            for (const Polygon& hole : region.holes) ring(hole);
        }
        std::ranges::sort(heights);
        double held = 0, moment = 0;
        for (std::size_t i = 0; i + 1 < heights.size(); i += 2) {
            held += heights[i + 1] - heights[i];
            moment += (heights[i + 1] - heights[i]) * (heights[i + 1] + heights[i]) / 2;
        }
        sum += held > 0 ? moment / held : (low + high) / 2;
    }
    return sum / std::size(places);
}

/// The bands of whole bars, centred on the rows.
Bands bars_of(const Bands& bands, double width) {
    const double height = width * (1 - bar_slack);
    return {bands.low + (bands.height - height) / 2, bands.pitch, height, bands.count};
}

/// A line's points: at a slanted end the bar turns flush with the edge.
Polyline points_of(const Piece& piece, double width) {
    Polyline points;
    const auto step = [&](double side, double lean) {
        return turn_step * width / std::hypot(1, lean) * Point{side, -side * lean};
    };
    const Point from{piece.from, piece.y}, to{piece.to, piece.y};
    if (piece.lean_from != 0) points.push_back(from + step(-1, piece.lean_from));
    points.push_back(from);
    points.push_back(to);
    if (piece.lean_to != 0) points.push_back(to + step(1, piece.lean_to));
    return points;
}

}  // namespace

Regions turned(Regions regions, double angle) {
    const Affine map{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
    for (Region& region : regions) {
        for (Point& p : region.outer) p = apply(map, p);
        for (Polygon& hole : region.holes)
            for (Point& p : hole) p = apply(map, p);
    }
    return regions;
}

double waste_of(const Segment& segment, const Options& options) {
    return layout_of(turned(segment.target, -segment.direction), options).waste;
}

std::vector<Line> lines_of(const Segment& segment, const Regions& region, const Options& options) {
    const double w = options.width;
    const Regions target = turned(segment.target, -segment.direction);
    const Regions within = turned(region, -segment.direction);
    const Bands bands = layout_of(target, options).bands;
    const double h = bands.height;
    const auto portions = portions_of(target, bands);
    const auto walls = portions_of(within, bars_of(bands, w));
    std::vector<std::vector<Knot>> profiles, rooms;
    for (const auto& of_band : portions) profiles.push_back(profile_of(of_band));
    for (const auto& of_bar : walls) rooms.push_back(profile_of(of_bar));

    const double budget = bare_budget * area(target);
    std::vector<Piece> pieces;
    const auto turn = [&](int k, double x) {
        return turn_at_end(portions[k], x, bands.low + k * bands.pitch + h / 2, h, options);
    };
    std::vector<Ends> ends;
    for (int i = 0; i < absolute_shares; ++i) ends.push_back({end_shares[i], false});
    for (double share : end_shares) ends.push_back({share, true});
    for (const Ends& end : ends) {
        const double share = end.share;
        pieces.clear();
        double bare = 0;
        for (int k = 0; k < bands.count; ++k) {
            if (profiles[k].empty()) continue;
            bare += integral(profiles[k], profiles[k].front().x, profiles[k].back().x);
            const std::vector<Interval> half_way = wanted(profiles[k], h, {end_shares[0], end.of_highest});
            for (const Interval& line : wanted(profiles[k], h, end)) {
                Piece piece{k, line.from, line.to, bands.low + k * bands.pitch + h / 2, 0, 0};
                // Steep ends leave next to nothing half way: what may be left is for the others.
                for (const Interval& half : half_way) {
                    if (half.from >= line.from && half.from < line.from + steep_slant * h / 2 &&
                        std::abs(turn(k, half.from)) < steep_slant)
                        piece.from = half.from;
                    if (half.to <= line.to && half.to > line.to - steep_slant * h / 2 &&
                        std::abs(turn(k, half.to)) < steep_slant)
                        piece.to = half.to;
                }
                bare -= integral(profiles[k], piece.from, piece.to);
                piece.lean_from = turn(k, piece.from);
                piece.lean_to = turn(k, piece.to);
                for (double x : {piece.from, piece.to}) {
                    const bool kept = x == line.from || x == line.to;
                    bare -= turned_area(turn(k, x), kept ? share : end_shares[0], h);
                }
                pieces.push_back(piece);
            }
        }
        if (bare <= budget) break;
    }

    const Affine back{std::cos(segment.direction),
                      std::sin(segment.direction),
                      -std::sin(segment.direction),
                      std::cos(segment.direction),
                      0,
                      0};
    std::vector<Line> lines;
    const auto place = [&](const Piece& piece, const std::vector<Knot>& room) {
        for (const Interval& free : above(room, w * (1 - 2 * bar_slack))) {
            Piece kept = piece;
            if (free.from > kept.from) kept.from = free.from, kept.lean_from = 0;
            if (free.to < kept.to) kept.to = free.to, kept.lean_to = 0;
            if (kept.to - kept.from < shortest_line * w) continue;
            Line line{points_of(kept, w),
                      apply(back, {kept.from, kept.y}),
                      apply(back, {kept.to, kept.y}),
                      kept.row,
                      kept.from,
                      kept.to};
            for (Point& p : line.points) p = apply(back, p);
            lines.push_back(std::move(line));
        }
    };
    for (Piece& piece : pieces) {
        if (!options.border || highest(profiles[piece.row], {piece.from, piece.to}) > full_share * h) {
            place(piece, rooms[piece.row]);
            continue;
        }
        // The row is nowhere full: what is over goes to both neighbours alike.
        const double low = bands.low + piece.row * bands.pitch;
        piece.y = middle_of(target, {piece.from, piece.to}, low, low + h);
        const Bands bar = bars_of({piece.y - h / 2, h, h, 1}, w);
        place(piece, profile_of(portions_of(within, bar)[0]));
    }
    return lines;
}

}  // namespace strandline::fill
