#include "path/order/raked.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace strandline::order {
namespace {

/// Metres.
constexpr double cell = 0.05;

/// Neighbouring numbers become far ones (splitmix64: Steele, Lea, Flood, Fast splittable pseudorandom number
/// generators, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

}  // namespace

Raked::Raked(const Job& job, const Robot& robot, const Avoid& avoid) : robot_(robot) {
    if (!avoid.on) return;
    Box box;
    for (const Group& group : job.groups)
        for (const Stroke& stroke : group.work.strokes)
            for (const Node& node : stroke.nodes) box = including(box, node.at);
    if (box.empty()) return;
    raster_ = raster_over(grown(box, robot.rake_width()), cell);
    lines_.assign(raster_.size(), 0);
    areas_.assign(raster_.size(), 0);
}

void Raked::draw(const Leg& leg, const Stroke& stroke, std::uint64_t what) {
    if (areas_.empty()) return;
    Element& element = elements_[stroke.element];
    element.share += mixed(what);
    state_ += mixed(what);
    const double half = groove_width(robot_, stroke.pins) / 2 / raster_.cell;
    Layer& layer = stroke.fill ? areas_ : lines_;
    const Robot along = steered(stroke, robot_);
    for (std::size_t i = 1; i < leg.path.size(); ++i) {
        const Point a = raster_.in_cells(rake_at(along, leg.path[i - 1].pose)),
                    b = raster_.in_cells(rake_at(along, leg.path[i].pose));
        const double length = distance(a, b);
        if (length <= 0) continue;
        for_runs_in(raster_, Swath{a, 1 / length * (b - a), length, half, half}, [&](const Run& run) {
            for (int column = run.first; column < run.end; ++column) {
                const std::size_t index = raster_.index(column, run.row);
                if (std::exchange(layer[index], stroke.element + 1) != stroke.element + 1)
                    element.cells.push_back(index);
            }
        });
    }
}

void Raked::finish(int element) {
    const auto found = elements_.find(element);
    if (found == elements_.end()) return;
    state_ -= found->second.share;
    for (const std::size_t index : found->second.cells)
        for (Layer* layer : {&lines_, &areas_})
            if ((*layer)[index] == element + 1) (*layer)[index] = 0;
    elements_.erase(found);
}

bool Raked::is_on(const Layer& layer, Point at) const {
    const Point place = raster_.in_cells(at);
    const long column = std::lround(place.x), row = std::lround(place.y);
    if (column < 0 || column >= raster_.columns || row < 0 || row >= raster_.rows) return false;
    return layer[raster_.index(static_cast<int>(column), static_cast<int>(row))] != 0;
}

Rolled Raked::rolled(const Curve& curve) const {
    Rolled found;
    if (elements_.empty()) return found;
    const std::vector<CurvePoint> points = sampled(curve, raster_.cell);
    bool on_line = true;  // beside its own end it is not over it
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Pose& pose = points[i].pose;
        const Point ahead = unit(pose.heading), left = left_normal(ahead);
        const bool rolls = std::ranges::any_of(robot_.wheels, [&](const Wheel& wheel) {
            return is_on(areas_, pose.at + wheel.at.x * ahead + wheel.at.y * left);
        });
        const bool was_on_line = std::exchange(on_line, is_on(lines_, pose.at));
        const bool crosses = on_line && !was_on_line;
        if (rolls) found.metres += points[i].s - points[i - 1].s;
        if (crosses) ++found.crossings;
        if ((rolls || crosses) && !found.first) found.first = pose.at;
    }
    return found;
}

}  // namespace strandline::order
