#pragma once
// Private to the room: where the robot may be, and where its drive begins and ends.
#include <optional>

#include "result/check/faults.hpp"

namespace strandline::check {

/// The field and the keep-outs, asked about one pose after the other.
class Enclosure {
  public:
    explicit Enclosure(const Plan& plan);
    struct Trespass {
        double metres;  ///< how far
        std::string what;
    };
    /// O(corners of the border and of the keep-outs near by).
    std::optional<Trespass> trespass(Point at, double heading) const;

  private:
    struct KeepOut {
        Box near;  ///< a turning point out of it is not concerned
        Region area;
    };
    double depth(const Region& area, bool within, const Polygon& body) const;
    Region border_;
    Box core_;  ///< a turning point in it is not concerned with the border; empty where that is not a box
    std::vector<KeepOut> keep_outs_;
    Polygon body_;
};

/// The drive begins where the robot is parked and ends at an exit, where the options say so.
void check_ends(const Plan& plan, Faults& faults);

}  // namespace strandline::check
