// How far the robot drives over areas that are finished.
#include <algorithm>

#include "math/nearest/nearest.hpp"
#include "result/check/faults.hpp"

namespace strandline::check {
namespace {

struct Area {
    int element;
    Box box;
    BandedRegion region;
    std::size_t done;  ///< the sample at which the last of its strokes ends
};

}  // namespace

void measure_finished(const Plan& plan, Report& report) {
    const std::vector<Sample>& samples = plan.samples;
    std::vector<std::size_t> last_drawn(plan.drawing.elements.size(), samples.size());
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const int element = element_of(plan, samples[i]);
        if (samples[i].motion == Motion::draw && element >= 0 &&
            element < static_cast<int>(last_drawn.size()))
            last_drawn[static_cast<std::size_t>(element)] = i + 1;
    }
    std::vector<Area> areas;
    for (std::size_t e = 0; e < last_drawn.size(); ++e) {
        const auto* region = std::get_if<RegionElement>(&plan.drawing.elements[e].what);
        if (region == nullptr || region->region.outer.size() < 3 || last_drawn[e] >= samples.size()) continue;
        areas.push_back(
            {static_cast<int>(e), bounds(region->region), BandedRegion(region->region), last_drawn[e]});
    }
    if (areas.empty()) return;
    int leaving = -1;  // the area just finished, until P has left it
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const Sample &a = samples[i], &b = samples[i + 1];
        for (const Area& area : areas)
            if (area.done == i) leaving = area.element;
        if (a.motion != Motion::connect && a.motion != Motion::lead) continue;
        const Point middle = between(a.pose.at, b.pose.at, 0.5);
        const double step = distance(a.pose.at, b.pose.at);
        bool within = false, in_left = false;
        for (const Area& area : areas) {
            if (area.done > i || !contains(area.box, middle) || !area.region.contains(middle)) continue;
            if (area.element == leaving)
                in_left = true;
            else
                within = true;
        }
        if (!in_left && step > 0) leaving = -1;
        if (within) report.over_finished += step;
    }
}

}  // namespace strandline::check
