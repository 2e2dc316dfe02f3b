// A taut string driven: at each bend a turn of least radius, placed so that it just keeps its distance from
// the corner; straight between; and the shortest clear curves at both ends.
#include <algorithm>
#include <cmath>

#include "path/route/string.hpp"

namespace strandline::route {
namespace {

/// A bend by less than this (radians) is left to its neighbours.
constexpr double least_bend = 1e-3;
/// Radii and angles of the bends depend on each other.
constexpr int settling_rounds = 4;

struct Placed {
    Bend bend;
    int node;
    Circle circle;  ///< what the straight parts are tangent to
    Turn turn{};
    Pose entry{}, exit{};
};

struct Layout {
    std::vector<Placed> bends;
    std::vector<Tangent> lines;  ///< one more
};

class Driver {
  public:
    Driver(const Ground& ground, const CurvatureState& from, const CurvatureState& to, const String& string,
           const CurveLimits& limits, bool forgiving)
        : ground_(ground), from_(from), to_(to), string_(string), limits_(limits), forgiving_(forgiving) {}

    Driven drive() {
        Layout layout;
        for (std::size_t i = 0; i < string_.bends.size(); ++i)
            layout.bends.push_back(
                {string_.bends[i],
                 string_.nodes[i + 1],
                 {corner(string_.bends[i]).at, ground_.string_offset(), string_.bends[i].side}});
        if (!settle(layout)) return stuck(0, layout);
        if (!chain(layout)) return result_;
        finish(layout);
        return result_;
    }

  private:
    const Corner& corner(const Bend& bend) const { return ground_.corners()[bend.corner]; }
    double radius(double side) const {
        return side < 0 && limits_.right_radius > 0 ? limits_.right_radius : limits_.radius;
    }
    bool clear(const Curve& curve) const { return forgiving_ || ground_.clear(curve); }

    /// Edge number k of the layout cannot be driven.
    Driven stuck(std::size_t k, const Layout& layout) {
        const auto node = [&](std::size_t i) {
            if (i == 0) return string_.nodes.front();
            return i <= layout.bends.size() ? layout.bends[i - 1].node : string_.nodes.back();
        };
        const bool inner = k > 0 && k < layout.bends.size();
        result_.curve.reset();
        result_.stuck = {inner ? node(k - 1) : -1, node(k), node(k + 1)};
        return result_;
    }

    bool draw_lines(Layout& layout) const {
        const TurningRadii radii{radius(-1), radius(1)};
        layout.lines.clear();
        Circle a = beside(from_.pose, string_.start_side, radii);
        for (std::size_t i = 0; i <= layout.bends.size(); ++i) {
            const Circle b =
                i < layout.bends.size() ? layout.bends[i].circle : beside(to_.pose, string_.end_side, radii);
            const auto line = tangent(a, b);
            if (!line) return false;
            layout.lines.push_back(*line);
            a = b;
        }
        return true;
    }

    /// Turns at the bends, lines that are tangent to them: by turns, until they agree.
    bool settle(Layout& layout) const {
        for (int round = 0;; ++round) {
            if (!draw_lines(layout)) return false;
            for (std::size_t i = 0; i < layout.bends.size();) {
                Placed& placed = layout.bends[i];
                const Point in = layout.lines[i].ahead, out = layout.lines[i + 1].ahead;
                const double side = placed.bend.side, angle = side * std::atan2(cross(in, out), dot(in, out));
                if (angle < least_bend && angle > -pi / 2) {
                    layout.bends.erase(layout.bends.begin() + static_cast<std::ptrdiff_t>(i));
                    if (!draw_lines(layout)) return false;
                    round = std::min(round, settling_rounds - 1);  // the lines moved: once more
                    continue;
                }
                place(placed, angle < 0 ? angle + 2 * pi : angle, layout.lines[i], layout.lines[i + 1]);
                ++i;
            }
            if (round >= settling_rounds) return true;
        }
    }

    /// The turn, for these lines; and the circle that the next lines are to be tangent to.
    void place(Placed& placed, double angle, const Tangent& in, const Tangent& out) const {
        const double side = placed.bend.side, offset = ground_.string_offset();
        placed.turn = turn(angle, side, std::max(radius(side), offset), limits_.sharpness);
        const double shift = placed.turn.peak_radius - offset;
        placed.circle.radius = placed.turn.height - shift * std::cos(angle / 2);
        const Point middle = normalized(in.ahead + out.ahead);
        const Point outwards = -side * left_normal(angle < pi ? middle : -middle);
        const Point centre = placed.circle.centre - shift * outwards;
        const auto foot = [&](const Tangent& line) {
            return line.from + dot(centre - line.from, line.ahead) * line.ahead;
        };
        placed.entry = {foot(in) - placed.turn.lead * in.ahead, heading(in.ahead)};
        placed.exit = {foot(out) + placed.turn.lead * out.ahead, heading(out.ahead)};
    }

