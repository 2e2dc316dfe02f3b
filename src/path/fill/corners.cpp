// Corners that are cut: on, up, and off again beside.
#include "path/fill/corners.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace strandline::fill {
namespace {

constexpr double squarest =
    0.11;  // |cos| of the turn: beyond, the round wedge of a turn on the spot wastes less
constexpr double shortest_edge = 0.6;  // of the width: what is left of an edge after a cut at both its ends
constexpr double shortest_masked = 0.25;  // the same where pins are lifted over raked sand
constexpr double shortest_looped = 0.05;  // the same of chords of curved edges beside a corner to loop at
constexpr double least_gap = 0.004;       // of width^2: what a turn on the spot may leave when there are pins
constexpr double least_looped_gap = 0.03;  // of width^2: what a loop must save
constexpr double longest_tip = 3;          // of the width: of tips that a loop goes round
constexpr double sharp_turn = 0.7;         // radians: flatter corners leave next to nothing
constexpr double pointed_share = 0.6;      // of the way from the wedge to the tip
constexpr double most_pointed = 0.25;      // of the width
constexpr double pointed_along = 0.15;     // of the width: where the way to the drawn-on corner begins
constexpr double longest_move = 0.99;      // of the width, from the end of one pass to the start of the next

/// Without the points that lie on straight edges: an edge is as long as it looks.
Polyline straightened(const Polyline& line) {
    constexpr double least_turn = 1e-3;
    Polyline kept{line.front()};
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Point in = line[i] - kept.back(), out = line[i + 1] - line[i];
        if (std::abs(cross(in, out)) > least_turn * length(in) * length(out) || dot(in, out) < 0)
            kept.push_back(line[i]);
    }
    kept.push_back(line.back());
    return kept;
}

bool cuts(bool border, const Options& options) {
    if (options.pivots) return true;
    return options.masked && (options.tips == Tips::all || (options.tips == Tips::border && border));
}

}  // namespace

std::optional<Corner> cut_corner(Point before, Point corner, Point after, bool border,
                                 const Options& options) {
    if (!cuts(border, options)) return std::nullopt;
    const double w = options.width;
    const Point in = normalized(corner - before), out = normalized(after - corner);
    const double cosine = dot(in, out), sine = std::abs(cross(in, out));
    const double edge = std::min(distance(before, corner), distance(corner, after)) / w;
    if (!options.masked) {
        if (edge < shortest_edge || std::abs(cosine) >= squarest) return std::nullopt;
        const double flush = w / 2 * (1 - std::abs(cosine)) / sine;
        return Corner{flush, flush};
    }
    // A turn by t sweeps a wedge of t/2 (w/2)^2 of the tip, which has tan(t/2) (w/2)^2.
    const double half = std::atan2(sine, cosine) / 2, tip = std::tan(half);
    if (edge < (options.pivots ? shortest_masked : shortest_looped) ||
        (tip - half) / 4 < (options.pivots ? least_gap : least_looped_gap))
        return std::nullopt;
    // The next pass starts where the first bar's inner end leaves it sand, and near enough to be no hop,
    // unless there is a loop anyway.
    const double ahead = sine == 0 ? 0 : (1 - std::abs(cosine)) / sine / 2;  // 0: right back
    const double onward =
        options.pivots
            ? ahead * cosine + std::sqrt(longest_move * longest_move - ahead * ahead * (1 - cosine * cosine))
            : longest_tip;
    return Corner{w * std::min(tip / 2, onward), w * ahead};
}

std::vector<Polyline> with_cut_corners(const Polyline& whole, bool closed, bool border,
                                       const Options& options) {
    if (whole.size() < 2) return {};
    if (!cuts(border, options)) return {whole};
    const Polyline line = straightened(whole);
    std::vector<Polyline> passes;
    const std::size_t n = line.size();
    std::optional<Corner> seam;
    if (closed && n > 3) seam = cut_corner(line[n - 2], line[0], line[1], border, options);
    // Between two corners that are cut; what is shorter than `ahead` the pass before rakes.
    const auto add = [&](std::size_t from, double ahead, std::size_t to, double onward) {
        Polyline pass(line.begin() + static_cast<std::ptrdiff_t>(from),
                      line.begin() + static_cast<std::ptrdiff_t>(to) + 1);
        const double whole_length = length(pass);
        if (ahead >= whole_length) return;
        if (ahead > 0) pass = slice(pass, ahead, whole_length);
        pass.back() = line[to] + onward * normalized(line[to] - line[to - 1]);
        passes.push_back(std::move(pass));
    };
    std::size_t from = 0;
    double ahead = seam ? seam->ahead : 0;
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const auto cut = cut_corner(line[i - 1], line[i], line[i + 1], border, options);
        if (!cut) continue;
        add(from, ahead, i, cut->onward);
        from = i;
        ahead = cut->ahead;
    }
    add(from, ahead, n - 1, seam ? seam->onward : 0);
    if (passes.empty()) return {whole};
    return passes;
}

Polygon with_pointed_corners(const Polygon& ring, const Options& options) {
    if (!options.pivots || options.masked) return ring;
    const double w = options.width;
    Polygon pointed;
    for (std::size_t n = ring.size(), i = 0; i < n; ++i) {
        const Point before = ring[(i + n - 1) % n], corner = ring[i], after = ring[(i + 1) % n];
        const Point in = normalized(corner - before), out = normalized(after - corner);
        const double turn = std::atan2(cross(in, out), dot(in, out));
        if (turn < sharp_turn || cut_corner(before, corner, after, false, options)) {
            pointed.push_back(corner);
            continue;
        }
        const double tip = (1 / std::cos(turn / 2) - 1) / 2;  // from the wedge to the tip, widths
        const double on = std::min(pointed_share * tip, most_pointed) * w;
        pointed.push_back(corner - std::min(pointed_along * w, distance(before, corner) / 3) * in);
        pointed.push_back(corner + on * normalized(in - out));
        pointed.push_back(corner + std::min(pointed_along * w, distance(corner, after) / 3) * out);
    }
    return pointed;
}

}  // namespace strandline::fill
