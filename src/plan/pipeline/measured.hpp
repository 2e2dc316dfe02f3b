#pragma once
// What the pieces of a drive measure, kept as long as they are the same.
#include <map>
#include <memory>
#include <vector>

#include "path/trajectory/trajectory.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

class MeasuredPieces {
  public:
    /// Puts together what parts::measure() says of the whole drive. False: somewhere the footprint is where
    /// it must not be. O(pieces), and O(samples) of those that are new.
    bool measure(Figures& figures, const std::vector<trajectory::Placed>& pieces, const DriveArea& area,
                 const Robot& robot);

  private:
    struct One {
        std::shared_ptr<const trajectory::Piece> piece;
        Figures figures;
        bool within = true, used = false;
    };
    std::map<const trajectory::Piece*, One> kept_;
    DriveArea area_;
    Robot robot_;
};

}  // namespace strandline::pipeline
