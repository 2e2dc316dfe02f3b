#pragma once
// Private to the room: the plan as a moving target.
#include <cstddef>
#include <vector>

#include "machine/follow/follow.hpp"

namespace strandline::tracking {

/// Where the plan is at one of its instants.
struct Target {
    Pose pose;
    double speed = 0, turn_rate = 0;
    std::size_t sample = 0;  ///< the one before
};
/// Asked for times that mostly grow: amortised O(1).
class Reference {
  public:
    Reference(const Robot& robot, const std::vector<Sample>& samples) : robot_(robot), samples_(samples) {}
    double end() const { return samples_.back().t; }
    Target at(double t) const;
    unsigned mask_at(double t) const { return samples_[before(t)].mask; }

  private:
    std::size_t before(double t) const;
    const Robot& robot_;
    const std::vector<Sample>& samples_;
    mutable std::size_t latest_ = 0;
};

}  // namespace strandline::tracking
