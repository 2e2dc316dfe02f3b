#include "path/route/route.hpp"

#include <algorithm>
#include <cmath>

#include "path/route/string.hpp"

namespace strandline::route {
namespace {

/// Strings that are tried before detours, and with them.
constexpr int most_strings = 12;
/// Detours at an end lead to poses on rings of these radii (least radii), this many on each, with so many
/// headings.
constexpr double rings[] = {0.8, 1.6, 2.8};
constexpr int ring_poses = 8, headings = 8;
/// Strings also begin (and end) after a turn by a multiple of this, and straight parts of so many least
/// radii.
constexpr double turn_step = 0.6;
constexpr double straight_steps[] = {0.3, 1.5, 4};
/// A way is good when it is no longer than this many times what is surely needed.
constexpr double good_enough = 1.1;
/// A detour is not longer than this (least radii).
constexpr double longest_detour = 14;

/// Detours that leave the clearance, where no other is: so many of them.
constexpr std::size_t most_blemished = 30;

/// Another way is sought that is shorter than this share of the one at hand.
constexpr double worthwhile = 0.97;
constexpr double unlimited = std::numeric_limits<double>::infinity();

struct End {
    Anchor anchor;
    Curve curve;  ///< between it and the real end
    bool blemished = false;
};

class Finder {
  public:
    Finder(const Ground& ground, const CurvatureState& from, const CurvatureState& to, const Options& options)
        : ground_(ground), from_(from), to_(to), options_(options) {
        const CurveLimits& limits = options.limits;
        radii_ = {limits.right_radius > 0 ? limits.right_radius : limits.radius, limits.radius};
    }

    Way find() {
        Curve direct = continuous_curvature(from_, to_, options_.limits);
        if (ground_.clear(direct)) return {std::move(direct)};
        std::optional<Way> best;
        if (ground_.clear(from_.pose.at) && ground_.clear(to_.pose.at)) {
            best = over_strings(itself(from_), itself(to_));
            const double needed =
                std::max(length(direct), best ? taut_length(ground_, from_.pose.at, to_.pose.at) : 0);
            if (best && length(best->curve) <= good_enough * needed) return *best;
            auto other = over_strings(turned(true), turned(false),
                                      best ? worthwhile * length(best->curve) : unlimited);
            if (other && (!best || length(other->curve) < length(best->curve))) best = std::move(other);
            if (best) return *best;
        }
        const std::vector<End> starts = detours(true), ends = detours(false);
        // where one end only is hemmed in, the other needs no detours
        best = over_strings(hemmed_in(starts) ? starts : itself(from_), hemmed_in(ends) ? ends : itself(to_));
        if (!best) best = over_strings(starts, ends);
        if (!best) return least_bad(std::move(direct));
        best->blemish = ground_.blemish(best->curve);
        return *best;
    }

  private:
    /// The first string that can be driven.
    std::optional<Way> over_strings(const std::vector<End>& starts, const std::vector<End>& ends,
                                    double limit = unlimited) const {
        if (starts.empty() || ends.empty()) return std::nullopt;
        std::vector<Anchor> from, to;
        for (const End& end : starts) from.push_back(end.anchor);
        for (const End& end : ends) to.push_back(end.anchor);
        const Quest quest{ground_, from, to, radii_, {}, limit};
        Bans bans;
        for (int i = 0; i < most_strings; ++i) {
            const auto string = taut_string(quest, bans);
            if (!string) return std::nullopt;
            const End &start = starts[string->start], &end = ends[string->end];
            const CurvatureState a{start.anchor.pose, start.curve.pieces.empty() ? from_.curvature : 0},
                b{end.anchor.pose, end.curve.pieces.empty() ? to_.curvature : 0};
            Driven made = driven(ground_, a, b, *string, options_.limits, false);
            if (made.curve)
                return Way{joined(joined(start.curve, *made.curve), end.curve), 0, std::move(made.through)};
            bans.insert(made.stuck);
        }
        return std::nullopt;
    }

    /// Whether all detours at an end leave the clearance.
    bool hemmed_in(const std::vector<End>& detours) const {
        return std::ranges::all_of(detours, [&](const End& end) { return end.blemished; });
    }
    static std::vector<End> itself(const CurvatureState& end) { return {{{end.pose, 0}, {end.pose, {}}}}; }

