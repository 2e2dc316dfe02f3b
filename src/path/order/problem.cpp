#include "path/order/problem.hpp"

#include <algorithm>
#include <cstddef>

#include "path/order/candidates.hpp"

namespace strandline::order {
namespace {

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

}  // namespace

tour::Problem problem_of(const Job& job) {
    tour::Problem problem;
    problem.start = job.parked ? std::optional(job.parked->at) : job.start;
    // of several exits elsewhere the tour knows none
    const bool one_exit = !job.exits.empty() && std::ranges::all_of(job.exits, [&](const Pose& exit) {
        return exit.at == job.exits.front().at;
    });
    if (one_exit || (job.exits.empty() && job.end)) {
        problem.end = tour::End::at_point;
        problem.end_point = one_exit ? job.exits.front().at : *job.end;
    }
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

}  // namespace strandline::order
