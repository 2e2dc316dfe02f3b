// Curves between poses of a robot that may back up: a first part, a middle one driven the other way, a last
// one driven as the first. The first and the last are one turn each (or straight), whose lengths are
// searched; the middle part is the forward curve between the poses that are left, seen by a robot turned
// about.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "math/curve/curve.hpp"

namespace strandline {
namespace {

/// Lengths of the outer parts that are tried, in least radii; guesses try the second and the fourth alone.
constexpr std::array<double, 4> lengths_tried{0.4, 0.9, 1.6, 2.6};
/// So many of the guesses are searched further.
constexpr std::size_t most_searched = 3;
/// Steps of that search, in least radii: halved from the first to the last.
constexpr double first_step = 0.25, last_step = 0.015;
/// Curvature is asked for so much within its limits, that rounding never carries it over.
constexpr double inside_limit = 1 - 1e-9;

Pose turned_about(Pose pose) { return {pose.at, pose.heading + pi}; }
CurvatureState turned_about(const CurvatureState& state) {
    return {turned_about(state.pose), -state.curvature};
}
CurveLimits turned_about(const CurveLimits& limits) {
    const double right = limits.right_radius > 0 ? limits.right_radius : limits.radius;
    return {right, limits.sharpness, limits.radius};
}
/// The same way by a robot that was turned about before it: driven backwards what was driven forward.
Curve turned_about(Curve curve) {
    curve.start = turned_about(curve.start);
    for (Clothoid& piece : curve.pieces) {
        piece.length = -piece.length;
        piece.curvature = -piece.curvature;
    }
    return curve;
}

/// An outer part: how it bends, and how long it is.
struct Outer {
    double curvature = 0, length = 0;
};

class Search {
  public:
    Search(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits, double stand_cost)
        : from_(from), to_(to), limits_(limits), stand_cost_(stand_cost) {
        const double right = limits.right_radius > 0 ? limits.right_radius : limits.radius;
        left_ = inside_limit / limits.radius;
        right_ = -inside_limit / right;
        radius_ = std::max(limits.radius, right);
    }

    struct Guess {
        bool back = false;  ///< the outer parts are driven backwards, the middle one forward
        Outer first, last;
        double cost = 0;
    };

    /// Cheapest first, none of them as dear as `below`.
    std::vector<Guess> guesses(double below, std::size_t every) const {
        std::vector<Guess> found;
        for (const bool back : {false, true}) {
            const std::vector<Outer> tried = outers(every);
            std::vector<Pose> starts, ends;
            for (const Outer& outer : tried) {
                starts.push_back(end_pose(leaving(outer, back)));
                ends.push_back(arriving(outer, back).start);
            }
            for (std::size_t i = 0; i < tried.size(); ++i)
                for (std::size_t j = 0; j < tried.size(); ++j) {
                    // without any outer part, the one that backs is the middle
                    const double outside = tried[i].length + tried[j].length;
                    const double always = outside + stand_cost_ * stands_of(back, tried[i], tried[j]);
                    if (always + distance(starts[i].at, ends[j].at) >= below || (back && outside == 0))
                        continue;
                    const double cost = always + (back ? dubins_length(starts[i], ends[j], radius_)
                                                       : dubins_length(turned_about(starts[i]),
                                                                       turned_about(ends[j]), radius_));
                    if (cost < below) found.push_back({back, tried[i], tried[j], cost});
                }
        }
        std::ranges::stable_sort(found, {}, &Guess::cost);
        return found;
    }

    /// With arcs and lines for the middle part.
    Curve guessed(const Guess& guess) const {
        return whole(guess, [&](Pose a, Pose b) { return dubins(a, b, radius_); });
    }
    /// Within the limits of sharpness, too.
    Curve made(const Guess& guess, bool refined) const {
        const CurveLimits limits = guess.back ? limits_ : turned_about(limits_);
        return whole(guess, [&](Pose a, Pose b) {
            const Curve word = dubins(a, b, radius_);
            // The robot stands at both ends and sets off as bent as the word does ...
            const auto bend = [&](double curvature) {
                const double right = limits.right_radius > 0 ? limits.right_radius : limits.radius;
                return curvature > 0   ? inside_limit / limits.radius
                       : curvature < 0 ? -inside_limit / right
                                       : 0;
            };
            double first = word.pieces.empty() ? 0 : bend(word.pieces.front().curvature),
                   last = word.pieces.empty() ? 0 : bend(word.pieces.back().curvature);
            // ... but where nothing is backed before the middle part, or after it
            if (guess.back && guess.first.length == 0) first = from_.curvature;
            if (guess.back && guess.last.length == 0) last = to_.curvature;
            return refined ? refined_continuous_curvature({a, first}, {b, last}, limits)
                           : continuous_curvature({a, first}, {b, last}, limits);
        });
    }
    double cost_of(const Curve& curve) const { return length(curve) + stand_cost_ * stands(curve); }

