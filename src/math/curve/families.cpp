#include "math/curve/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace strandline::turns {
namespace {

/// A turn this close to a whole one is rounding of no turn at all (radians).
constexpr double full_turn_slack = 1e-12;
/// Positions are met to this share of (1 + distance) when a root counts as found.
constexpr double accuracy = 1e-12;

/// From curvature `begin` up to 1: where it ends and how it looks there.
Pose rise(const Spiral& spiral, double begin) {
    const double h = spiral.heading(begin);
    return {rotated(unit(-h), spiral.full - spiral.at(begin)), spiral.full_heading - h};
}

double mirrored(double side, double value) { return side * value; }

/// How far apart the centres of two full left turns lie when the curvature dips to `dip` between them.
double centre_distance(const Spiral& spiral, double dip) {
    const Pose up = rise(spiral, dip);
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
        if (f > 0)
            low = dip, f_low = f;
        else
            high = dip, f_high = f;
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
    const Pose up = rise(spiral, begin), down = rise(spiral, end);  // `down` seen backwards and mirrored
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

namespace {

/// Samples of a full turn. Roots nearer than that are found by their neighbours' sign only.
constexpr int grid = 16;

}  // namespace

void add_turn_straight_turn(const Task& task, std::vector<Found>& found) {
    // The first turn by a, the last by b, a + b = heading of the end up to whole turns. The link from where
    // the first ends to where the last begins must look along the heading between them: one equation in a, on
    // a few lines a + b.
    const double step = 2 * pi / grid, low_a = task.first.natural - 2 * pi;
    const double natural_b = task.last_natural();
    const double low_b = natural_b - 2 * pi + lifted(task.heading - task.first.natural - natural_b, 0) -
                         step * std::floor(lifted(task.heading - task.first.natural - natural_b, 0) / step);
    std::array<Turn::End, 2 * grid + 1> exits, entries;
    std::array<Point, grid> directions;
    for (int i = 0; i <= 2 * grid; ++i) {
        exits[static_cast<std::size_t>(i)] = task.first.end(low_a + i * step);
        entries[static_cast<std::size_t>(i)] = task.entry(low_b + i * step);
        if (i < grid) directions[static_cast<std::size_t>(i)] = unit(low_a + i * step);
    }
    const int first_line =
        static_cast<int>(std::lround(lifted(task.heading - low_a - low_b, 0) / step)) % grid;
    const double tolerance = accuracy * (1 + length(task.to));
    double best = std::numeric_limits<double>::infinity();
    for (const Found& f : found) best = std::min(best, f.length);

    for (int line = first_line; line <= 4 * grid; line += grid) {
        const double sum = low_a + low_b + line * step;
        // Exact, so that the end's heading is met to rounding.
        const double total = task.heading + 2 * pi * std::round((sum - task.heading) / (2 * pi));
        double f_before = 0, g_before = 0, length_before = 0;
        bool known = false;
        for (int i = std::max(0, line - 2 * grid); i <= std::min(2 * grid, line); ++i) {
            const Turn::End& exit = exits[static_cast<std::size_t>(i)];
            const Turn::End& entry = entries[static_cast<std::size_t>(line - i)];
            const Point ahead = directions[static_cast<std::size_t>(i % grid)], link = entry.at - exit.at;
            const double f = cross(ahead, link), g = dot(ahead, link);
            const double around = exit.length + entry.length;
            const bool crosses = known && (f > 0) != (f_before > 0);
            const bool forward = std::max(g, g_before) >= 0;
            const bool hopeful =
                std::min(around, length_before) + std::max(0.0, std::min(g, g_before)) < best;
            if (crosses && forward && hopeful) {
                double a = low_a + (i - 1) * step, b = low_a + i * step, fa = f_before, fb = f;
                for (int k = 0; k < 60; ++k) {
                    double at = (a * fb - b * fa) / (fb - fa);
                    if (k % 8 == 7 || !(at > a && at < b)) at = (a + b) / 2;
                    const Turn::End leave = task.first.end(at), enter = task.entry(total - at);
                    const Point way = unit(at), between = enter.at - leave.at;
                    const double miss = cross(way, between), along = dot(way, between);
                    if (std::abs(miss) <= tolerance || b - a < 1e-15) {
                        if (std::abs(miss) <= 100 * tolerance && along >= -tolerance) {
                            const double straight = std::max(0.0, along);
                            const double whole = leave.length + straight + enter.length;
                            found.push_back({Found::turn_straight_turn, whole, at, straight, total - at});
                            best = std::min(best, whole);
                        }
                        break;
                    }
                    // Illinois: the end that stays counts half.
                    if ((miss > 0) == (fb > 0)) {
                        b = at, fb = miss, fa /= 2;
                    } else {
                        a = at, fa = miss, fb /= 2;
                    }
                }
            }
            f_before = f, g_before = g, length_before = around, known = true;
        }
    }
}

void add_three_turns(const Task& task, double side, std::vector<Found>& found) {
    const Spiral& spiral = task.spiral;
    // Saturated turns first: circles whose centres form a triangle with two known sides.
    const Pose up = rise(spiral, side * task.begin), down = rise(spiral, side * task.end);
    const double heading_to = side * task.heading, leave = heading_to - down.heading;
    const Point to{task.to.x, side * task.to.y};
    const Point first = up.at + left_normal(unit(up.heading));
    const Point last =
        to - rotated({task.ahead.x, side * task.ahead.y}, {down.at.x, -down.at.y}) + left_normal(unit(leave));
    // From the left centre to the right one, seen along the heading at the change of sides.
    const double h = spiral.full_heading;
    const Point half{spiral.full.x - std::sin(h), -spiral.full.y - std::cos(h)};
    const double reach = 2 * length(half), apart = distance(first, last);
    if (apart > 2 * reach) return;
    const double line = apart > 1e-12 ? heading(last - first) : 0;
    const double bend = std::acos(apart / (2 * reach)), tilt = heading(half);
    const Turn middle(spiral, 0);
    const double tolerance = accuracy * (1 + length(task.to));
    for (double sign : {1.0, -1.0}) {
        const double h1 = line + sign * bend - tilt, h2 = line - sign * bend + tilt;
        double a = side * lifted(h1, side * task.first.natural), m = -side * lifted(h1 - h2, 0);
        double b = side * lifted(heading_to - h2, side * task.last_natural());
        const double total = task.heading + 2 * pi * std::round((a + m + b - task.heading) / (2 * pi));
        const auto miss = [&](double first_angle, double middle_angle) {
            const Point turned = rotated(unit(first_angle), middle.end(middle_angle).at);
            return task.first.end(first_angle).at + turned -
                   task.entry(total - first_angle - middle_angle).at;
        };
        Point f = miss(a, m);
        constexpr double delta = 1e-7;
        for (int k = 0; k < 12 && length(f) > tolerance; ++k) {
            const Point fa = (1 / delta) * (miss(a + delta, m) - f),
                        fm = (1 / delta) * (miss(a, m + delta) - f);
            const double det = cross(fa, fm);
            if (det == 0) break;
            double da = -cross(f, fm) / det, dm = -cross(fa, f) / det;
            const double biggest = std::max(std::abs(da), std::abs(dm));
            if (biggest > 1) da /= biggest, dm /= biggest;
            a += da, m += dm;
            f = miss(a, m);
        }
        if (!(length(f) <= 100 * tolerance)) continue;
        b = total - a - m;
        const double whole = task.first.end(a).length + middle.end(m).length + task.last.end(-b).length;
        found.push_back({Found::three_turns, whole, a, m, b, side});
    }
}

}  // namespace strandline::turns
