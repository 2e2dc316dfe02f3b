#pragma once
// Private to the room: chance, what the robot is told of its place, and what it makes of it.
#include <cstdint>
#include <deque>

#include "result/tracking/tracking.hpp"

namespace strandline::tracking {

/// splitmix64 (Steele, Lea and Flood, OOPSLA 2014) and normal numbers by Box and Muller (1958).
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    double normal();

  private:
    double uniform();
    std::uint64_t state_;
};

/// An error that drifts: an Ornstein-Uhlenbeck process in its exact discrete form, of standard deviation
/// `size`.
class Drift {
  public:
    Drift(double size, double time, double tick, Chance& chance);
    double next(Chance& chance);

  private:
    double keep_, kick_, value_;
};

/// Forward by one interval of constant speed and turn rate: an arc, exactly.
Pose moved(Pose pose, double speed, double turn_rate, double time);

/// Dead reckoning corrected by late fixes: the estimate lives at the time of the fixes and is carried to now
/// by what the wheels reported since. A fixed-gain observer.
class Estimate {
  public:
    Estimate(Pose start, double trust, std::size_t late) : known_(start), trust_(trust), late_(late) {}
    /// The wheels over the last tick.
    void roll(double speed, double turn_rate, double tick) { wheels_.push_back({speed, turn_rate, tick}); }
    /// A fix of the place `late` ticks ago.
    void fix(Pose measured);
    Pose now() const;

  private:
    struct Roll {
        double speed, turn_rate, time;
    };
    Pose known_;
    double trust_;
    std::size_t late_;
    std::deque<Roll> wheels_;  ///< since known_
};

}  // namespace strandline::tracking
