#pragma once
// Private to the room: taut strings over oriented circles, and curves made of them.
// Key: a circle's `side` is +1 where the string turns left round it, -1 right. Nodes of the graph: corner k
// turned round to the right is 2 k, to the left 2 k + 1; then the circles beside starts, then those beside
// ends, two each, in the same order.
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "path/route/route.hpp"

namespace strandline::route {

struct Circle {
    Point centre;
    double radius = 0, side = 1;
};
/// The straight part between two circles that keeps both senses.
struct Tangent {
    Point from, to;
    Point ahead;  ///< unit vector
    double length;
};
/// nullopt: one circle lies within the other, or the circles of unlike sides overlap.
std::optional<Tangent> tangent(const Circle& a, const Circle& b);

/// The same where it touches the corners that the circles are round, if they are round any.
std::optional<Tangent> taut_tangent(const Circle& a, const Corner* at_a, const Circle& b, const Corner* at_b);

/// Where a string may begin or end, and what was spent before or is after.
struct Anchor {
    Pose pose;
    double cost = 0;
};
/// Circles that a robot turns on beside a pose: [0] right, [1] left.
struct TurningRadii {
    double right, left;
    double of(double side) const { return side > 0 ? left : right; }
};
Circle beside(Pose pose, double side, const TurningRadii& radii);

struct Bend {
    std::size_t corner = 0;
    double side = 1;
};
struct String {
    std::size_t start = 0, end = 0;  ///< anchors
    double start_side = 1, end_side = 1;
    std::vector<Bend> bends;
    std::vector<int> nodes;  ///< bends with both ends' circles: what bans speak of
    double cost = 0;
};
/// Parts of strings that cannot be driven: node, node, node; the first -1: the edge, from wherever.
using Ban = std::array<int, 3>;
using Bans = std::set<Ban>;

struct Quest {
    const Ground& ground;
    const std::vector<Anchor>&starts, &ends;
    TurningRadii radii;
    /// Straight parts that do not keep the clearance: refused, or a metre of it costs so much.
    std::optional<double> blemish_weight;
    double limit = std::numeric_limits<double>::infinity();  ///< costs above this are of no use
};
/// The cheapest string that is not banned; nullopt: none within the limit. O(nodes taken x their links), and
/// corners for each start; with a blemish weight O(nodes taken x corners), and given up after 40 nodes.
std::optional<String> taut_string(const Quest& quest, const Bans& bans);

struct Driven {
    std::optional<Curve> curve;
    std::vector<Pose> through;  ///< between the bends
    Ban stuck{};                ///< where there is no curve: what could not be driven
};
/// The string as a G2 curve within the limits, clear of the ground (or, `forgiving`, whatever it drives
/// over). The ends are the shortest clear curves to and from one of a few places along it. 0.1 ms.
Driven driven(const Ground& ground, const CurvatureState& from, const CurvatureState& to,
              const String& string, const CurveLimits& limits, bool forgiving);
/// How a turn by an angle from curvature 0 to 0 lies: its arc's centre is `height` beside both lines, and it
/// begins `lead` before the centre's foot on the first. Its arc, or its sharpest point, is `peak_radius` from
/// the centre.
struct Turn {
    double peak_radius, height, lead;
    std::vector<Clothoid> pieces;
};
/// `angle` > 0, to `side`; the radius at least `radius`.
Turn turn(double angle, double side, double radius, double sharpness);

}  // namespace strandline::route
