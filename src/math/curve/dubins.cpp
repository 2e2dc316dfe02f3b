// Shortest curves of bounded curvature. Notation of Shkel and Lumelsky 2001: unit radius, d the distance,
// alpha and beta the headings against the line of sight; a word is three parts, each an arc or the straight
// in between.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "math/curve/curve.hpp"

namespace strandline {
namespace {

/// A turn this close to a whole one is rounding of no turn at all (radians).
constexpr double full_turn_slack = 1e-10;

struct Word {
    std::array<double, 3> lengths;  ///< in radii
    std::array<int, 3> turns;       ///< +1 left, 0 straight, -1 right
    double total() const { return lengths[0] + lengths[1] + lengths[2]; }
};

double positive_turn(double angle) {
    const double r = std::fmod(angle, 2 * pi), turn = r < 0 ? r + 2 * pi : r;
    return turn > 2 * pi - full_turn_slack ? 0 : turn;
}

/// First turn `a`, last turn `b` (signs), straight between. Mirrored so that the first is always to the left.
std::optional<Word> with_straight(double d, double alpha, double beta, int a, int b) {
    alpha *= a;
    beta *= a;
    const int same = a * b;  // 1: outer tangent, -1: inner tangent
    // Centres of the two circles; the first turns left after mirroring, the last left or right.
    const Point first{-std::sin(alpha), std::cos(alpha)};
    const Point last = Point{d, 0} + same * Point{-std::sin(beta), std::cos(beta)};
    const Point link = last - first;
    const double apart = length(link);
    if (same == 1) {
        const double direction = apart > 1e-12 ? heading(link) : alpha;
        return Word{{positive_turn(direction - alpha), apart, positive_turn(beta - direction)}, {a, 0, b}};
    }
    if (apart < 2) return std::nullopt;
    const double inner = std::sqrt(apart * apart - 4), direction = heading(link) + std::atan2(2, inner);
    return Word{{positive_turn(direction - alpha), inner, positive_turn(direction - beta)}, {a, 0, b}};
}

std::optional<Word> three_turns(double d, double alpha, double beta, int a) {
    alpha *= a;
    beta *= a;
    const Point first{-std::sin(alpha), std::cos(alpha)}, last{d - std::sin(beta), std::cos(beta)};
    const Point link = last - first;
    const double apart = length(link);
    if (apart > 4) return std::nullopt;
    // The middle circle touches both; the long way round it is the one that can be shortest.
    const double bend = std::acos(apart / 4), line = apart > 1e-12 ? heading(link) : alpha;
    const double first_leaves = line + bend + pi / 2;
    const double middle = pi + 2 * bend;
    return Word{{positive_turn(first_leaves - alpha), middle, positive_turn(beta - first_leaves + middle)},
                {a, -a, a}};
}

/// Of the six, those that exist.
std::array<std::optional<Word>, 6> words(Pose from, Pose to, double radius) {
    const Point chord = to.at - from.at;
    const double d = length(chord) / radius, sight = d > 0 ? heading(chord) : from.heading;
    const double alpha = wrap_angle(from.heading - sight), beta = wrap_angle(to.heading - sight);
    return {with_straight(d, alpha, beta, 1, 1),  with_straight(d, alpha, beta, -1, -1),
            with_straight(d, alpha, beta, 1, -1), with_straight(d, alpha, beta, -1, 1),
            three_turns(d, alpha, beta, 1),       three_turns(d, alpha, beta, -1)};
}

Word shortest(Pose from, Pose to, double radius) {
    const auto all = words(from, to, radius);
    Word best = *all.front();  // the first always exists
    for (const std::optional<Word>& word : all)
        if (word && word->total() < best.total()) best = *word;
    return best;
}

Curve curve_of(const Word& word, Pose from, double radius) {
    Curve curve{from, {}};
    for (std::size_t i = 0; i < 3; ++i)
        if (word.lengths[i] > 0)
            curve.pieces.push_back({word.lengths[i] * radius, word.turns[i] / radius, 0});
    return curve;
}

}  // namespace

Curve dubins(Pose from, Pose to, double radius) { return curve_of(shortest(from, to, radius), from, radius); }

std::vector<Curve> dubins_words(Pose from, Pose to, double radius) {
    std::vector<Word> found;
    for (const std::optional<Word>& word : words(from, to, radius))
        if (word) found.push_back(*word);
    std::ranges::stable_sort(found, {}, &Word::total);
    std::vector<Curve> curves;
    for (const Word& word : found) curves.push_back(curve_of(word, from, radius));
    return curves;
}

double dubins_length(Pose from, Pose to, double radius) {
    return radius * shortest(from, to, radius).total();
}

}  // namespace strandline
