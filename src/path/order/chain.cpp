#include "path/order/chain.hpp"

#include <cstddef>
#include <utility>

namespace strandline::order {
namespace {

/// A stretch of the chain's rake path and the stroke it belongs to; -1: a gap, driven rake up.
struct Stretch {
    double until;  ///< rake arc length where it ends
    int stroke;
};

/// A corner at the start of a gap belongs to the stroke that it leads to.
int stroke_at(const std::vector<Stretch>& stretches, std::size_t at) {
    while (at + 1 < stretches.size() && stretches[at].stroke < 0) ++at;
    return stretches[at].stroke;
}

/// Deals a drawn leg out to the stretches it passes. `travelled`: rake arc length at the leg's start, moved
/// on.
void deal_out(const Leg& leg, const std::vector<Stretch>& stretches, std::size_t& at, double& travelled,
              const Robot& robot, std::vector<Leg>& legs) {
    // Rounding of the summed chords: a state this near a stretch's end is its end.
    constexpr double same_place = 1e-4;
    Leg part{Motion::draw, -1, {}, {}};
    const auto close = [&] {
        part.stroke = stretches[at].stroke;
        part.motion = part.stroke < 0 ? Motion::lead : Motion::draw;
        if (part.path.size() > 1) legs.push_back(part);
        part.path.clear();
    };
    for (std::size_t i = 0; i < leg.path.size(); ++i) {
        if (i > 0) {
            const Point a = rake_at(robot, leg.path[i - 1].pose), b = rake_at(robot, leg.path[i].pose);
            const double step = distance(a, b);
            while (at + 1 < stretches.size() && travelled + step > stretches[at].until + same_place) {
                const double share = (stretches[at].until - travelled) / step;
                if (share > 0) {
                    const double s = leg.path[i - 1].s + share * (leg.path[i].s - leg.path[i - 1].s);
                    part.path.push_back(state_at(leg.path, s));
                }
                const RobotState joint = part.path.back();
                close();
                ++at;
                part.path.push_back(joint);
            }
            travelled += step;
        }
        part.path.push_back(leg.path[i]);
    }
    close();
    if (at + 1 < stretches.size() && travelled > stretches[at].until - same_place) ++at;
}

}  // namespace

drive::Drive drive_chain(const std::vector<Planned>& chain, const std::vector<Stroke>& strokes,
                         const Robot& robot, const drive::Options& options) {
    Stroke whole = strokes[static_cast<std::size_t>(chain.front().stroke)];
    whole.rake_path.clear();
    whole.closed = false;
    std::vector<Stretch> stretches;
    double travelled = 0;
    for (const Planned& link : chain) {
        if (!whole.rake_path.empty()) {
            const Point from = end_pose(whole.rake_path.back()).at, to = link.rake_path.front().start.at;
            constexpr double touching = 1e-9;
            if (distance(from, to) > touching) {
                whole.rake_path.push_back(straight({from, heading(to - from)}, distance(from, to)));
                travelled += distance(from, to);
                stretches.push_back({travelled, -1});
            }
        }
        whole.rake_path.insert(whole.rake_path.end(), link.rake_path.begin(), link.rake_path.end());
        travelled += length(link.rake_path);
        stretches.push_back({travelled, link.stroke});
    }
    whole.nodes = {{0, whole.rake_path.front().start.at, -1},
                   {travelled, end_pose(whole.rake_path.back()).at, -1}};
    drive::Drive driven = drive::drive(whole, chain.front().stroke, 0, false, robot, options);
    if (chain.size() == 1) return driven;
    std::vector<Leg> legs;
    std::size_t at = 0;
    double arc = 0;
    for (const Leg& leg : driven.legs) {
        if (leg.motion == Motion::draw) {
            deal_out(leg, stretches, at, arc, robot, legs);
        } else {
            legs.push_back(leg);
            if (leg.motion != Motion::lead) legs.back().stroke = stroke_at(stretches, at);
        }
    }
    driven.legs = std::move(legs);
    return driven;
}

}  // namespace strandline::order
