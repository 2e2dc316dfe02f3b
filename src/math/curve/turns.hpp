#pragma once
// Private to this room: continuous-curvature turns with radius 1 (all lengths here are in radii, sharpness is
// sigma R^2).
//
// The spiral is the clothoid through the origin with heading 0 and curvature 0 there; at curvature k it has
// heading k^2 / (2 sigma) and lies at spiral(k). A turn goes from a given curvature up (or down) to a peak,
// stays there if the peak is the limit 1, and goes down (or up) to curvature 0, always at full sharpness: so
// its angle says everything. Left and right turns are one family: `natural` is the angle of going straight to
// curvature 0, more is a left, less a right turn.
#include <vector>

#include "math/curve/curve.hpp"

namespace strandline::turns {

/// The spiral of one sharpness.
struct Spiral {
    explicit Spiral(double sharpness);
    double sharpness;
    Point full;           ///< at curvature 1
    double full_heading;  ///< there
    Point full_back;      ///< unit vector of -full_heading

    Point at(double curvature) const;
    double heading(double curvature) const { return curvature * curvature / (2 * sharpness); }
    /// From curvature `begin` up to 1, from the origin with heading 0.
    Pose rise(double begin) const;

  private:
    std::size_t terms_ = 0;
};

/// Turns from curvature `begin` to 0, from the origin with heading 0.
class Turn {
  public:
    Turn(const Spiral& spiral, double begin);
    double natural;

    struct End {
        Point at;
        double length;
    };
    /// Where the turn by `angle` ends (its heading is the angle). About 40 ns.
    End end(double angle) const;
    void append(std::vector<Clothoid>& pieces, double angle) const;

  private:
    struct Shape {
        double side, peak, stay;
    };
    Shape shape(double angle) const;

    const Spiral* spiral_;
    double begin_, begin_heading_, full_angle_;
    Point begin_at_, back_, enter_;  ///< unit vectors of -begin_heading_ and of the heading at curvature 1
};

/// b turned by the angle whose unit vector is a.
constexpr Point rotated(Point a, Point b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

}  // namespace strandline::turns
