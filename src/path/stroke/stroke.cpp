#include "path/stroke/stroke.hpp"

#include <algorithm>

namespace strandline {
namespace {

// A cut nearer than this to a joint (metres) is at the joint: no slivers.
constexpr double at_joint = 1e-9;

/// The curves from arc length `from` to the end, then from the start to `from`. Where the cut falls inside a
/// curve, that curve's end and start become the path's: the seam moves.
std::vector<Curve> rotated(const std::vector<Curve>& curves, double from) {
    std::vector<Curve> tail, head;
    double s = 0;
    for (const Curve& curve : curves) {
        const double here = length(curve), cut = from - s;
        if (cut <= at_joint) {
            tail.push_back(curve);
        } else if (cut >= here - at_joint) {
            head.push_back(curve);
        } else {
            head.push_back(slice(curve, 0, cut));
            tail.push_back(slice(curve, cut, here));
        }
        s += here;
    }
    // where the old seam was smooth, nothing marks it: the curves on both sides are one
    if (!tail.empty() && !head.empty()) {
        constexpr double smooth = 1e-6;  // radians
        const Pose end = end_pose(tail.back());
        if (std::abs(wrap_angle(head.front().start.heading - end.heading)) < smooth) {
            tail.back() = joined(std::move(tail.back()), head.front());
            head.erase(head.begin());
        }
    }
    tail.insert(tail.end(), head.begin(), head.end());
    return tail;
}

}  // namespace

Robot steered(const Stroke& stroke, Robot robot) {
    if (robot.rake_offset > 0) robot.rake_side += middle_of(robot, pin_mask(robot, stroke.pins));
    return robot;
}

std::vector<Curve> rake_path_from(const Stroke& stroke, int node, bool reverse) {
    std::vector<Curve> path = stroke.rake_path;
    if (stroke.closed && node >= 0 && node < static_cast<int>(stroke.nodes.size())) {
        const double s = stroke.nodes[static_cast<std::size_t>(node)].s;
        if (s > at_joint && s < length(path) - at_joint) path = rotated(path, s);
    }
    if (reverse) {
        std::reverse(path.begin(), path.end());
        for (Curve& curve : path) curve = reversed(curve);
    }
    return path;
}

}  // namespace strandline