    /// Straight parts and turns from end to end, all of them clear.
    bool chain(const Layout& layout) {
        const auto& bends = layout.bends;
        const Tangent &first = layout.lines.front(), &last = layout.lines.back();
        Pose at{first.from, heading(first.ahead)};
        const auto ahead_of = [](Pose a, Point b) { return dot(b - a.at, unit(a.heading)); };
        if (!bends.empty()) at.at = at.at + std::min(0.0, ahead_of(at, bends[0].entry.at)) * first.ahead;
        chain_ = {at, {}};
        joints_ = {0};
        for (std::size_t i = 0; i < bends.size();) {
            std::size_t next = i + 1;  // turns that come too close to each other are driven as one
            while (next < bends.size() && ahead_of(bends[next - 1].exit, bends[next].entry.at) < 0) ++next;
            const Pose entry = bends[i].entry, exit = bends[next - 1].exit;
            if (i > 0) result_.through.push_back({between(at.at, entry.at, 0.5), entry.heading});
            const Curve line = straight(at, std::max(0.0, ahead_of(at, entry.at)));
            if (i > 0 && !clear(line)) return stuck(i, layout), false;
            chain_ = joined(std::move(chain_), line);
            joints_.push_back(length(chain_));
            Curve turned{entry, bends[i].turn.pieces};
            if (next > i + 1) turned = continuous_curvature({entry, 0}, {exit, 0}, limits_);
            if (!clear(turned)) return stuck(next > i + 1 ? i + 1 : i, layout), false;
            chain_ = joined(std::move(chain_), turned);
            joints_.push_back(length(chain_));
            at = exit;
            i = next;
        }
        chain_ = joined(std::move(chain_), straight(at, std::max(0.0, ahead_of(at, last.to))));
        joints_.push_back(length(chain_));
        return true;
    }

    /// A curve between an end and a place along the chain.
    struct Reach {
        double s;
        Curve curve;
        double cost;  ///< metres more than leaving out the chain's part
    };
    std::vector<Reach> reaches(bool head) const {
        const std::size_t n = joints_.size();
        const auto joint = [&](std::size_t i) { return head ? joints_[i] : joints_[n - 1 - i]; };
        // the end of its circle, half-way to the first bend, the bend's ends, the next bend's
        std::vector<double> places{joint(0), (joint(0) + joint(1)) / 2};
        for (std::size_t i = 1; i < std::min<std::size_t>(n, 5); ++i) places.push_back(joint(i));
        std::vector<Reach> result;
        for (const double s : places) {
            const CurvatureState there{point_at(chain_, s).pose, 0};
            Curve curve = head ? continuous_curvature(from_, there, limits_)
                               : continuous_curvature(there, to_, limits_);
            const double cost = length(curve) + (head ? -s : s);
            result.push_back({s, std::move(curve), cost});
        }
        std::ranges::sort(result, {}, &Reach::cost);
        return result;
    }

    /// The cheapest clear curves at both ends that leave the chain its sense.
    void finish(const Layout& layout) {
        std::vector<Reach> heads = reaches(true), tails = reaches(false);
        std::erase_if(heads, [&](const Reach& r) { return !clear(r.curve); });
        if (heads.empty()) return void(stuck(0, layout));
        std::erase_if(tails, [&](const Reach& r) { return !clear(r.curve); });
        if (tails.empty()) return void(stuck(layout.bends.size(), layout));
        const Reach *best_head = nullptr, *best_tail = nullptr;
        for (const Reach& head : heads)
            for (const Reach& tail : tails)
                if (head.s <= tail.s &&
                    (!best_head || head.cost + tail.cost < best_head->cost + best_tail->cost)) {
                    best_head = &head;
                    best_tail = &tail;
                }
        if (!best_head) return void(stuck(0, layout));
        Curve curve = joined(best_head->curve, slice(chain_, best_head->s, best_tail->s));
        result_.curve = joined(std::move(curve), best_tail->curve);
        // the first and last straight parts hang in the air where the ends came in later
        if (!clear(*result_.curve))
            stuck(clear(slice(chain_, best_head->s, joints_[1])) ? layout.bends.size() : 0, layout);
    }

    const Ground& ground_;
    const CurvatureState &from_, &to_;
    const String& string_;
    const CurveLimits& limits_;
    bool forgiving_;
    Driven result_;
    Curve chain_;
    std::vector<double> joints_;  ///< arc lengths along the chain: its ends and those of its turns
};

}  // namespace

Turn turn(double angle, double side, double radius, double sharpness) {
    const double limit = 1 / radius, full = limit * limit / sharpness;  // angle of both clothoids
    const double peak = angle >= full ? limit : std::sqrt(angle * sharpness);
    const double ramp = peak / sharpness, arc = std::max(0.0, angle - full) / peak;
    const Pose top = advanced({}, {ramp, 0, sharpness}, ramp);
    const Point centre = top.at + (1 / peak) * left_normal(unit(top.heading));
    Turn result{1 / peak, centre.y, centre.x, {{ramp, 0, side * sharpness}}};
    if (arc > 0) result.pieces.push_back({arc, side * peak, 0});
    result.pieces.push_back({ramp, side * peak, -side * sharpness});
    return result;
}

Driven driven(const Ground& ground, const CurvatureState& from, const CurvatureState& to,
              const String& string, const CurveLimits& limits, bool forgiving) {
    return Driver(ground, from, to, string, limits, forgiving).drive();
}

}  // namespace strandline::route
