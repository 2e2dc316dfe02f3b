#include "machine/pins/pins.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::pins {
namespace {

/// Seconds: instants nearer than this are one.
constexpr double same_instant = 1e-9;

std::vector<Sample> shifted(const Robot& robot, const std::vector<Sample>& samples, double by) {
    if (by == 0 || samples.size() < 2) return samples;
    struct Change {
        double t;
        unsigned mask;
    };
    std::vector<Change> changes;
    unsigned mask = 0;  // before the drive begins
    for (const Sample& sample : samples) {
        if (sample.mask != mask) changes.push_back({std::max(samples.front().t, sample.t + by), sample.mask});
        mask = sample.mask;
    }
    mask = 0;
    std::vector<Sample> list;
    list.reserve(samples.size() + changes.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        Sample sample = samples[i];
        for (; next < changes.size() && changes[next].t <= sample.t + same_instant; ++next)
            mask = changes[next].mask;
        sample.mask = mask;
        list.push_back(sample);
        if (i + 1 == samples.size()) break;
        for (; next < changes.size() && changes[next].t < samples[i + 1].t - same_instant; ++next) {
            Sample inserted = between(robot, samples[i], samples[i + 1], changes[next].t);
            inserted.mask = mask = changes[next].mask;
            list.push_back(inserted);
        }
    }
    return list;
}

}  // namespace

Sample between(const Robot& robot, const Sample& a, const Sample& b, double t) {
    const double u = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 0;
    const bool turns = a.motion == Motion::pivot;
    const double v0 = std::abs(turns ? a.turn_rate : a.speed), v1 = std::abs(turns ? b.turn_rate : b.speed);
    const double share = v0 + v1 > 0 ? (v0 + (v1 - v0) * u / 2) * u * 2 / (v0 + v1) : u;
    const double chord = distance(a.pose.at, b.pose.at);
    const double turn = wrap_angle(b.pose.heading - a.pose.heading);
    Sample sample = a;
    sample.t = t;
    sample.pose.heading = a.pose.heading + turn * share;
    if (turns) {
        sample.turn_rate = std::copysign(v0 + (v1 - v0) * u, turn);
    } else if (chord > 0) {
        const RobotPath piece{{0, a.pose, a.curvature},
                              {chord, {b.pose.at, a.pose.heading + turn}, b.curvature}};
        sample.pose = state_at(piece, chord * share).pose;
        sample.speed = a.speed + (b.speed - a.speed) * u;
        sample.curvature = a.curvature + (b.curvature - a.curvature) * share;
        sample.turn_rate = sample.speed * sample.curvature;
    }
    sample.pose.heading = wrap_angle(sample.pose.heading);
    sample.rake = rake_at(robot, sample.pose);
    return sample;
}

std::vector<Sample> told(const Robot& robot, const std::vector<Sample>& done) {
    return shifted(robot, done, -robot.lift_delay);
}
std::vector<Sample> done(const Robot& robot, const std::vector<Sample>& told) {
    return shifted(robot, told, robot.lift_delay);
}

}  // namespace strandline::pins
