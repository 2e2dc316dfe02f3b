#include "result/tracking/reference.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::tracking {

std::size_t Reference::before(double t) const {
    while (latest_ > 0 && samples_[latest_].t > t) --latest_;
    while (latest_ + 1 < samples_.size() && samples_[latest_ + 1].t <= t) ++latest_;
    return latest_;
}

Target Reference::at(double t) const {
    const std::size_t i = before(t);
    const Sample& a = samples_[i];
    if (i + 1 == samples_.size()) return {a.pose, 0, 0, i};
    const Sample& b = samples_[i + 1];
    const double u = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
    // Speed, or the rate of a turn on the spot, is linear in time between samples: so much of the way is
    // done.
    const bool turns = a.motion == Motion::pivot;
    const double v0 = turns ? std::abs(a.turn_rate) : a.speed, v1 = turns ? std::abs(b.turn_rate) : b.speed;
    const double done = v0 + v1 > 0 ? (v0 + (v1 - v0) * u / 2) * u * 2 / (v0 + v1) : u;
    const double chord = distance(a.pose.at, b.pose.at);
    const double turn = wrap_angle(b.pose.heading - a.pose.heading);
    Target target{{a.pose.at, a.pose.heading + turn * done}, 0, 0, i};
    if (turns) {
        target.turn_rate = std::copysign(v0 + (v1 - v0) * u, turn);
    } else if (chord > 0) {
        const RobotPath piece{{0, a.pose, a.curvature},
                              {chord, {b.pose.at, a.pose.heading + turn}, b.curvature}};
        target.pose = state_at(piece, chord * done).pose;
        target.speed = v0 + (v1 - v0) * u;
        target.turn_rate = target.speed * (a.curvature + (b.curvature - a.curvature) * done);
    }
    return target;
}

}  // namespace strandline::tracking
