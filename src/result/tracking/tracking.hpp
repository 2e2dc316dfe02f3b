#pragma once
// A drive as a robot really does it: a path-following controller at 25 Hz that is told where it is late and
// with noise, and that keeps the machine's limits (docs/tracking.md).
#include <cstdint>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/follow/follow.hpp"
#include "machine/robot/robot.hpp"

namespace strandline::tracking {

/// How the robot knows where it is. Standard deviations; all 0 with delay 0: it always knows.
struct Localisation {
    double noise = 0.01;          ///< m along x and along y, new with every fix
    double heading_noise = 0.01;  ///< rad, the same
    double wander = 0.01;         ///< m along x and along y: an error that drifts slowly
    double wander_time = 30;      ///< s until the drift has forgotten itself
    double slip = 0.01;   ///< share by which the wheels misjudge speed and turn rate, drifting as slowly
    double delay = 0.12;  ///< s from being somewhere to knowing it
};
struct Options {
    Localisation localisation;
    std::uint64_t seed = 1;
    double rate = 25;          ///< Hz of fixes and of commands
    double look_ahead = 0.35;  ///< m: the distance within which an error is steered out
    double trust = 0.05;       ///< share of a fix that goes into the estimate, the rest is odometry
    bool lead_pins = true;  ///< pins are told so much earlier as they take; false: when they should be there
};
/// One tick.
struct LogLine {
    double t = 0, planned_t = 0;  ///< s; the plan's own time that the robot has come to
    Pose real, believed, planned;
    double speed = 0, turn_rate = 0;
    Point rake;
    unsigned mask = 0;
    double off = 0;  ///< m from the rake to the planned rake path while drawing, else 0
};
struct Driven {
    std::vector<Sample> samples;  ///< what really happened: one a tick, and one where pins move
    std::vector<LogLine> log;
    /// Of the rake to its planned path, over the ticks at which it is down. Metres.
    double mean = 0, rms = 0, most = 0;
    double time = 0;    ///< s
    bool lost = false;  ///< it fell so far behind that it was stopped
};
/// Drives the samples of a plan. Deterministic for a seed. O(time x rate).
Driven driven(const Robot& robot, const std::vector<Sample>& plan, const Options& options,
              const Progress& progress = {});

}  // namespace strandline::tracking
