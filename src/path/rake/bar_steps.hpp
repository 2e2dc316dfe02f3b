#pragma once
// Private to the room: a drive as steps of its bar, which need not stand square to its way.
#include "path/rake/masker.hpp"

namespace strandline::rake {

/// The bar from one pose to the next. Places and lengths in cells.
struct BarStep {
    double arc = 0;  ///< driven so far
    Point at, left;  ///< the bar's middle, and which way its left end is
    Point at_end, left_end;
};
std::vector<BarStep> bar_steps(const Driven& go, const Raster& raster);

Middle middle_of(const BarStep& step);

/// As for PinStep; steps are not put together.
template <class What>
std::size_t for_first_stretch(const std::vector<BarStep>& steps, const std::vector<unsigned>& masks,
                              std::size_t k, std::size_t, What what) {
    what(steps[k], masks[k]);
    return k + 1;
}
template <class What>
void for_stretches(const std::vector<BarStep>& steps, const std::vector<unsigned>& masks, std::size_t from,
                   std::size_t end, What what) {
    for (; from < end; ++from) what(steps[from], masks[from]);
}

template <class What>
void for_samples_in(const BarStep& step, double left, double thin, int count, What what) {
    const Point way = step.at_end - step.at, swing = step.left_end - step.left;
    const double rows = std::max(1.0, std::ceil(length(way) + left * length(swing) / 2));
    for (double row = 0.5; row < rows; ++row) {
        const double t = row / rows;
        const Point middle = step.at + t * way, side = normalized(step.left + t * swing);
        for (int i = 0; i < count; ++i) {
            const double offset = left - (i + 0.5) * thin;
            const double across =
                std::abs(cross(side, way + offset * swing));  // of its way: square to the bar
            what(i, middle + offset * side, across / rows * thin);
        }
    }
}

/// Bars in cells.
template <class What>
void for_runs_in(const Raster& raster, const BarStep& step, const std::vector<Bar>& bars, What what) {
    const auto quad = [&](double left, double right) {
        for_runs_in(raster,
                    Quad{step.at + left * step.left, step.at - right * step.left,
                         step.at_end - right * step.left_end, step.at_end + left * step.left_end},
                    [&](const Run& run) { what(run, step.arc, 0.0); });
    };
    const double swing = length(step.left_end - step.left), way = distance(step.at, step.at_end);
    for (const Bar& bar : bars) {
        // A bar that turns about a place within itself sweeps two triangles: cut, its parts are quads.
        const double cut =
            swing > 0 && way < swing * std::max(bar.left, bar.right)
                ? std::clamp(dot(step.at - step.at_end, step.left_end - step.left) / (swing * swing),
                             -bar.right, bar.left)
                : -bar.right;
        quad(bar.left, -cut);
        if (cut > -bar.right) quad(cut, bar.right);
    }
}

}  // namespace strandline::rake
