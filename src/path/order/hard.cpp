#include "path/order/hard.hpp"

#include <algorithm>

namespace strandline::order {
namespace {

/// Metres between footprints that are looked at.
constexpr double footprint_step = 0.02;
/// Dubins' words stay within so many least radii of the segment between their ends.
constexpr double words_reach = 4;

}  // namespace

Hard::Hard(const Job& job, const Robot& robot, double clearance, double radius)
    : robot_(robot),
      field_(job.field),
      keep_out_(job.keep_out),
      clearance_(clearance),
      radius_(radius),
      surely_({.clearance = footprint_reach(robot), .radius = radius}),
      narrow_({.clearance = robot.half_width, .radius = radius}) {
    add(surely_, footprint_reach(robot));
    add(narrow_, robot.half_width);
    // of a field with corners inside its box nothing is known
    if (field_ && area({*field_}) > (1 - 1e-9) * bounds(*field_).width() * bounds(*field_).height())
        inner_ = grown(bounds(*field_), -words_reach * radius - footprint_reach(robot));
}

void Hard::add(route::Ground& ground, double reach) const {
    const double missing = std::max(0.0, reach - ground.clearance());
    if (field_)
        for (const Region& region : missing > 0 ? inset({*field_}, missing) : Regions{*field_})
            ground.add_field(region);
    if (!keep_out_.empty()) ground.add(missing > 0 ? inset(keep_out_, -missing) : keep_out_);
}

void Hard::add_to(route::Ground& ground) const { add(ground, footprint_reach(robot_)); }

bool Hard::near(Point a, Point b) const {
    if (!keep_out_.empty()) return true;
    return field_ && !(contains(inner_, a) && contains(inner_, b));
}

double Hard::metres(const Curve& curve) const {
    if (!any() || surely_.clear(curve)) return 0;
    double sum = 0;
    const std::vector<CurvePoint> points = sampled(curve, footprint_step);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Pose& pose = points[i].pose;
        const bool within = !field_ || stays_within(robot_, pose.at, pose.heading, *field_);
        if (!within || std::ranges::any_of(keep_out_, [&](const Region& area) {
                return !keeps_off(robot_, pose.at, pose.heading, area);
            }))
            sum += points[i].s - points[i - 1].s;
    }
    return sum;
}

}  // namespace strandline::order
