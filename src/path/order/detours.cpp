#include "path/order/detours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "path/order/worth.hpp"

namespace strandline::order {
namespace {

/// Poses that detours are led through lie so many least radii farther on.
constexpr std::array<double, 5> further{0, 0.6, 1.5, 3, 6};
/// Radius of the words that detours are guessed by: a turn with its clothoids takes more room than an arc.
constexpr double wider = 1.06;
/// So many of the guessed detours are made.
constexpr std::size_t most_made = 6;
/// A robot that may back up is led round from so far behind an end, or to so far beyond it, least radii.
constexpr std::array<double, 3> backed_out{1, 2, 4};
/// A straight part shorter than this (least radii) holds no pose to be led through.
constexpr double least_straight = 0.1;

Pose moved_on(Pose pose, double by) { return {pose.at + by * unit(pose.heading), pose.heading}; }

/// A detour by Dubins' words.
struct Guess {
    std::vector<Pose> through;
    double cost;
};

class Chooser {
  public:
    Chooser(const CurvatureState& from, const CurvatureState& to, const Finished& finished,
            const Pairs& pairs, const Options& options)
        : from_(from), to_(to), finished_(finished), pairs_(pairs), options_(options) {}

    Driven choose(connect::Connection direct, std::vector<Passage>& tried) {
        const double turn_cost = options_.connect.turn_cost;
        best_ = {std::move(direct)};
        double turned = 0;
        for (const double turn : {best_.joint.turn_before, best_.joint.turn_after})
            if (turn != 0) turned += options_.connect.turn_start + turn_cost * std::abs(turn);
        weigh(best_, turned, tried);
        if (best_.spoilt.none()) return best_;
        back_up(tried);
        for (const Guess& guess : guesses()) {
            Driven other{{0, 0, led(guess.through)}, guess.through};
            weigh(other, 0, tried);
            if (other.cost < best_.cost) best_ = std::move(other);
        }
        if (best_.spoilt.metres > 0 || best_.spoilt.hard > 0) go_round(finished_.ground, tried);
        back_out(tried);
        if (best_.spoilt.hard > 0) go_round(pairs_.hard().narrow(), tried);
        return best_;
    }

  private:
    /// Where the way asked for backs up, the one that does not, and the other way round.
    void back_up(std::vector<Passage>& tried) {
        const connect::Options& options = options_.connect;
        if (!options.back_up || options.style == connect::Style::straight) return;
        Driven other;
        if (stands(best_.joint.curve) > 0) {
            other.joint.curve = refined_continuous_curvature(from_, to_, options.limits);
        } else {
            auto backed = backing_curve(from_, to_, options.limits, options.stand_cost, best_.cost);
            if (!backed) return;
            other.joint.curve = std::move(*backed);
        }
        weigh(other, 0, tried);
        if (other.cost < best_.cost) best_ = std::move(other);
    }
    /// `out`: metres that the robot first backs straight out, `in`: those that it backs in at the end.
    void go_round(const route::Ground& ground, std::vector<Passage>& tried, double out = 0, double in = 0) {
        const Pose passed = moved_on(to_.pose, in);
        const CurvatureState from = out > 0 ? CurvatureState{moved_on(from_.pose, -out), 0} : from_,
                             to = in > 0 ? CurvatureState{passed, 0} : to_;
        route::Way way = route::way(ground, from, to, {.limits = options_.connect.limits});
        Driven other;
        if (out == 0 && in == 0) other.through = std::move(way.through);
        if (out > 0) other.joint.curve = straight(from_.pose, -out);
        other.joint.curve = joined(std::move(other.joint.curve), way.curve);
        if (in > 0) other.joint.curve = joined(std::move(other.joint.curve), straight(passed, -in));
        weigh(other, 0, tried);
        if (other.cost < best_.cost) best_ = std::move(other);
    }
    /// Out of places that cannot be left forwards, and into those that cannot be come to.
    void back_out(std::vector<Passage>& tried) {
        if (!options_.connect.back_up) return;
        for (const double radii : backed_out) {
            const double metres = radii * options_.connect.limits.radius;
            if (best_.spoilt.metres > 0 || best_.spoilt.hard > 0) go_round(finished_.ground, tried, metres);
            if (best_.spoilt.metres > 0 || best_.spoilt.hard > 0)
                go_round(finished_.ground, tried, 0, metres);
        }
    }
    void weigh(Driven& driven, double turned, std::vector<Passage>& tried) const {
        const Curve& curve = driven.joint.curve;
        driven.spoilt = spoilt(curve, finished_, pairs_, options_);
        const double always = worth(curve, options_) + turned + driven.spoilt.hard * hard_cost;
        driven.cost = always + worth_of(driven.spoilt.all_metres(), driven.spoilt.all_crossings());
        tried.push_back(
            pairs_.passage(always, curve, {.area = options_.avoid.area_cost * options_.avoid.near_share}));
    }

