#pragma once
// Private to this room: continuous-curvature turns (all lengths here are in radii, the smaller of the two
// where left and right differ; sharpness is sigma R^2).
//
// The spiral is the clothoid through the origin with heading 0 and curvature 0 there; at curvature k it has
// heading k^2 / (2 sigma) and lies at spiral(k). A turn goes from a given curvature up (or down) to a peak,
// stays there if the peak is that side's limit (1, or less on the side of the larger radius), and goes down
// (or up) to curvature 0, always at full sharpness: so its angle says everything. Left and right turns are
// one family: `natural` is the angle of going straight to curvature 0, more is a left, less a right turn.
#include <vector>

#include "math/curve/curve.hpp"

namespace strandline::turns {

/// The spiral of one sharpness, and where it reaches the limits of both sides.
struct Spiral {
    Spiral(double sharpness, double left, double right);
    double sharpness;

    /// The spiral at the largest curvature of a side.
    struct Limit {
        double curvature;
        Point at;
        double heading;
        Point back;  ///< unit vector of -heading
    };
    const Limit& limit(double side) const { return side > 0 ? left_ : right_; }

    Point at(double curvature) const;
    double heading(double curvature) const { return curvature * curvature / (2 * sharpness); }
    /// From curvature `begin` up to the limit of `side` (seen so that it is positive), from the origin with
    /// heading 0.
    Pose rise(double begin, double side) const;

  private:
    std::size_t terms_ = 0;
    Limit left_, right_;
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
    struct Side {
        const Spiral::Limit* limit;
        double full_angle;  ///< the turn that just reaches the limit
        Point enter;        ///< unit vector of the heading there
    };
    struct Shape {
        const Side& side;
        double sign, peak, stay;  ///< stay: angle turned at the limit
    };
    Shape shape(double angle) const;

    const Spiral* spiral_;
    double begin_, begin_heading_;
    Point begin_at_, back_;  ///< unit vector of -begin_heading_
    Side left_, right_;
};

/// b turned by the angle whose unit vector is a.
constexpr Point rotated(Point a, Point b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

}  // namespace strandline::turns
