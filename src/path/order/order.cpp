#include "path/order/order.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "path/order/chain.hpp"
#include "path/order/senses.hpp"

namespace strandline::order {
namespace {

bool is_single(const Group& group) { return group.work.strokes.size() == 1; }

/// What the tour sees of a group: a closed stroke's nodes, else the two ends.
tour::Element element_of(const Group& group) {
    tour::Element element;
    element.name = group.name;
    const Stroke& first = group.work.strokes.front();
    if (is_single(group) && first.closed) {
        element.closed = true;
        for (const Node& node : first.nodes) element.points.push_back(node.at);
        element.sense = group.sense;
    } else {
        element.points = {first.rake_path.front().start.at,
                          end_pose(group.work.strokes.back().rake_path.back()).at};
        element.direction = first.one_way || !is_single(group) ? tour::Direction::forward : group.direction;
    }
    element.entry = group.entry;
    return element;
}

/// Node numbers of open strokes become the tour's two ends.
int tour_vertex(const Group& group, int node) {
    if (is_single(group) && group.work.strokes.front().closed) return node;
    return node == 0 ? 0 : 1;
}

tour::Problem problem_of(const Job& job) {
    tour::Problem problem;
    problem.start = job.start;
    problem.before = job.before;
    problem.groups = job.batches;
    problem.keep_group_order = true;
    for (const Group& group : job.groups) problem.elements.push_back(element_of(group));
    for (std::size_t i = 0; i < job.groups.size(); ++i)
        if (problem.elements[i].entry)
            problem.elements[i].entry = tour_vertex(job.groups[i], *problem.elements[i].entry);
    for (const Tie& tie : job.ties)
        problem.links.push_back({tie.a, tour_vertex(job.groups[static_cast<std::size_t>(tie.a)], tie.node_a),
                                 tie.b,
                                 tour_vertex(job.groups[static_cast<std::size_t>(tie.b)], tie.node_b)});
    return problem;
}

/// Whether the drive may go straight on from the end of one rake path to the start of the next.
bool nearly_touch(const std::vector<Curve>& a, const std::vector<Curve>& b, const Robot& robot,
                  const Options& options) {
    // Rounding moves the ends that meet, and the legs could not be dealt back to their strokes.
    if (options.drive.below == drive::Below::round || options.drive.above == drive::Above::round)
        return false;
    // A robot that turns on the spot for free gains nothing.
    if (robot.min_radius <= 0 || options.connect.style == connect::Style::straight) return false;
    const Pose from = end_pose(a.back()), to = b.front().start;
    const double gap = distance(from.at, to.at);
    if (gap > options.min_gap) return false;
    constexpr double touching = 1e-9;
    if (gap <= touching)
        return std::abs(wrap_angle(to.heading - from.heading)) < options.drive.corner_threshold;
    const double across = heading(to.at - from.at);
    return std::abs(wrap_angle(across - from.heading)) < options.drive.corner_threshold &&
           std::abs(wrap_angle(to.heading - across)) < options.drive.corner_threshold;
}

void append_pivot(std::vector<Leg>& legs, Pose at, double turn) {
    if (turn == 0) return;
    legs.push_back({Motion::pivot, -1, {{0, at, 0}, {0, {at.at, at.heading + turn}, 0}}, {}});
}

}  // namespace

const std::vector<Stroke>& strokes_of(const Group& group, int variant) {
    return variant < 0 ? group.work.strokes : group.variants[static_cast<std::size_t>(variant)].strokes;
}

Outcome<Ordered> ordered(const Job& job, const Robot& robot, const Options& options,
                         const Progress& progress) {
    Ordered answer;
    const auto tour = tour::solve(problem_of(job), options.tour, progress);
    if (!tour) return tl::unexpected(tour.error());
    answer.tour = *tour;

    // Groups -> strokes in driving order, each with its rake path as driven.
    std::vector<Planned> planned;
    answer.variants.assign(job.groups.size(), -1);
    for (const auto& [step, variant] : with_driven_senses(job, tour->steps, robot)) {
        const Group& group = job.groups[static_cast<std::size_t>(step.element)];
        answer.variants[static_cast<std::size_t>(step.element)] = variant;
        for (const Stroke& stroke : strokes_of(group, variant)) {
            const bool closed = is_single(group) && stroke.closed;
            const int index = static_cast<int>(answer.strokes.size());
            const int last = static_cast<int>(stroke.nodes.size()) - 1;
            const int node = closed ? step.entry : step.reversed ? last : 0;
            answer.strokes.push_back(stroke);
            answer.entries.push_back({index, node, step.reversed});
            planned.push_back({index, rake_path_from(stroke, node, step.reversed)});
        }
    }

    std::vector<std::vector<Planned>> chains;
    for (Planned& next : planned) {
        if (!chains.empty()) {
            const std::vector<Curve>& done = chains.back().back().rake_path;
            answer.straight += distance(end_pose(done.back()).at, next.rake_path.front().start.at);
            const auto is_fill = [&](const Planned& p) {
                return answer.strokes[static_cast<std::size_t>(p.stroke)].fill;
            };
            if (!is_fill(chains.back().back()) && !is_fill(next) &&
                nearly_touch(done, next.rake_path, robot, options)) {
                ++answer.direct;
                chains.back().push_back(std::move(next));
                continue;
            }
        }
        chains.push_back({});
        chains.back().push_back(std::move(next));
    }

    std::optional<CurvatureState> from;
    int last_stroke = -1;
    for (std::size_t k = 0; k < chains.size(); ++k) {
        progress.report("driving", static_cast<double>(k) / static_cast<double>(chains.size()));
        drive::Drive driven = drive_chain(chains[k], answer.strokes, robot, options.drive);
        if (from) {
            const connect::Connection joint = connect::connection(*from, driven.start, options.connect);
            if (!joint.broken.empty()) {
                ++answer.fallbacks;
                answer.warnings.push_back(
                    {"connection after stroke " + std::to_string(last_stroke),
                     "its style breaks a limit there (" + joint.broken + "): a bounded curve is driven"});
            }
            const bool turns = options.connect.style == connect::Style::straight || robot.min_radius <= 0;
            answer.dubins += !turns ? dubins_length(from->pose, driven.start.pose, robot.min_radius)
                                    : distance(from->pose.at, driven.start.pose.at);
            append_pivot(answer.legs, from->pose, joint.turn_before);
            if (!joint.curve.pieces.empty())
                answer.legs.push_back(
                    {Motion::connect, -1, states_along(joint.curve, options.drive.step), joint.curve});
            append_pivot(answer.legs, end_pose(joint.curve), joint.turn_after);
            answer.connections.push_back(
                {last_stroke, chains[k].front().stroke, joint.turn_before, joint.turn_after, joint.curve});
        }
        for (Leg& leg : driven.legs) answer.legs.push_back(std::move(leg));
        for (const drive::Span& span : driven.undrivable) answer.undrivable.push_back(span);
        answer.exact += driven.exact;
        answer.rounded += driven.rounded;
        answer.loops += driven.loops;
        answer.pivots += driven.pivots;
        from = driven.end;
        last_stroke = chains[k].back().stroke;
    }
    progress.report("driving", 1);
    return answer;
}

}  // namespace strandline::order
