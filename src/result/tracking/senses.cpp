#include "result/tracking/senses.hpp"

#include <cmath>

namespace strandline::tracking {

double Chance::uniform() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return (static_cast<double>((z ^ (z >> 31)) >> 11) + 0.5) * 0x1p-53;
}
double Chance::normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * pi * uniform());
}

Drift::Drift(double size, double time, double tick, Chance& chance)
    : keep_(std::exp(-tick / time)),
      kick_(size * std::sqrt(1 - keep_ * keep_)),
      value_(size * chance.normal()) {}
double Drift::next(Chance& chance) { return value_ = keep_ * value_ + kick_ * chance.normal(); }

Pose moved(Pose pose, double speed, double turn_rate, double time) {
    // The chord of an arc points along its middle heading and is shorter than it by sin(h)/h.
    const double half = turn_rate * time / 2;
    const double chord = speed * time * (std::abs(half) < 1e-6 ? 1 : std::sin(half) / half);
    return {pose.at + chord * unit(pose.heading + half), pose.heading + 2 * half};
}

void Estimate::fix(Pose measured) {
    for (; wheels_.size() > late_; wheels_.pop_front())
        known_ = moved(known_, wheels_.front().speed, wheels_.front().turn_rate, wheels_.front().time);
    known_.at = between(known_.at, measured.at, trust_);
    known_.heading += trust_ * wrap_angle(measured.heading - known_.heading);
}
Pose Estimate::now() const {
    Pose pose = known_;
    for (const Roll& roll : wheels_) pose = moved(pose, roll.speed, roll.turn_rate, roll.time);
    return pose;
}

}  // namespace strandline::tracking
