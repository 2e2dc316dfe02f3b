#include "plan/pipeline/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>

#include "math/region/region.hpp"
#include "plan/pipeline/hints.hpp"

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

std::optional<std::size_t> element_named(const Drawing& drawing, const std::string& id) {
    const auto found = std::ranges::find(drawing.elements, id, &Element::id);
    if (found == drawing.elements.end()) return std::nullopt;
    return static_cast<std::size_t>(found - drawing.elements.begin());
}

void draw(Drawing& drawing, const DrawEdit& edit) {
    for (std::size_t i = 0; i < edit.paths.size(); ++i) {
        const Path& path = edit.paths[i];
        Element element;
        element.id = i == 0 ? edit.element : fmt::format("{}/{}", edit.element, i + 1);
        element.what = LineElement{edit.smooth > 0 ? drawn_by_hand(path, edit.smooth) : path, edit.pins};
        drawing.elements.push_back(std::move(element));
    }
}

/// What it encloses is then enclosed by what encloses it.
void erase(Drawing& drawing, std::size_t index) {
    const int gone = static_cast<int>(index), outer = drawing.elements[index].inside;
    for (Element& element : drawing.elements)
        if (element.inside == gone) element.inside = outer;
    for (Element& element : drawing.elements)
        if (element.inside > gone) --element.inside;
    drawing.elements.erase(drawing.elements.begin() + gone);
}

/// The element becomes a keep-out, or the border: of a line, what it bounds, or the groove that it would
/// leave.
void fence(Drawing& drawing, std::size_t index, bool border, const Robot& robot) {
    constexpr double tolerance = 0.002;  // metres, of curves
    const Element& element = drawing.elements[index];
    Regions area;
    if (const auto* line = std::get_if<LineElement>(&element.what)) {
        const Polyline points = flattened(line->path, tolerance);
        area = line->path.closed || border ? resolved({points}, FillRule::nonzero)
                                           : swept({points}, false, groove_width(robot, line->pins) / 2);
    } else {
        area = {std::get<RegionElement>(element.what).region};
    }
    if (!border)
        drawing.keep_out.insert(drawing.keep_out.end(), area.begin(), area.end());
    else if (!area.empty())
        drawing.border = area.front();
    erase(drawing, index);
}

void ask(Drawing& drawing, std::size_t index, const HintEdit& edit) {
    Element& element = drawing.elements[index];
    std::erase_if(element.hints, [&](const svg::Hint& hint) { return hint.name == edit.name; });
    const auto place = std::ranges::lower_bound(element.hints, edit.name, {}, &svg::Hint::name);
    element.hints.insert(place, {edit.name, edit.value});
    if (auto* line = std::get_if<LineElement>(&element.what); line && edit.name == "pins")
        line->pins = std::atoi(edit.value.c_str());
}

/// Elements in the order wished for; what encloses what no longer decides between them.
void keep_order(order::Job& job, const std::vector<int>& wished) {
    std::vector<std::size_t> place(job.groups.size(), wished.size());
    for (std::size_t i = 0; i < wished.size(); ++i) place[static_cast<std::size_t>(wished[i])] = i;
    const auto rank = [&](int group) { return place[static_cast<std::size_t>(group)]; };
    std::erase_if(job.before, [&](const std::pair<int, int>& pair) {
        return rank(pair.first) < wished.size() && rank(pair.second) < wished.size();
    });
    for (std::size_t i = 1; i < wished.size(); ++i) job.before.emplace_back(wished[i - 1], wished[i]);
}

std::string text(const NodeName& name) { return fmt::format("node {} of \"{}\"", name.node, name.element); }

}  // namespace

std::vector<std::string> apply_to_drawing(Drawing& drawing, const std::vector<Edit>& edits,
                                          const Robot& robot) {
    std::vector<std::string> idle;
    for (const Edit& edit : edits)
        if (const auto* drawn = std::get_if<DrawEdit>(&edit)) draw(drawing, *drawn);
    for (const Edit& edit : edits) {
        const auto* hint = std::get_if<HintEdit>(&edit);
        if (!hint) continue;
        const auto index = element_named(drawing, hint->element);
        if (!index)
            idle.push_back(fmt::format("{}: \"{}\" is not in the drawing", hint->name, hint->element));
        else if (const auto fine = valid_for({hint->name, hint->value}, robot); !fine)
            idle.push_back(sentence(fine.error()));
        else if (hint->name == "pause")
            idle.push_back(fmt::format("pause: \"{}\": stops belong to layers", hint->element));
        else
            ask(drawing, *index, *hint);
    }
    for (std::size_t i = drawing.elements.size(); i-- > 0;)
        if (const std::string* field = value_of(drawing.elements[i].hints, "field"))
            fence(drawing, i, *field == "border", robot);
    for (std::size_t i = drawing.elements.size(); i-- > 0;)
        if (const std::string* ink = value_of(drawing.elements[i].hints, "ink"); ink && *ink == "off")
            erase(drawing, i);
    return idle;
}

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
        },
        [&](const OrderEdit& edit) {
            std::vector<int> wished;
            for (const std::string& element : edit.elements)
                if (const auto group = group_named(job, element)) {
                    if (std::ranges::find(wished, *group) == wished.end()) wished.push_back(*group);
                } else
                    idle.push_back(fmt::format("order: \"{}\" is not in the drawing", element));
            keep_order(job, wished);
        },
        [&](const ThroughEdit& edit) {
            const auto a = group_named(job, edit.from), b = group_named(job, edit.to);
            if (a && b)
                job.shapes.push_back({*a, *b, edit.poses, edit.hop});
            else
                idle.push_back(fmt::format("through: \"{}\" is not in the drawing", a ? edit.to : edit.from));
        },
        [](const HintEdit&) {},
        [](const DrawEdit&) {}};  // in the drawing already
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
