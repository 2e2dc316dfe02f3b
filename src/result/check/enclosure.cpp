#include "result/check/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace strandline::check {
namespace {

/// Metres: positions may be rounded to a micrometre, each.
constexpr double rounding = 4e-6;
/// Metres, radians: from where the drive begins and ends by the options.
constexpr double place_tolerance = 1e-3, heading_tolerance = 1e-3;

/// How deep the part of a segment that lies in a convex body is in it: at the middle of that part and its
/// ends.
double depth_of_segment(Point a, Point b, const Polygon& body) {
    double from = 0, to = 1;
    for (std::size_t i = 0; i < body.size() && from < to; ++i) {
        const Point inwards = left_normal(normalized(body[(i + 1) % body.size()] - body[i]));
        const double at_a = dot(inwards, a - body[i]), at_b = dot(inwards, b - body[i]);
        if (at_a < 0 && at_b < 0) return 0;
        if (at_a < 0) from = std::max(from, at_a / (at_a - at_b));
        if (at_b < 0) to = std::min(to, at_a / (at_a - at_b));
    }
    if (from >= to) return 0;
    double depth = 0;
    for (const double share : {from, (from + to) / 2, to})
        depth = std::max(depth, distance_to_outline(body, between(a, b, share)));
    return depth;
}

}  // namespace

Enclosure::Enclosure(const Plan& plan) : body_(footprint(plan.robot)) {
    const double reach = footprint_reach(plan.robot);
    const DriveArea area = drive_area_of(plan);
    border_ = area.border;
    const Box box = bounds(area.border);
    const bool is_box = strandline::area(area.border) > (1 - 1e-9) * box.width() * box.height();
    if (is_box) core_ = grown(box, -reach);
    for (const Region& region : area.keep_out) keep_outs_.push_back({grown(bounds(region), reach), region});
}

/// Of the body outside the area (`within`: it should be inside), or in it.
double Enclosure::depth(const Region& area, bool within, const Polygon& body) const {
    double depth = 0;
    const auto ring = [&](const Polygon& outline) {
        for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
            depth = std::max(depth, depth_of_segment(outline[j], outline[i], body));
    };
    ring(area.outer);
    for (const Polygon& hole : area.holes) ring(hole);
    for (const Point corner : body) {
        if (contains(area, corner) == within) continue;
        double off = distance_to_outline(area.outer, corner);
        for (const Polygon& hole : area.holes) off = std::min(off, distance_to_outline(hole, corner));
        depth = std::max(depth, off);
    }
    return depth;
}

std::optional<Enclosure::Trespass> Enclosure::trespass(Point at, double heading) const {
    const auto standing = [&] {
        const Point forward = unit(heading);
        Polygon body;
        for (const Point corner : body_)
            body.push_back(at + corner.x * forward + corner.y * left_normal(forward));
        return body;
    };
    if (!contains(core_, at))
        if (const double out = depth(border_, true, standing()); out > rounding)
            return Trespass{out,
                            fmt::format("the footprint is {:.3f} m outside the field, allowed 0 m", out)};
    for (const KeepOut& keep_out : keep_outs_) {
        if (!contains(keep_out.near, at)) continue;
        if (const double in = depth(keep_out.area, false, standing()); in > rounding)
            return Trespass{in,
                            fmt::format("the footprint reaches {:.3f} m into a keep-out, allowed 0 m", in)};
    }
    return std::nullopt;
}

void check_ends(const Plan& plan, Faults& faults) {
    if (plan.samples.empty()) return;
    const strandline::Options::Park& park = plan.options.park;
    const Pose parked{{park.x, park.y}, park.heading};
    const Sample &first = plan.samples.front(), &last = plan.samples.back();
    struct Off {
        double metres, angle;
        double excess() const {
            return metres > place_tolerance || angle > heading_tolerance ? std::max(metres, angle) : 0;
        }
    };
    const auto off = [](const Pose& is, const Pose& should) {
        return Off{distance(is.at, should.at), std::abs(wrap_angle(is.heading - should.heading))};
    };
    const auto fault = [&](const Off& by, const Sample& s, const char* what) {
        if (by.excess() <= 0) return;
        const std::string amount =
            by.metres > place_tolerance
                ? fmt::format("{:.3f} m off, allowed {:.3f} m", by.metres, place_tolerance)
                : fmt::format("{:.3f} radians off, allowed {:.3f}", by.angle, heading_tolerance);
        faults.add(by.excess(), {Law::ends, fmt::format("the drive {} ({})", what, amount), s.pose.at,
                                 static_cast<int>(&s - plan.samples.data()), s.stroke, -1});
    };
    if (park.parked) fault(off(first.pose, parked), first, "does not begin where the robot is parked");
    if (park.exit == "parked")
        fault(std::ranges::min(off(last.pose, parked), off(last.pose, Pose{parked.at, parked.heading + pi}),
                               {}, &Off::excess),
              last, "does not end where the robot was parked");
    if (park.exit == "pose")
        fault(off(last.pose, Pose{{park.exit_x, park.exit_y}, park.exit_heading}), last,
              "does not end at the exit");
    if (park.exit == "outside") {
        Box box;
        for (const Element& element : plan.drawing.elements) box = united(box, bounds(element));
        const Point p = last.pose.at;
        const double out = std::max({box.low.x - p.x, p.x - box.high.x, box.low.y - p.y, p.y - box.high.y});
        fault(Off{footprint_reach(plan.robot) - out, 0}, last, "does not end outside the drawing");
    }
}

}  // namespace strandline::check
