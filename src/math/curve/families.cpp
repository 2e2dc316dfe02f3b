#include "math/curve/families.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace strandline::turns {
namespace {

/// A turn this close to a whole one is rounding of no turn at all (radians).
constexpr double full_turn_slack = 1e-12;

double mirrored(double side, double value) { return side * value; }

/// How far apart the centres of two full turns to that side lie when the curvature dips to `dip` between
/// them.
double centre_distance(const Spiral& spiral, double side, double dip) {
    const Pose up = spiral.rise(dip, side);
    return 2 * (up.at.x - std::sin(up.heading) / spiral.limit(side).curvature);
}

/// A dip for every distance below that of the dip to 0: the distance is continuous in the dip, 0 at the
/// limit.
double dip_for(const Spiral& spiral, double side, double distance, double distance_at_zero) {
    double low = 0, high = spiral.limit(side).curvature;
    double f_low = distance_at_zero - distance, f_high = -distance;
    for (int i = 0; i < 200 && high - low > 1e-16; ++i) {
        double dip = (low * f_high - high * f_low) / (f_high - f_low);
        if (i % 4 == 3 || !(dip > low && dip < high)) dip = (low + high) / 2;
        const double f = centre_distance(spiral, side, dip) - distance;
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
    const double most = spiral.limit(side).curvature, radius = 1 / most;
    const double begin = mirrored(side, task.begin), end = mirrored(side, task.end);
    const Point to{task.to.x, side * task.to.y};
    const double heading_to = side * task.heading;
    // `down` is seen backwards and mirrored
    const Pose up = spiral.rise(begin, side), down = spiral.rise(end, side);
    const double leave = heading_to - down.heading;
    const Point first = up.at + radius * left_normal(unit(up.heading));
    const Point last = to - rotated({task.ahead.x, side * task.ahead.y}, {down.at.x, -down.at.y}) +
                       radius * left_normal(unit(leave));
    const double apart = distance(first, last), at_zero = centre_distance(spiral, side, 0);
    const bool straight = apart >= at_zero;
    const double dip = straight ? 0 : dip_for(spiral, side, apart, at_zero);
    const double half = spiral.limit(side).heading - spiral.heading(dip),
                 middle = straight ? apart - at_zero : 0;
    const double direction = apart > 1e-14 ? heading(last - first) : up.heading + half;
    const double a = radius * positive_turn(direction - half - up.heading),
                 b = radius * positive_turn(leave - direction - half);
    const double clothoids = (most - begin + most - end + 2 * (most - dip)) / spiral.sharpness;
    return {Found::same_side, clothoids + a + middle + b, a, middle, b, side, dip};
}

namespace {

using Pieces = std::vector<Clothoid>;

/// The curvature (seen so that it begins by going up when `sign` is 1) by ramps at full sharpness through
/// peaks and stays at them.
Pieces zigzag(double side, double begin, double end, double slope,
              std::initializer_list<std::pair<double, double>> peaks_and_stays) {
    Pieces result;
    double at = begin, sign = 1;
    for (const auto& [peak, stay] : peaks_and_stays) {
        add_piece(result, {sign * (peak - at) / slope, side * at, side * sign * slope});
        add_piece(result, {stay, side * peak, 0});
        at = peak;
        sign = -sign;
    }
    add_piece(result, {sign * (end - at) / slope, side * at, side * sign * slope});
    return result;
}

}  // namespace

std::vector<Clothoid> pieces(const Task& task, const Found& found) {
    const double slope = task.spiral.sharpness, side = found.side;
    const double begin = side * task.begin, end = side * task.end;
    if (found.family == Found::same_side) {
        const double most = task.spiral.limit(side).curvature;
        return zigzag(side, begin, end, slope, {{most, found.a}, {found.dip, found.middle}, {most, found.b}});
    }
    if (found.family == Found::three_peaks) {
        const auto peak = [&](double q) { return peak_and_stay(task.spiral, side, q); };
        return zigzag(side, begin, end, slope, {peak(found.a), peak(found.middle), peak(found.b)});
    }
    Pieces forward, backward, result;
    task.first.append(forward, found.a);
    task.last.append(backward, -found.b);
    forward.push_back({found.middle, 0, 0});
    for (const Clothoid& piece : forward) add_piece(result, piece);
    for (std::size_t i = backward.size(); i-- > 0;)
        add_piece(result, {backward[i].length, -backward[i].end_curvature(), backward[i].sharpness});
    return result;
}

}  // namespace strandline::turns
