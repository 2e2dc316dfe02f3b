#pragma once
// Private to this room: curves whose curvature only rises and falls at full sharpness: from that of the start
// up to a first peak, down to a valley, up to a second peak, down to that of the end (or mirrored), staying
// where it reaches the limit. Peaks may have any sign: turns to the left, the right and the left again are
// such a curve, and so are two turns to the left with a dip between them.
//
// Notation: q is a peak's number. Within the limit it is the curvature itself; beyond it by d, the limit with
// a stay of length 2 d / sigma, so that length and heading are smooth in q: d length / dq = 2 / sigma always.
// p is q's curvature, H(p) = p^2 / (2 sigma) the heading of the spiral there, S(p) its point. g is the
// heading a ramp would have at curvature 0: S is turned by g where curvature rises, its mirror image where it
// falls.
#include <vector>

#include "math/curve/families.hpp"

namespace strandline::turns {

/// A peak's number and what follows from it alone.
struct Peak {
    double q, p, turn;    ///< turn = 2 H(p) + angle of the stay
    Point spiral, ahead;  ///< S(p), unit(H(p))
    bool stays;
};

/// One side's search: `side` says to which side the curvature first rises (seen so that it is left).
class ThreePeaks {
  public:
    /// `known`: the length that a curve must fall short of to be worth having.
    ThreePeaks(const Task& task, double side, double known);

    /// Newton on the three numbers from these (analytic Jacobian). Gives up when the first step leads nowhere
    /// near, or to no shorter curve; what arrives is added to `found` and becomes what is known.
    void newton(Peak first, Peak valley, Peak second, std::vector<Found>& found);
    Peak peak(double q) const;
    /// The peak (sign 1) or valley (sign -1) that turns by `turn` >= 0 between its two ramps' headings at
    /// curvature 0.
    Peak turning(double turn, double sign) const;
    double length_of(double q1, double q2, double q3) const {
        return (2 * (q1 - q2 + q3) - begin_ - end_) / sigma_;
    }

    double side() const { return side_; }
    double best() const { return best_; }
    double begin() const { return begin_; }
    double end() const { return end_; }
    double sharpness() const { return sigma_; }
    double limit() const { return left_.curvature; }
    /// Where the heading stands before the first ramp and after the last, at curvature 0.
    double g0() const { return g0_; }
    double g3() const { return g3_; }

  private:
    struct Miss {
        Point at;
        double turn;
        Point by1, by2, by3;  ///< derivatives of `at`
    };
    Miss miss(const Peak& first, const Peak& valley, const Peak& second, double g3) const;
    void offer(const Peak& first, const Peak& valley, const Peak& second, std::vector<Found>& found);

    const Spiral& spiral_;
    double side_, best_, sigma_, begin_, end_;
    const Spiral::Limit &left_, &right_;
    Point to_;
    double g0_, g3_;
    Point spiral_begin_, spiral_end_;
    double tolerance_;
};

/// A few seeds from circles as Dubins would take: some microseconds.
void add_three_peaks(const Task& task, std::vector<Found>& found);
/// Seeds all over what could be shorter than what was found: some hundred microseconds.
void add_all_three_peaks(const Task& task, std::vector<Found>& found);

}  // namespace strandline::turns
