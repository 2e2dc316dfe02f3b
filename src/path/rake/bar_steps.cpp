#include "path/rake/bar_steps.hpp"

#include <cmath>

namespace strandline::rake {

std::vector<BarStep> bar_steps(const Driven& go, const Raster& raster) {
    std::vector<BarStep> steps;
    double arc = go.before / raster.cell;
    for (std::size_t i = 0; i + 1 < go.bar.size(); ++i) {
        const Pose &a = go.bar[i], &b = go.bar[i + 1];
        steps.push_back({arc, raster.in_cells(a.at), left_normal(unit(a.heading)), raster.in_cells(b.at),
                         left_normal(unit(b.heading))});
        arc += distance(a.at, b.at) / raster.cell;
    }
    return steps;
}

Middle middle_of(const BarStep& step) {
    return {between(step.at, step.at_end, 0.5), normalized(step.left + step.left_end)};
}

}  // namespace strandline::rake
