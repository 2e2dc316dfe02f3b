#include "path/order/candidates.hpp"

#include <algorithm>
#include <cstddef>

namespace strandline::order {
namespace {

// Per closed stroke and sense: 24^2 x 4 Dubins curves a pair stay near a millisecond.
constexpr std::size_t most_candidates = 24;

/// The rake path's pose at arc length s; where two curves meet in a corner the incoming or the outgoing one.
/// The seam of a closed stroke is such a meeting too.
enum class Side { incoming, outgoing };
CurvePoint rake_point(const Stroke& stroke, double s, Side side) {
    constexpr double same_place = 1e-9;
    const auto end_of = [](const Curve& curve) { return point_at(curve, length(curve)); };
    if (stroke.closed && side == Side::incoming && s <= same_place) return end_of(stroke.rake_path.back());
    for (const Curve& curve : stroke.rake_path) {
        const double l = length(curve);
        if (s < (side == Side::outgoing ? l - same_place : l + same_place)) return point_at(curve, s);
        s -= l;
    }
    return stroke.closed && side == Side::outgoing ? point_at(stroke.rake_path.front(), 0)
                                                   : end_of(stroke.rake_path.back());
}

CurvePoint turned_about(const CurvePoint& point) {
    return {point.s, {point.pose.at, point.pose.heading + pi}, -point.curvature};
}

/// The robot before the rake, which follows a circle of that curvature as far as connections may.
Pose robot_pose(const CurvePoint& rake, const Robot& robot) {
    const double most = connectable_delta(robot, rake.curvature);
    const double heading = rake.pose.heading + steady_delta(robot, rake.curvature, most);
    return {rake.pose.at + robot.rake_offset * unit(heading), heading};
}

Candidate candidate(const Group& group, const Going& going, const Robot& robot) {
    const std::vector<Stroke>& strokes = strokes_of(group, going.variant);
    const tour::Step& step = going.step;
    const Stroke &first = strokes.front(), &last = strokes.back();
    CurvePoint start, end;
    if (first.closed && strokes.size() == 1) {
        const double s = first.nodes[static_cast<std::size_t>(step.entry)].s;
        const CurvePoint in = rake_point(first, s, Side::incoming),
                         out = rake_point(first, s, Side::outgoing);
        start = step.reversed ? turned_about(in) : out;
        end = step.reversed ? turned_about(out) : in;
    } else {
        const Curve& final = last.rake_path.back();
        const CurvePoint a = point_at(first.rake_path.front(), 0), b = point_at(final, length(final));
        start = step.reversed ? turned_about(b) : a;
        end = step.reversed ? turned_about(a) : b;
    }
    const double longer =
        going.variant < 0 ? 0 : group.variants[static_cast<std::size_t>(going.variant)].longer;
    return {going, robot_pose(start, robot), robot_pose(end, robot), start.pose, end.pose, longer};
}

/// The nodes of a closed stroke to try: evenly spread ones and the tour's own.
std::vector<int> nodes_to_try(const Stroke& stroke, int chosen) {
    std::vector<int> nodes;
    const std::size_t n = stroke.nodes.size(), count = std::min(n, most_candidates);
    for (std::size_t k = 0; k < count; ++k) nodes.push_back(static_cast<int>(k * n / count));
    if (std::ranges::find(nodes, chosen) == nodes.end()) nodes.push_back(chosen);
    return nodes;
}

}  // namespace

bool is_single(const Group& group) { return group.work.strokes.size() == 1; }

bool is_tied(const Job& job, int group) {
    return std::ranges::any_of(job.ties, [&](const Tie& tie) { return tie.a == group || tie.b == group; });
}

std::vector<Candidate> candidates(const Job& job, const tour::Step& step, const Robot& robot) {
    const Group& group = job.groups[static_cast<std::size_t>(step.element)];
    const Stroke& first = group.work.strokes.front();
    const bool single = is_single(group);
    const bool fixed_place = group.entry.has_value() || is_tied(job, step.element);
    std::vector<Candidate> found{candidate(group, {step}, robot)};
    const auto consider = [&](tour::Step other) {
        if (!(other == step)) found.push_back(candidate(group, {other}, robot));
    };
    if (!fixed_place)
        for (std::size_t k = 0; k < group.variants.size(); ++k)
            found.push_back(candidate(group, {step, static_cast<int>(k)}, robot));
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

}  // namespace strandline::order