    double worth_of(double metres, int crossings) const {
        return crossings * options_.avoid.crossing_cost + metres * options_.avoid.area_cost;
    }

    /// The cheapest ones by what words spoil, those only that may gain.
    std::vector<Guess> guesses() const {
        const double radius =
            wider * std::max(options_.connect.limits.radius, options_.connect.limits.right_radius);
        std::vector<Guess> found;
        for (const double before : further)
            for (const double after : further) {
                const Pose a = moved_on(from_.pose, before * radius), b = moved_on(to_.pose, -after * radius);
                for (Curve& word : dubins_words(a, b, radius)) {
                    Guess guess;
                    if (before > 0) guess.through.push_back(a);
                    double s = 0;
                    for (const Clothoid& piece : word.pieces) {
                        if (piece.curvature == 0 && piece.length > least_straight * radius)
                            guess.through.push_back(point_at(word, s + piece.length / 2).pose);
                        s += piece.length;
                    }
                    if (after > 0) guess.through.push_back(b);
                    const double whole = (before + after) * radius + s;
                    if (guess.through.empty() || whole >= best_.cost) continue;
                    if (before > 0) word = joined(straight(from_.pose, before * radius), word);
                    if (after > 0) word = joined(std::move(word), straight(b, after * radius));
                    const Passage passage = pairs_.passage(
                        whole, word,
                        {.area = options_.avoid.area_cost * options_.avoid.near_share, .hard = hard_cost});
                    guess.cost = passage.length;
                    for (const Passage::Spoils& spoils : passage.spoils)
                        if (finished_.groups[static_cast<std::size_t>(spoils.group)] != 0)
                            guess.cost += spoils.cost;
                    if (guess.cost < best_.cost) {
                        const Rolled rolled = finished_.raked.rolled(word);
                        guess.cost += worth_of(rolled.metres, rolled.crossings);
                    }
                    if (guess.cost < best_.cost) found.push_back(std::move(guess));
                }
            }
        std::ranges::stable_sort(found, {}, &Guess::cost);
        if (found.size() > most_made) found.resize(most_made);
        return found;
    }

    /// Straight on at each pose that it is led through.
    Curve led(const std::vector<Pose>& through) const {
        Curve whole{from_.pose, {}};
        CurvatureState at = from_;
        for (const Pose& pose : through) {
            whole = joined(std::move(whole), continuous_curvature(at, {pose, 0}, options_.connect.limits));
            at = {pose, 0};
        }
        return joined(std::move(whole), continuous_curvature(at, to_, options_.connect.limits));
    }

    const CurvatureState &from_, &to_;
    const Finished& finished_;
    const Pairs& pairs_;
    const Options& options_;
    Driven best_;
};

bool same(const CurvatureState& a, const CurvatureState& b) {
    return a.pose == b.pose && a.curvature == b.curvature;
}

}  // namespace

Spoilt spoilt(const Curve& curve, const Finished& finished, const Pairs& pairs, const Options& options) {
    Spoilt found;
    found.hard = pairs.hard().metres(curve);
    if (!options.avoid.on) return found;
    for (const Touch& touch : pairs.touched(curve).groups) {
        if (finished.groups[static_cast<std::size_t>(touch.group)] == 0) continue;
        found.crossings += touch.crossings;
        found.first = std::min(found.first, touch.first_crossing);
    }
    found.rolled = finished.raked.rolled(curve);
    if (finished.any_area && !finished.areas.clear(curve)) {
        found.metres = finished.areas.blemish(curve);
        found.first = std::min(found.first, finished.areas.clear_length(curve));
    }
    return found;
}

Driven connected(const CurvatureState& from, const CurvatureState& to, connect::Connection direct,
                 const Finished& finished, const Pairs& pairs, const Options& options,
                 std::vector<Passage>& tried) {
    return Chooser(from, to, finished, pairs, options).choose(std::move(direct), tried);
}

const Driven& Made::connected(std::uint64_t which, const CurvatureState& from, const CurvatureState& to,
                              const Finished& finished, const Pairs& pairs, const Options& options,
                              const std::optional<connect::Connection>& direct) {
    const auto [at, fresh] = made_.try_emplace(which);
    One& one = at->second;
    if (fresh || !same(one.from, from) || !same(one.to, to)) {
        one = {from, to, direct ? *direct : connect::connection(from, to, options.connect), {}, 0, {}, {}};
    } else if (one.finished == finished.groups && one.raked == finished.raked.state()) {
        return one.driven;
    }
    one.finished = finished.groups;
    one.raked = finished.raked.state();
    one.tried.clear();
    one.driven = order::connected(from, to, one.direct, finished, pairs, options, one.tried);
    return one.driven;
}

}  // namespace strandline::order
