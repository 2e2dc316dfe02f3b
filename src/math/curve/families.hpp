#pragma once
// Private to this room: the families of continuous-curvature curves from the origin with heading 0 to a pose,
// radius 1.
#include <utility>
#include <vector>

#include "math/curve/turns.hpp"

namespace strandline::turns {

/// Positions are met to this share of (1 + distance) when a root counts as found.
constexpr double root_accuracy = 1e-12;

/// What is asked for, in the start's frame and in radii.
struct Task {
    /// `left`, `right`: largest curvatures to either side, the larger of them 1.
    Task(Pose to_pose, double k0, double k1, double sharpness, double left, double right)
        : to(to_pose.at),
          heading(to_pose.heading),
          ahead(unit(to_pose.heading)),
          begin(k0),
          end(k1),
          spiral(sharpness, left, right),
          first(spiral, k0),
          back_spiral(sharpness, right, left),
          last(back_spiral, -k1) {}
    Task(const Task&) = delete;

    /// Where the last turn, by `angle`, begins; it is a first turn seen backwards.
    Turn::End entry(double angle) const {
        const Turn::End back = last.end(-angle);
        return {to - rotated(ahead, back.at), back.length};
    }
    double last_natural() const { return -last.natural; }

    Point to;
    double heading;
    Point ahead;
    double begin, end;
    Spiral spiral;
    Turn first;
    Spiral back_spiral;  ///< what is left forwards is right backwards
    Turn last;
};

/// One curve that was found. turn_straight_turn: angle, straight, angle. same_side: both turns to `side` up
/// to the limit, staying for `a` and `b`; between them the curvature dips to `dip`, straight for `middle`
/// when that is 0. three_peaks: the numbers of peak, valley, peak (three_peaks.hpp), seen so that `side` is
/// left.
struct Found {
    enum Family { turn_straight_turn, same_side, three_peaks } family;
    double length;
    double a, middle, b;
    double side = 1, dip = 0;
};

/// Never fails: both turns to that side, one at least and one more for each loop. `side` +1 left, -1 right.
Found same_side(const Task& task, double side);
/// The shortest with a straight (or none) between two turns that begin and end it.
void add_turn_straight_turn(const Task& task, std::vector<Found>& found);

/// Pieces in radii, neighbours of one slope joined.
std::vector<Clothoid> pieces(const Task& task, const Found& found);

/// Curvature and length of the stay of a peak's number.
std::pair<double, double> peak_and_stay(const Spiral& spiral, double side, double q);

/// The same angle in [low, low + 2 pi).
double lifted(double angle, double low);

}  // namespace strandline::turns
