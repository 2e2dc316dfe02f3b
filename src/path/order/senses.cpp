#include "path/order/senses.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace strandline::order {
namespace {

// Per closed stroke and sense: 24^2 x 4 Dubins curves a pair stay near a millisecond.
constexpr std::size_t most_candidates = 24;

/// One way to go through a group: where the robot stands before and after.
struct Candidate {
    Going going;
    Pose start, end;
    double longer = 0;  ///< metres, within the group
};

/// The rake path's pose at arc length s; where two curves meet in a corner the incoming or the outgoing one.
/// The seam of a closed stroke is such a meeting too.
enum class Side { incoming, outgoing };
Pose rake_pose(const Stroke& stroke, double s, Side side) {
    constexpr double same_place = 1e-9;
    if (stroke.closed && side == Side::incoming && s <= same_place) return end_pose(stroke.rake_path.back());
    for (const Curve& curve : stroke.rake_path) {
        const double l = length(curve);
        if (s < (side == Side::outgoing ? l - same_place : l + same_place)) return point_at(curve, s).pose;
        s -= l;
    }
    return stroke.closed && side == Side::outgoing ? stroke.rake_path.front().start
                                                   : end_pose(stroke.rake_path.back());
}

Pose turned_about(Pose pose) { return {pose.at, pose.heading + pi}; }

/// The robot straight in front of the rake.
Pose robot_pose(Pose rake, double offset) { return {rake.at + offset * unit(rake.heading), rake.heading}; }

Candidate candidate(const Group& group, const Going& going, double offset) {
    const std::vector<Stroke>& strokes = strokes_of(group, going.variant);
    const tour::Step& step = going.step;
    const Stroke &first = strokes.front(), &last = strokes.back();
    Pose start, end;
    if (first.closed && strokes.size() == 1) {
        const double s = first.nodes[static_cast<std::size_t>(step.entry)].s;
        const Pose in = rake_pose(first, s, Side::incoming), out = rake_pose(first, s, Side::outgoing);
        start = step.reversed ? turned_about(in) : out;
        end = step.reversed ? turned_about(out) : in;
    } else {
        const Pose a = first.rake_path.front().start, b = end_pose(last.rake_path.back());
        start = step.reversed ? turned_about(b) : a;
        end = step.reversed ? turned_about(a) : b;
    }
    const double longer =
        going.variant < 0 ? 0 : group.variants[static_cast<std::size_t>(going.variant)].longer;
    return {going, robot_pose(start, offset), robot_pose(end, offset), longer};
}

bool is_tied(const Job& job, int group) {
    return std::ranges::any_of(job.ties, [&](const Tie& tie) { return tie.a == group || tie.b == group; });
}

/// The nodes of a closed stroke to try: evenly spread ones and the tour's own.
std::vector<int> nodes_to_try(const Stroke& stroke, int chosen) {
    std::vector<int> nodes;
    const std::size_t n = stroke.nodes.size(), count = std::min(n, most_candidates);
    for (std::size_t k = 0; k < count; ++k) nodes.push_back(static_cast<int>(k * n / count));
    if (std::ranges::find(nodes, chosen) == nodes.end()) nodes.push_back(chosen);
    return nodes;
}

std::vector<Candidate> candidates(const Job& job, const tour::Step& step, double offset) {
    const Group& group = job.groups[static_cast<std::size_t>(step.element)];
    const Stroke& first = group.work.strokes.front();
    const bool single = group.work.strokes.size() == 1;
    const bool fixed_place = group.entry.has_value() || is_tied(job, step.element);
    std::vector<Candidate> found{candidate(group, {step}, offset)};
    const auto consider = [&](tour::Step other) {
        if (!(other == step)) found.push_back(candidate(group, {other}, offset));
    };
    if (!fixed_place)
        for (std::size_t k = 0; k < group.variants.size(); ++k)
            found.push_back(candidate(group, {step, static_cast<int>(k)}, offset));
    if (single && first.closed) {
        const bool fixed_sense = group.sense != tour::Sense::any || first.one_way;
        for (int node : fixed_place ? std::vector<int>{step.entry} : nodes_to_try(first, step.entry))
            for (bool reversed : {false, true})
                if (!fixed_sense || reversed == step.reversed) consider({step.element, node, reversed});
    } else if (single && !first.one_way && !fixed_place && group.direction == tour::Direction::any) {
        const int last = static_cast<int>(first.nodes.size()) - 1;
        consider({step.element, step.reversed ? 0 : last, !step.reversed});
    }
    return found;
}

}  // namespace

std::vector<Going> with_driven_senses(const Job& job, const std::vector<tour::Step>& steps,
                                      const Robot& robot) {
    if (steps.empty()) return {};
    const auto cost = [&](Pose from, Pose to) {
        return robot.min_radius > 0 ? dubins_length(from, to, robot.min_radius) : distance(from.at, to.at);
    };
    std::vector<std::vector<Candidate>> ways;
    for (const tour::Step& step : steps) ways.push_back(candidates(job, step, robot.rake_offset));
    std::vector<std::vector<std::size_t>> came_from(ways.size());
    std::vector<double> best;
    for (const Candidate& way : ways[0])
        best.push_back(way.longer + (job.start ? distance(*job.start, way.start.at) : 0));
    for (std::size_t k = 1; k < ways.size(); ++k) {
        std::vector<double> next(ways[k].size(), std::numeric_limits<double>::infinity());
        came_from[k].assign(ways[k].size(), 0);
        for (std::size_t j = 0; j < ways[k].size(); ++j)
            for (std::size_t i = 0; i < ways[k - 1].size(); ++i) {
                // A straight gap bounds the Dubins length from below: most pairs need not be solved.
                const double so_far = best[i] + ways[k][j].longer;
                if (so_far + distance(ways[k - 1][i].end.at, ways[k][j].start.at) >= next[j]) continue;
                const double sum = so_far + cost(ways[k - 1][i].end, ways[k][j].start);
                if (sum < next[j]) {
                    next[j] = sum;
                    came_from[k][j] = i;
                }
            }
        best = std::move(next);
    }
    std::size_t at = static_cast<std::size_t>(std::ranges::min_element(best) - best.begin());
    std::vector<Going> chosen(steps.size());
    for (std::size_t k = ways.size(); k-- > 0;) {
        chosen[k] = ways[k][at].going;
        if (k > 0) at = came_from[k][at];
    }
    return chosen;
}

}  // namespace strandline::order
