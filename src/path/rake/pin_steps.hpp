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

}  // namespace strandline::rake
