// The ground that the robot stands on.
#include <algorithm>
#include <cmath>

#include "machine/robot/robot.hpp"

namespace strandline {
namespace {

// Metres: an outline that comes less far into the footprint touches it.
constexpr double touching = 1e-6;

struct Body {
    const Robot& robot;
    Point at, forward;
    Point in_body(Point p) const {
        const Point off = p - at;
        return {dot(off, forward), dot(off, left_normal(forward))};
    }
    Point on_ground(Point p) const { return at + p.x * forward + p.y * left_normal(forward); }

    /// Whether the segment comes into the footprint (Liang and Barsky 1984, in the body frame).
    bool enters(Point a, Point b) const {
        const Point p = in_body(a), q = in_body(b), way = q - p;
        double from = 0, to = 1;
        const auto clip = [&](double start, double step, double low, double high) {
            if (step == 0) return start > low && start < high;
            const double t0 = (low - start) / step, t1 = (high - start) / step;
            from = std::max(from, std::min(t0, t1));
            to = std::min(to, std::max(t0, t1));
            return from < to;
        };
        return clip(p.x, way.x, -robot.back + touching, robot.front - touching) &&
               clip(p.y, way.y, -robot.half_width + touching, robot.half_width - touching);
    }
    bool entered_by(const Polygon& outline) const {
        for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
            if (enters(outline[j], outline[i])) return true;
        return false;
    }
    /// Where no outline comes into it, one point of the footprint speaks for all.
    bool cut_by(const Region& area) const {
        return entered_by(area.outer) ||
               std::ranges::any_of(area.holes, [&](const Polygon& hole) { return entered_by(hole); });
    }
    Point middle() const { return on_ground({(robot.front - robot.back) / 2, 0}); }
};

}  // namespace

Polygon footprint(const Robot& robot) {
    return {{-robot.back, -robot.half_width},
            {robot.front, -robot.half_width},
            {robot.front, robot.half_width},
            {-robot.back, robot.half_width}};
}

double footprint_reach(const Robot& robot) {
    return std::hypot(std::max(robot.front, robot.back), robot.half_width);
}

bool stays_within(const Robot& robot, Point at, double heading, const Region& area) {
    const Body body{robot, at, unit(heading)};
    return contains(area, body.middle()) && !body.cut_by(area);
}

bool keeps_off(const Robot& robot, Point at, double heading, const Region& area) {
    const Body body{robot, at, unit(heading)};
    return !contains(area, body.middle()) && !body.cut_by(area);
}

}  // namespace strandline