    /// Changes the outer parts' lengths as long as the curve gets cheaper.
    void improve(Guess& guess) const {
        guess.cost = cost_of(made(guess, false));
        for (double step = first_step; step > last_step;) {
            bool gained = false;
            for (Outer Guess::*outer : {&Guess::first, &Guess::last})
                for (const double way : {1.0, -1.0}) {
                    Guess other = guess;
                    if ((other.*outer).length == 0) continue;
                    (other.*outer).length += way * step * radius_;
                    if ((other.*outer).length <= 0) continue;
                    other.cost = cost_of(made(other, false));
                    if (other.cost >= guess.cost) continue;
                    guess = other;
                    gained = true;
                }
            if (!gained) step /= 2;
        }
    }

  private:
    std::vector<Outer> outers(std::size_t every) const {
        std::vector<Outer> list{{}};
        for (const double curvature : {left_, 0.0, right_})
            for (std::size_t i = every - 1; i < lengths_tried.size(); i += every)
                list.push_back({curvature, lengths_tried[i] * radius_});
        return list;
    }
    static int stands_of(bool back, const Outer& first, const Outer& last) {
        return back ? 2 * ((first.length > 0) + (last.length > 0)) : 2;
    }
    /// A turn from a state; one that is left backwards is left from a stand, with the wheels turned.
    Curve turn(const CurvatureState& from, const Outer& outer, bool back) const {
        Curve curve{from.pose, {}};
        if (outer.length == 0) return curve;
        double left = outer.length;
        if (!back) {
            const double rise = outer.curvature - from.curvature,
                         taken = std::min(left, std::abs(rise) / limits_.sharpness);
            if (taken > 0)
                curve.pieces.push_back({taken, from.curvature, std::copysign(limits_.sharpness, rise)});
            left -= taken;
        }
        if (left > 0) curve.pieces.push_back({back ? -left : left, outer.curvature, 0});
        return curve;
    }
    Curve leaving(const Outer& outer, bool back) const { return turn(from_, outer, back); }
    Curve arriving(const Outer& outer, bool back) const {
        return reversed(turn(turned_about(to_), {-outer.curvature, outer.length}, back));
    }
    template <class Between>
    Curve whole(const Guess& guess, const Between& forward) const {
        const Curve first = leaving(guess.first, guess.back), last = arriving(guess.last, guess.back);
        const Pose a = end_pose(first), b = last.start;
        const Curve middle =
            guess.back ? forward(a, b) : turned_about(forward(turned_about(a), turned_about(b)));
        Curve curve{from_.pose, {}};
        for (const Curve& part : {first, middle, last})
            curve.pieces.insert(curve.pieces.end(), part.pieces.begin(), part.pieces.end());
        return curve;
    }

    CurvatureState from_, to_;
    CurveLimits limits_;
    double stand_cost_, left_, right_, radius_;
};

}  // namespace

std::optional<Curve> backing_curve(const CurvatureState& from, const CurvatureState& to,
                                   const CurveLimits& limits, double stand_cost, double below) {
    const Search search(from, to, limits, stand_cost);
    std::vector<Search::Guess> guesses = search.guesses(below, 1);
    if (guesses.size() > most_searched) guesses.resize(most_searched);
    std::optional<Curve> best;
    for (Search::Guess& guess : guesses) {
        search.improve(guess);
        Curve curve = search.made(guess, true);
        const double cost = search.cost_of(curve);
        if (cost >= below) continue;
        below = cost;
        best = std::move(curve);
    }
    return best;
}

std::optional<Curve> backing_guess(Pose from, Pose to, double radius, double stand_cost, double below) {
    // no clothoids: as good as infinite sharpness
    const Search search({from, 0}, {to, 0}, {radius, 1e12, radius}, stand_cost);
    const std::vector<Search::Guess> guesses = search.guesses(below, 2);
    if (guesses.empty()) return std::nullopt;
    return search.guessed(guesses.front());
}

}  // namespace strandline
