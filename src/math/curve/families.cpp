#include "math/curve/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace strandline::turns {
namespace {

/// A turn this close to a whole one is rounding of no turn at all (radians).
constexpr double full_turn_slack = 1e-12;

double mirrored(double side, double value) { return side * value; }

/// How far apart the centres of two full left turns lie when the curvature dips to `dip` between them.
double centre_distance(const Spiral& spiral, double dip) {
    const Pose up = spiral.rise(dip);
    return 2 * (up.at.x - std::sin(up.heading));
}

/// A dip for every distance below that of the dip to 0: the distance is continuous in the dip, 0 at 1.
double dip_for(const Spiral& spiral, double distance, double distance_at_zero) {
    double low = 0, high = 1, f_low = distance_at_zero - distance, f_high = -distance;
    for (int i = 0; i < 200 && high - low > 1e-16; ++i) {
        double dip = (low * f_high - high * f_low) / (f_high - f_low);
        if (i % 4 == 3 || !(dip > low && dip < high)) dip = (low + high) / 2;
        const double f = centre_distance(spiral, dip) - distance;
        if (std::abs(f) < 1e-15) return dip;
        if (f > 0) {
            low = dip;
            f_low = f;
        } else {
            high = dip;
            f_high = f;
        }
    }
    return (low + high) / 2;
}

double positive_turn(double angle) {
    const double turn = lifted(angle, 0);
    return turn > 2 * pi - full_turn_slack ? 0 : turn;
}

/// Appends, joining it to the piece before when that goes on with the same slope.
void add_piece(std::vector<Clothoid>& pieces, Clothoid piece) {
    if (!(piece.length > 0)) return;
    if (!pieces.empty() && pieces.back().sharpness == piece.sharpness &&
        std::abs(pieces.back().end_curvature() - piece.curvature) < 1e-13)
        pieces.back().length += piece.length;
    else
        pieces.push_back(piece);
}

}  // namespace

double lifted(double angle, double low) {
    const double r = std::fmod(angle - low, 2 * pi);
    return low + (r < 0 ? r + 2 * pi : r);
}

Found same_side(const Task& task, double side) {
    const Spiral& spiral = task.spiral;
    const double begin = mirrored(side, task.begin), end = mirrored(side, task.end);
    const Point to{task.to.x, side * task.to.y};
    const double heading_to = side * task.heading;
    const Pose up = spiral.rise(begin), down = spiral.rise(end);  // `down` seen backwards and mirrored
    const double leave = heading_to - down.heading;
    const Point first = up.at + left_normal(unit(up.heading));
    const Point last =
        to - rotated({task.ahead.x, side * task.ahead.y}, {down.at.x, -down.at.y}) + left_normal(unit(leave));
    const double apart = distance(first, last), at_zero = centre_distance(spiral, 0);
    const bool straight = apart >= at_zero;
    const double dip = straight ? 0 : dip_for(spiral, apart, at_zero);
    const double half = spiral.full_heading - spiral.heading(dip), middle = straight ? apart - at_zero : 0;
    const double direction = apart > 1e-14 ? heading(last - first) : up.heading + half;
    const double a = positive_turn(direction - half - up.heading),
                 b = positive_turn(leave - direction - half);
    const double clothoids = (1 - begin + 1 - end + 2 * (1 - dip)) / spiral.sharpness;
    return {Found::same_side, clothoids + a + middle + b, a, middle, b, side, dip};
}

std::vector<Clothoid> pieces(const Task& task, const Found& found) {
    std::vector<Clothoid> forward, backward, result;
    const double slope = task.spiral.sharpness;
    if (found.family == Found::same_side) {
        const double side = found.side, begin = side * task.begin, end = side * task.end, dip = found.dip;
        for (const Clothoid& piece :
             {Clothoid{(1 - begin) / slope, task.begin, side * slope}, Clothoid{found.a, side, 0},
              Clothoid{(1 - dip) / slope, side, -side * slope}, Clothoid{found.middle, 0, 0},
              Clothoid{(1 - dip) / slope, side * dip, side * slope}, Clothoid{found.b, side, 0},
              Clothoid{(1 - end) / slope, side, -side * slope}})
            add_piece(result, piece);
        return result;
    }
    task.first.append(forward, found.a);
    task.last.append(backward, -found.b);
    if (found.family == Found::turn_straight_turn)
        forward.push_back({found.middle, 0, 0});
    else
        Turn(task.spiral, 0).append(forward, found.middle);
    for (const Clothoid& piece : forward) add_piece(result, piece);
    for (std::size_t i = backward.size(); i-- > 0;)
        add_piece(result, {backward[i].length, -backward[i].end_curvature(), backward[i].sharpness});
    return result;
}

}  // namespace strandline::turns
