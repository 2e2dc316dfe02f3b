#pragma once
// Legs -> one trajectory: evenly spaced samples, timed with the robot's speeds and accelerations, with pin
// masks.
#include <map>
#include <memory>
#include <vector>

#include "path/stroke/stroke.hpp"

namespace strandline::trajectory {

struct Options {
    double step = 0.02;  ///< metres of robot path between samples, at most
    double dwell = 0.1;  ///< s the robot stands where its curvature jumps (exact corners), to turn its wheels
};

/// Legs end to end, each starting where the one before ended. Equal steps within a leg, joints kept, divided
/// where the robot turns tightly; the robot stands at the start, the end, at turns on the spot and at jumps
/// of curvature. Speed is the largest that keeps speed, turn rate, acceleration and turn acceleration between
/// all samples: one forward and one backward pass over v^2 (after Bobrow, Dubowsky and Gibson, Int. J.
/// Robotics Research 1985, with the turn acceleration split conservatively: |k'| v^2 + |k| |a| <= limit).
/// O(samples). A drive that begins with a stroke first stands for the lift delay, until its pins are down.
std::vector<Sample> timed(const std::vector<Leg>& legs, const std::vector<Stroke>& strokes,
                          const Robot& robot, const Options& options = {});

/// A piece of such a drive as one of its own: from rest to rest, by the same rules. Where it stood or turned
/// on the spot it does so as long. Times begin at 0. O(samples).
std::vector<Sample> retimed(std::vector<Sample> samples, const Robot& robot);

// The same for a drive that was timed before and has changed a little: what is not touched stays as it is.

/// The samples of one stretch within a drive; times and strokes count from its own.
struct Piece {
    std::vector<Sample> samples;
    Sample end;  ///< where the next one begins; its t: how long this takes
};
struct Placed {
    std::shared_ptr<const Piece> piece;  ///< the same object as long as it is the same
    double t = 0;                        ///< s from the start of the drive
    int stroke = 0;
};
/// Those of the whole drive. O(samples).
std::vector<Sample> joined(const std::vector<Placed>& pieces);

/// Keeps what it timed for the next time, as long as robot and options stay.
class Pieces {
  public:
    /// What timed() gives, but for rounding. A stretch that is the same object is not looked at again unless
    /// it is begun or left at another speed; that reaches a metre or two beyond what changed. O(stretches),
    /// and O(samples) of those that changed.
    std::vector<Placed> timed(const std::vector<Stretch>& stretches, const std::vector<Stroke>& strokes,
                              const Robot& robot, const Options& options);

  private:
    class Timed;
    std::map<const std::vector<Leg>*, std::shared_ptr<Timed>> kept_;
    Robot robot_;
    Options options_;
};

}  // namespace strandline::trajectory