    /// The end itself, and poses that a turn and a straight part of some length lead to, as far as there is
    /// room.
    std::vector<End> turned(bool start) const {
        const CurvatureState& end = start ? from_ : to_;
        std::vector<End> result = itself(end);
        // an end seen backwards is a start that looks the other way
        const Pose pose{end.pose.at, end.pose.heading + (start ? 0 : pi)};
        const double begin = start ? end.curvature : -end.curvature;
        const double sharpness = options_.limits.sharpness;
        const Clothoid unwound{std::abs(begin) / sharpness, begin, begin > 0 ? -sharpness : sharpness};
        Curve lead{pose, {}};
        if (begin != 0) lead.pieces.push_back(unwound);
        if (!ground_.clear(lead)) return result;
        for (const double side : {-1.0, 1.0}) {
            const double radius = start == (side > 0) ? radii_.left : radii_.right;
            for (int i = side > 0 ? 0 : 1; i * turn_step < 2 * pi; ++i) {
                Curve curve = lead;
                if (i > 0)
                    curve =
                        joined(lead, {end_pose(lead), turn(i * turn_step, side, radius, sharpness).pieces});
                if (!ground_.clear(curve)) {
                    if (i * turn_step > 1) break;  // a shorter turn keeps to the inside of the longer one's
                    continue;
                }
                add_straights(curve, start, result);
            }
        }
        return result;
    }
    void add_straights(const Curve& turned, bool start, std::vector<End>& result) const {
        const Pose from = end_pose(turned);
        for (const double radii : straight_steps) {
            const double s = radii * std::min(radii_.left, radii_.right);
            const Pose pose{from.at + s * unit(from.heading), from.heading};
            if (!ground_.clear(from.at, pose.at)) return;
            Curve curve = joined(turned, straight(from, s));
            const double cost = length(curve);
            if (start)
                result.push_back({{pose, cost}, std::move(curve)});
            else
                result.push_back({{{pose.at, pose.heading + pi}, cost}, reversed(curve)});
        }
    }

    /// The end itself, and poses near it that a clear curve leads to (or from); where there are none, those
    /// with the least bad curves.
    std::vector<End> detours(bool start) const {
        const CurvatureState& end = start ? from_ : to_;
        const double radius = std::min(radii_.left, radii_.right);
        std::vector<End> clear, others;
        for (const double ring : rings)
            for (int i = 0; i < ring_poses; ++i) {
                const Point at =
                    end.pose.at + ring * radius * unit(end.pose.heading + 2 * pi * i / ring_poses);
                if (!ground_.clear(at)) continue;
                for (int k = 0; k < headings; ++k) {
                    const CurvatureState there{{at, end.pose.heading + 2 * pi * k / headings}, 0};
                    Curve curve = start ? continuous_curvature(end, there, options_.limits)
                                        : continuous_curvature(there, end, options_.limits);
                    const double cost = length(curve);
                    if (cost > longest_detour * radius) continue;
                    const bool free = ground_.clear(curve);
                    if (free || clear.empty())
                        (free ? clear : others).push_back({{there.pose, cost}, std::move(curve)});
                }
            }
        if (clear.empty()) {
            for (End& other : others) {
                other.anchor.cost += options_.blemish_weight * ground_.blemish(other.curve);
                other.blemished = true;
            }
            std::ranges::sort(others, {}, [](const End& e) { return e.anchor.cost; });
            others.resize(std::min(others.size(), most_blemished));
            clear = std::move(others);
        }
        return clear;
    }

    Way least_bad(Curve direct) const {
        const double blemish = ground_.blemish(direct);
        Way best{std::move(direct), blemish};
        const auto cost = [&](const Way& way) {
            return length(way.curve) + options_.blemish_weight * way.blemish;
        };
        const std::vector<Anchor> starts{{from_.pose, 0}}, ends{{to_.pose, 0}};
        const auto string = taut_string({ground_, starts, ends, radii_, options_.blemish_weight}, {});
        if (!string) return best;
        Driven made = driven(ground_, from_, to_, *string, options_.limits, true);
        if (!made.curve) return best;
        Way along{std::move(*made.curve), 0, std::move(made.through)};
        along.blemish = ground_.blemish(along.curve);
        return cost(along) < cost(best) ? along : best;
    }

    const Ground& ground_;
    const CurvatureState &from_, &to_;
    const Options& options_;
    TurningRadii radii_{};
};

}  // namespace

Way way(const Ground& ground, const CurvatureState& from, const CurvatureState& to, const Options& options) {
    return Finder(ground, from, to, options).find();
}

}  // namespace strandline::route
