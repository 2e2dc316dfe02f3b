#include "result/formats/plan_check.hpp"

#include <fmt/format.h>

namespace strandline::formats {
namespace {

/// `index` in 0 .. count - 1, or -1 where that stands for none.
std::optional<Flaw> out_of_range(int index, std::size_t count, bool or_none, const std::string& pointer,
                                 const char* what) {
    if ((or_none && index == -1) || (index >= 0 && static_cast<std::size_t>(index) < count))
        return std::nullopt;
    return Flaw{pointer, fmt::format("there is no {} {}: there are {}", what, index, count)};
}

std::optional<Flaw> flaw_of_robot(const Robot& robot) {
    // The profile's own reader knows the range of every field.
    const auto again = read_robot(write_robot(robot), "/robot");
    if (again) return std::nullopt;
    return Flaw{"/robot", sentence(again.error())};
}

}  // namespace

std::optional<Flaw> first_flaw(const Plan& plan) {
    if (auto flaw = flaw_of_robot(plan.robot)) return flaw;
    const auto& elements = plan.drawing.elements;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const std::string pointer = fmt::format("/drawing/elements/{}/inside", i);
        if (auto flaw = out_of_range(elements[i].inside, elements.size(), true, pointer, "element"))
            return flaw;
        if (elements[i].inside == static_cast<int>(i)) return Flaw{pointer, "an element inside itself"};
    }
    for (std::size_t i = 0; i < plan.strokes.size(); ++i)
        if (auto flaw = out_of_range(plan.strokes[i].element, elements.size(), true,
                                     fmt::format("/strokes/{}/element", i), "element"))
            return flaw;
    if (plan.order.size() != plan.strokes.size())
        return Flaw{"/order",
                    fmt::format("{} entries for {} strokes", plan.order.size(), plan.strokes.size())};
    for (std::size_t i = 0; i < plan.order.size(); ++i) {
        const Entry& entry = plan.order[i];
        const std::string pointer = fmt::format("/order/{}", i);
        if (auto flaw = out_of_range(entry.stroke, plan.strokes.size(), false, pointer + "/stroke", "stroke"))
            return flaw;
        const auto nodes = plan.strokes[static_cast<std::size_t>(entry.stroke)].nodes.size();
        if (entry.node == 0) continue;  // a stroke without nodes is entered at its start
        if (auto flaw = out_of_range(entry.node, nodes, false, pointer + "/node", "node")) return flaw;
    }
    for (std::size_t i = 0; i < plan.connections.size(); ++i) {
        const PlannedConnection& connection = plan.connections[i];
        const std::string pointer = fmt::format("/connections/{}", i);
        if (auto flaw = out_of_range(connection.from, plan.strokes.size(), true, pointer + "/from", "stroke"))
            return flaw;
        if (auto flaw = out_of_range(connection.to, plan.strokes.size(), true, pointer + "/to", "stroke"))
            return flaw;
    }
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
        const int stroke = plan.samples[i].stroke;
        if (stroke < -1 || (stroke >= 0 && static_cast<std::size_t>(stroke) >= plan.strokes.size()))
            return Flaw{"/samples/stroke", fmt::format("sample {}: there is no stroke {}: there are {}", i,
                                                       stroke, plan.strokes.size())};
    }
    return std::nullopt;
}

}  // namespace strandline::formats
