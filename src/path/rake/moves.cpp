// Strokes, ways and masks -> the moves of a drive.
#include <algorithm>
#include <cmath>

#include "path/rake/track.hpp"

namespace strandline::rake {

Track track_of(const std::vector<Curve>& curves, double tolerance) {
    constexpr double same_place = 1e-9;
    Track track;
    double before = 0;
    for (const Curve& curve : curves) {
        // A chord of length c leaves an arc of curvature k by k c^2 / 8; a straight curve needs its ends
        // only.
        const double bend = max_curvature(curve);
        const double whole = length(curve);
        const double step = bend > 0 ? std::min(whole, std::sqrt(8 * tolerance / bend)) : whole;
        for (const CurvePoint& p : sampled(curve, std::max(step, same_place)))
            if (track.line.empty() || distance(track.line.back(), p.pose.at) > same_place) {
                track.line.push_back(p.pose.at);
                track.arcs.push_back(before + p.s);
            }
        before += whole;
    }
    return track;
}

Polyline part_of(const Track& track, double from, double to) {
    const auto at = [&](double s) {
        const auto next = std::ranges::lower_bound(track.arcs, s) - track.arcs.begin();
        if (next == 0) return track.line.front();
        if (next == std::ssize(track.arcs)) return track.line.back();
        const auto i = static_cast<std::size_t>(next);
        return between(track.line[i - 1], track.line[i],
                       (s - track.arcs[i - 1]) / (track.arcs[i] - track.arcs[i - 1]));
    };
    Polyline part{at(from)};
    for (auto i = static_cast<std::size_t>(std::ranges::upper_bound(track.arcs, from) - track.arcs.begin());
         i < track.arcs.size() && track.arcs[i] < to; ++i)
        part.push_back(track.line[i]);
    part.push_back(at(to));
    return without_duplicates(part);
}

std::vector<Bar> bars_of(unsigned mask, int pins, double width) {
    std::vector<Bar> bars;
    const double pin = width / pins;
    const auto down = [&](int i) { return i < pins && (mask >> (pins - 1 - i) & 1U) != 0; };
    for (int i = 0; i < pins; ++i) {
        if (!down(i)) continue;
        int end = i;
        while (down(end)) ++end;
        bars.push_back({width / 2 - i * pin, end * pin - width / 2});
        i = end;
    }
    return bars;
}

bool turns(Point before, Point after) {
    constexpr double straight = 1e-3;  // radians
    return std::abs(cross(before, after)) > straight || dot(before, after) < 0;
}

Wedge wedge_of(Point at, Point before, Point after, double left, double right) {
    return cross(before, after) > 0 ? Wedge{at, before, after, std::max(0.0, -left), right}
                                    : Wedge{at, before, after, std::max(0.0, -right), left};
}

std::vector<Move> moves_of(const std::vector<Stroke>& strokes, const std::vector<Polyline>& ways,
                           const std::vector<PinSpans>& masks, int pins, double tolerance) {
    std::vector<Move> moves;
    Polyline way;  // rake up, from the last place where a pin was down
    const auto lower = [&](Polyline line, unsigned mask) {
        if (!moves.empty()) {
            way.push_back(line.front());
            way = without_duplicates(way);
            if (way.size() >= 2 && length(way) > 0) moves.push_back({way, 0});
        }
        way = {line.back()};
        moves.push_back({std::move(line), mask});
    };
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const Track track = track_of(strokes[i].rake_path, tolerance);
        if (track.line.size() < 2) continue;
        if (i < ways.size()) way.insert(way.end(), ways[i].begin(), ways[i].end());
        if (i >= masks.size()) {
            lower(track.line, all_pins(pins));
            continue;
        }
        double so_far = 0;  // along the stroke
        const auto lift_to = [&](double s) {
            if (s <= so_far) return;
            const Polyline part = part_of(track, so_far, s);
            way.insert(way.end(), part.begin(), part.end());
        };
        for (const PinSpan& span : masks[i]) {
            if (span.mask == 0) continue;
            lift_to(span.from);
            Polyline part = part_of(track, span.from, span.to);
            if (part.size() >= 2) lower(std::move(part), span.mask);
            so_far = span.to;
        }
        lift_to(track.arcs.back());
    }
    return moves;
}

}  // namespace strandline::rake
