#pragma once
// Private to the room: strokes cut into short steps for which the state of the pins is decided.
#include "math/raster/raster.hpp"
#include "path/rake/track.hpp"

namespace strandline::rake {

/// A short straight piece of a stroke, or the turn at one of its corners with a little before and after, so
/// that a change of pins never falls on the corner itself. Places and lengths in cells.
struct PinStep {
    double from = 0, to = 0;  ///< metres along the rake path
    double arc = 0;           ///< cells driven so far, rake-up ways too
    Point at;                 ///< where it begins; a corner: the corner
    Point ahead;              ///< a corner: after it
    double length = 0;        ///< a corner: on either side of it
    Point before;             ///< a corner: ahead before it
    bool corner = false;
    bool follows = false;  ///< goes on straight from the step before it, on the same chord
};

/// Steps of one chord with one mask go as one: calls what(their stretch, mask) with those from `k` on, before
/// `end`, and gives the number of the step after them.
template <class What>
std::size_t for_first_stretch(const std::vector<PinStep>& steps, const std::vector<unsigned>& masks,
                              std::size_t k, std::size_t end, What what) {
    PinStep stretch = steps[k];
    const unsigned mask = masks[k];
    for (++k; k < end && masks[k] == mask && steps[k].follows && !stretch.corner; ++k) {
        stretch.length += steps[k].length;
        stretch.to = steps[k].to;
    }
    what(stretch, mask);
    return k;
}
template <class What>
void for_stretches(const std::vector<PinStep>& steps, const std::vector<unsigned>& masks, std::size_t from,
                   std::size_t end, What what) {
    while (from < end) from = for_first_stretch(steps, masks, from, end, what);
}

/// The steps of each stroke, at most `longest` cells long.
std::vector<std::vector<PinStep>> pin_steps(const std::vector<Track>& tracks,
                                            const std::vector<Polyline>& ways, const Raster& raster,
                                            double longest);

/// Calls what(run, arc at its first cell, arc from cell to cell) with the cells that the bars pass over in a
/// step. Bars in cells.
template <class What>
void for_runs_in(const Raster& raster, const PinStep& step, const std::vector<Bar>& bars, What what) {
    const auto straight = [&](Point from, Point ahead, double arc, const Bar& bar) {
        for_runs_in(raster, Swath{from, ahead, step.length, bar.left, bar.right}, [&](const Run& run) {
            const Point first{static_cast<double>(run.first), static_cast<double>(run.row)};
            what(run, arc + dot(first - from, ahead), ahead.x);
        });
    };
    for (const Bar& bar : bars) {
        if (step.corner) {
            straight(step.at - step.length * step.before, step.before, step.arc, bar);
            const Wedge wedge = wedge_of(step.at, step.before, step.ahead, bar.left, bar.right);
            if (wedge.outer > wedge.inner)
                for_runs_in(raster, wedge, [&](const Run& run) { what(run, step.arc + step.length, 0.0); });
        }
        straight(step.at, step.ahead, step.arc + (step.corner ? step.length : 0), bar);
    }
}

inline Middle middle_of(const PinStep& step) {
    return {step.at + step.length / 2 * step.ahead, left_normal(step.ahead)};
}

/// Calls what(number across from the left, place, area) with `count` points across, `thin` cells apart, that
/// tile what the bar passes over, which reaches `left` cells to its left.
template <class What>
void for_samples_in(const PinStep& step, double left, double thin, int count, What what) {
    const auto across = [&](Point middle, Point ahead) {
        const Point aside = thin * left_normal(ahead);
        Point p = middle + (left / thin - 0.5) * aside;
        for (int i = 0; i < count; ++i, p = p - aside) what(i, p, step.length * thin);
    };
    if (!step.corner) {
        across(step.at + step.length / 2 * step.ahead, step.ahead);
        return;
    }
    across(step.at - step.length / 2 * step.before, step.before);
    across(step.at + step.length / 2 * step.ahead, step.ahead);
    const double turn = std::atan2(cross(step.before, step.ahead), dot(step.before, step.ahead));
    const double rays = std::max(1.0, std::ceil(std::abs(turn) * left));
    for (double ray = 0.5; ray < rays; ++ray) {
        const double angle = turn * ray / rays;
        const Point side = std::cos(angle) * left_normal(step.before) - std::sin(angle) * step.before;
        for (int i = 0; i < count; ++i) {
            const double offset = left - (i + 0.5) * thin;  // to the left
            if (offset * turn < 0)                          // a left turn sweeps the right
                what(i, step.at + offset * side, std::abs(offset) * std::abs(turn) / rays * thin);
        }
    }
}

}  // namespace strandline::rake
