#pragma once
// The same for a drive that was timed before and has changed a little: what is not touched stays as it is.
#include <map>
#include <memory>
#include <vector>

#include "path/stroke/stretch.hpp"
#include "path/trajectory/trajectory.hpp"

namespace strandline::trajectory {

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
