#include "path/order/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "path/order/worth.hpp"

namespace strandline::order {
namespace {

// Per closed stroke and sense: 24^2 x 4 Dubins curves a pair stay near a millisecond.
constexpr std::size_t most_candidates = 24;
/// Radians: a smaller turn is never looped round, whatever the settings.
constexpr double may_loop = 0.5;
/// Metres between robot states where only lengths are asked for.
constexpr double coarse_step = 0.05;

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
Pose robot_pose(const CurvePoint& rake, const Stroke& stroke, const Robot& machine) {
    const Robot robot = steered(stroke, machine);
    const double most = connectable_delta(robot, rake.curvature);
    const double heading = rake.pose.heading + steady_delta(robot, rake.curvature, most);
    return robot_at(robot, rake.pose.at, heading);
}

}  // namespace

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
    const Stroke &begun = step.reversed ? last : first, &ended = step.reversed ? first : last;
    return {going, robot_pose(start, begun, robot), robot_pose(end, ended, robot), start.pose, end.pose,
            longer};
}

namespace {

/// Rake up between the parts of one stroke.
double looped(const drive::Drive& drive, const Options& options) {
    double sum = 0;
    for (const Leg& leg : drive.legs)
        if (leg.motion == Motion::loop) sum += worth(leg.curve, options);
    return sum;
}

/// How a closed stroke may be entered: at which nodes, and the metres rake up within it.
struct Ways {
    std::vector<int> nodes;
    std::vector<double> looped;
};

/// The tour's own node, corners that cost a loop where the stroke is not entered there, then evenly spread
/// nodes.
Ways ways_into(const Stroke& stroke, int chosen, const Robot& robot, const Options& options) {
    drive::Options driving = options.drive;
    driving.step = std::max(driving.step, coarse_step);
    const auto looped_from = [&](int node) {
        return looped(drive::drive(stroke, 0, node, false, robot, driving), options);
    };
    const std::size_t n = stroke.nodes.size(), count = std::min(n, most_candidates);
    Ways ways{{chosen}, {looped_from(chosen)}};
    const auto take = [&](int node, double metres) {
        if (std::ranges::find(ways.nodes, node) != ways.nodes.end()) return;
        ways.nodes.push_back(node);
        ways.looped.push_back(metres);
    };
    // Between corners it makes no difference where a stroke is entered.
    double plain = ways.looped.front();
    std::vector<int> corners;
    for (int k = 0; k < static_cast<int>(n); ++k) {
        const double s = stroke.nodes[static_cast<std::size_t>(k)].s;
        const double turn = wrap_angle(rake_point(stroke, s, Side::outgoing).pose.heading -
                                       rake_point(stroke, s, Side::incoming).pose.heading);
        if (std::abs(turn) > may_loop) corners.push_back(k);
    }
    if (plain > 0 || (corners.size() == 1 && corners.front() == chosen)) {
        if (corners.size() > most_candidates) corners.resize(most_candidates);
        for (const int corner : corners) take(corner, corner == chosen ? plain : looped_from(corner));
        // The corner that is entered is the one that saves: elsewhere all are looped round.
        for (int k = 0; k < static_cast<int>(n); ++k)
            if (std::ranges::find(corners, k) == corners.end()) {
                plain = k == chosen ? plain : looped_from(k);
                break;
            }
    }
    for (std::size_t k = 0; k < count && ways.nodes.size() < most_candidates; ++k)
        take(static_cast<int>(k * n / count), plain);
    return ways;
}

std::vector<Candidate> candidates(const Job& job, const tour::Step& step, const Robot& robot,
                                  const Options& options) {
    const Group& group = job.groups[static_cast<std::size_t>(step.element)];
    const Stroke& first = group.work.strokes.front();
    const bool single = is_single(group);
    const bool fixed_place = group.entry.has_value() || is_tied(job, step.element);
    std::vector<Candidate> found{candidate(group, {step}, robot)};
    const auto consider = [&](tour::Step other, double longer = 0) {
        if (!(other == step)) found.push_back(candidate(group, {other}, robot));
        (other == step ? found.front() : found.back()).longer += longer;
    };
    if (!fixed_place)
        for (std::size_t k = 0; k < group.variants.size(); ++k)
            found.push_back(candidate(group, {step, static_cast<int>(k)}, robot));
    if (single && first.closed) {
        const bool fixed_sense = group.sense != tour::Sense::any || first.one_way;
        const Ways ways =
            fixed_place ? Ways{{step.entry}, {0}} : ways_into(first, step.entry, robot, options);
        for (std::size_t k = 0; k < ways.nodes.size(); ++k)
            for (bool reversed : {false, true})
                if (!fixed_sense || reversed == step.reversed)
                    consider({step.element, ways.nodes[k], reversed}, ways.looped[k]);
    } else if (single && !first.one_way && !fixed_place && group.direction == tour::Direction::any) {
        const int last = static_cast<int>(first.nodes.size()) - 1;
        consider({step.element, step.reversed ? 0 : last, !step.reversed});
    }
    return found;
}

}  // namespace

bool is_single(const Group& group) { return group.work.strokes.size() == 1; }

bool is_tied(const Job& job, int group) {
    return std::ranges::any_of(job.ties, [&](const Tie& tie) { return tie.a == group || tie.b == group; });
}

Choices choices_of(const Job& job, const std::vector<tour::Step>& steps, const Robot& robot,
                   const Options& options) {
    Choices choices(job.groups.size());
    for (const tour::Step& step : steps)
        choices[static_cast<std::size_t>(step.element)] = candidates(job, step, robot, options);
    return choices;
}

}  // namespace strandline::order
