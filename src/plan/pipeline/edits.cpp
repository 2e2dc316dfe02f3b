#include "plan/pipeline/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace strandline::pipeline {
namespace {

template <class... F>
struct Visit : F... {
    using F::operator()...;
};

/// A node name found again: which group, and which of the stroke's nodes.
struct Found {
    int group, node;
};

std::optional<int> group_named(const order::Job& job, const std::string& element) {
    for (std::size_t i = 0; i < job.groups.size(); ++i)
        if (job.groups[i].name == element) return static_cast<int>(i);
    return std::nullopt;
}

std::optional<Found> find(const order::Job& job, const NodeName& name) {
    const auto group = group_named(job, name.element);
    if (!group) return std::nullopt;
    const std::vector<Stroke>& strokes = job.groups[static_cast<std::size_t>(*group)].work.strokes;
    const Stroke& stroke = name.node == 0 ? strokes.front() : strokes.back();
    const int last = static_cast<int>(stroke.nodes.size()) - 1;
    if (name.node == -1) {
        const auto drawn = std::ranges::max_element(stroke.nodes, {}, &Node::drawn);
        return Found{*group, drawn->drawn < 0 ? last : static_cast<int>(drawn - stroke.nodes.begin())};
    }
    for (int i = 0; i <= last; ++i)
        if (stroke.nodes[static_cast<std::size_t>(i)].drawn == name.node) return Found{*group, i};
    // Fills have no drawn nodes: only their start and end can be named.
    return name.node == 0 ? std::optional(Found{*group, 0}) : std::nullopt;
}

std::string text(const NodeName& name) { return fmt::format("node {} of \"{}\"", name.node, name.element); }

}  // namespace

std::vector<std::string> apply_edits(order::Job& job, const std::vector<Edit>& edits) {
    std::vector<std::string> idle;
    const Visit apply{
        [&](const LinkEdit& edit) {
            const auto a = find(job, edit.a), b = find(job, edit.b);
            if (a && b)
                job.ties.push_back({a->group, a->node, b->group, b->node});
            else
                idle.push_back(fmt::format("link: {} is not in the drawing", text(a ? edit.b : edit.a)));
        },
        [&](const EntryEdit& edit) {
            if (const auto at = find(job, edit.at))
                job.groups[static_cast<std::size_t>(at->group)].entry = at->node;
            else
                idle.push_back(fmt::format("entry: {} is not in the drawing", text(edit.at)));
        },
        [&](const DirectionEdit& edit) {
            const auto at = group_named(job, edit.element);
            if (!at) {
                idle.push_back(fmt::format("direction: \"{}\" is not in the drawing", edit.element));
                return;
            }
            order::Group& group = job.groups[static_cast<std::size_t>(*at)];
            if (group.work.strokes.front().fill) {
                idle.push_back(fmt::format(
                    "direction: \"{}\" is an area; its fill has a direction of its own", edit.element));
                return;
            }
            const bool closed = group.work.strokes.front().closed;
            if (closed && (edit.direction == "ccw" || edit.direction == "cw"))
                group.sense = edit.direction == "ccw" ? tour::Sense::ccw : tour::Sense::cw;
            else if (!closed && (edit.direction == "forward" || edit.direction == "backward"))
                group.direction =
                    edit.direction == "forward" ? tour::Direction::forward : tour::Direction::backward;
            else
                idle.push_back(fmt::format("direction: \"{}\" is {} line and cannot be driven {}",
                                           edit.element, closed ? "a closed" : "an open", edit.direction));
        }};
    for (const Edit& edit : edits) std::visit(apply, edit);
    return idle;
}

std::vector<std::pair<int, int>> inner_before_outer(const std::vector<order::Group>& groups,
                                                    const Drawing& drawing) {
    std::vector<int> group_of(drawing.elements.size(), -1);
    for (std::size_t i = 0; i < groups.size(); ++i)
        group_of[static_cast<std::size_t>(groups[i].work.element)] = static_cast<int>(i);
    std::vector<std::pair<int, int>> before;
    for (const order::Group& group : groups) {
        // The next enclosing element that has strokes: one that was left out still hands the order on.
        int outer = drawing.elements[static_cast<std::size_t>(group.work.element)].inside;
        while (outer >= 0 && group_of[static_cast<std::size_t>(outer)] < 0)
            outer = drawing.elements[static_cast<std::size_t>(outer)].inside;
        if (outer >= 0)
            before.emplace_back(group_of[static_cast<std::size_t>(group.work.element)],
                                group_of[static_cast<std::size_t>(outer)]);
    }
    return before;
}

void keep_within_batches(order::Job& job) {
    if (job.batches.empty()) return;
    std::vector<std::size_t> batch_of(job.groups.size(), 0);
    for (std::size_t b = 0; b < job.batches.size(); ++b)
        for (const int group : job.batches[b]) batch_of[static_cast<std::size_t>(group)] = b;
    std::erase_if(job.before, [&](const std::pair<int, int>& pair) {
        return batch_of[static_cast<std::size_t>(pair.first)] !=
               batch_of[static_cast<std::size_t>(pair.second)];
    });
}

}  // namespace strandline::pipeline
