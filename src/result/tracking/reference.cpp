#include "result/tracking/reference.hpp"

#include "machine/pins/pins.hpp"

namespace strandline::tracking {

std::size_t Reference::before(double t) const {
    while (latest_ > 0 && samples_[latest_].t > t) --latest_;
    while (latest_ + 1 < samples_.size() && samples_[latest_ + 1].t <= t) ++latest_;
    return latest_;
}

Target Reference::at(double t) const {
    const std::size_t i = before(t);
    if (i + 1 == samples_.size()) return {samples_[i].pose, 0, 0, i};
    const Sample sample = pins::between(robot_, samples_[i], samples_[i + 1], t);
    const bool stands = sample.motion != Motion::pivot && samples_[i].pose.at == samples_[i + 1].pose.at;
    return {sample.pose, stands ? 0 : sample.speed, stands ? 0 : sample.turn_rate, i};
}

}  // namespace strandline::tracking
