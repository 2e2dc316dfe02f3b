// Exact paths cut in pieces: places, arc lengths along them, and the pieces between.
#include <algorithm>
#include <cmath>

#include "math/curve/segments.hpp"

namespace strandline {

namespace {

/// The t at which the segment has run `wanted` of its `whole` length: Newton, kept between bounds that
/// shrink, so that cusps do no harm.
double parameter_at(Point from, const Segment& segment, double wanted, double whole) {
    if (!(wanted > 0)) return 0;
    if (wanted >= whole) return 1;
    if (std::holds_alternative<LineSegment>(segment)) return wanted / whole;
    constexpr double close_enough = 1e-10;  // of the segment
    constexpr int most_steps = 60;
    double low = 0, high = 1, run_low = 0, t = wanted / whole;
    for (int step = 0; step < most_steps; ++step) {
        const double run = run_low + segments::length(from, segment, low, t), missing = wanted - run;
        if (std::abs(missing) <= close_enough * whole) break;
        const double speed = length(segments::jet(from, segment, t).velocity);
        if (missing > 0) {
            low = t;
            run_low = run;
        } else {
            high = t;
        }
        t += missing / speed;
        if (!(t > low && t < high)) t = (low + high) / 2;
    }
    return t;
}

/// Segment and t of a place.
struct Spot {
    std::size_t segment;
    double t;
};
Spot spot_of(const Path& path, double place) {
    const auto count = static_cast<double>(path.segments.size());
    const double clamped = std::clamp(place, 0.0, count);
    const double segment = std::min(std::floor(clamped), count - 1);
    return {static_cast<std::size_t>(segment), clamped - segment};
}

Point start_of(const Path& path, std::size_t segment) {
    return segment == 0 ? path.start : end_of(path.segments[segment - 1]);
}

}  // namespace

namespace segments {

Part part(Point from, const Segment& segment, double t0, double t1) {
    const Point start = point(from, segment, t0), to = point(from, segment, t1);
    if (t0 <= 0 && t1 >= 1) return {start, segment};
    if (const auto* cubic = std::get_if<CubicSegment>(&segment)) {
        // The handles of the part are a third of the derivatives at its ends, for its own share of t.
        const double third = (t1 - t0) / 3;
        return {start, CubicSegment{start + third * jet(from, *cubic, t0).velocity,
                                    to - third * jet(from, *cubic, t1).velocity, to}};
    }
    if (const auto* arc = std::get_if<ArcSegment>(&segment))
        return {start, ArcSegment{arc->center, arc->u, arc->v, arc->start + t0 * arc->sweep,
                                  (t1 - t0) * arc->sweep, to}};
    return {start, LineSegment{to}};
}

}  // namespace segments

Point point_at(const Path& path, double place) {
    if (path.segments.empty()) return path.start;
    const auto [segment, t] = spot_of(path, place);
    return segments::point(start_of(path, segment), path.segments[segment], t);
}

std::vector<double> places_at(const Path& path, const std::vector<double>& arc_lengths) {
    std::vector<double> places;
    places.reserve(arc_lengths.size());
    double run = 0;
    auto next = arc_lengths.begin();
    for (std::size_t i = 0; i < path.segments.size() && next != arc_lengths.end(); ++i) {
        const Point from = start_of(path, i);
        const double whole = segments::length(from, path.segments[i]);
        for (; next != arc_lengths.end() && *next < run + whole; ++next)
            places.push_back(static_cast<double>(i) +
                             parameter_at(from, path.segments[i], *next - run, whole));
        run += whole;
    }
    places.resize(arc_lengths.size(), static_cast<double>(path.segments.size()));
    return places;
}

std::vector<Path> split(const Path& path, const std::vector<double>& places) {
    std::vector<Path> pieces;
    pieces.reserve(places.size() + 1);
    Spot at{0, 0};
    const auto cut_to = [&](Spot end) {
        Path piece{pieces.empty() ? path.start : end_of(pieces.back()), {}, false};
        for (; at.segment <= end.segment && at.segment < path.segments.size(); ++at.segment, at.t = 0) {
            const double until = at.segment == end.segment ? end.t : 1;
            if (until > at.t)
                piece.segments.push_back(
                    segments::part(start_of(path, at.segment), path.segments[at.segment], at.t, until)
                        .segment);
            if (at.segment == end.segment) {
                at.t = std::max(at.t, until);
                break;
            }
        }
        pieces.push_back(std::move(piece));
    };
    for (const double place : places)
        if (!path.segments.empty()) cut_to(spot_of(path, place));
    if (path.segments.empty())
        pieces.assign(places.size() + 1, Path{path.start, {}, false});
    else
        cut_to({path.segments.size() - 1, 1});
    return pieces;
}

}  // namespace strandline
