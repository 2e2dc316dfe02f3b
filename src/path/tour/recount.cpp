#include <fmt/core.h>

#include <algorithm>

#include "path/tour/model.hpp"
#include "path/tour/tour.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Whether the step runs its element as the element's own fields ask for.
Outcome<void> check_step(const Problem& problem, const Step& step, const std::string& place) {
    const Element& element = problem.elements[at(step.element)];
    const int last = static_cast<int>(element.points.size()) - 1;
    const std::string name = named(problem, step.element);
    if (step.entry < 0 || step.entry > last)
        return fail(place, fmt::format("{} has no vertex {}", name, step.entry));
    if (element.entry && *element.entry != step.entry)
        return fail(place, fmt::format("{} is entered at {}, not at {}", name, step.entry, *element.entry));
    if (element.closed) {
        if (element.sense == Sense::any) return {};
        const bool ccw = (signed_area(element.points) > 0) != step.reversed;
        if (ccw != (element.sense == Sense::ccw) && signed_area(element.points) != 0)
            return fail(place, fmt::format("{} runs in the wrong sense", name));
        return {};
    }
    if (step.entry != (step.reversed ? last : 0))
        return fail(place, fmt::format("the open {} is entered at {} with reversed = {}", name, step.entry,
                                       step.reversed));
    if ((element.direction == Direction::forward && step.reversed) ||
        (element.direction == Direction::backward && !step.reversed))
        return fail(place, fmt::format("{} runs against its direction", name));
    return {};
}

int exit_vertex(const Problem& problem, const Step& step) {
    const Element& element = problem.elements[at(step.element)];
    return element.closed ? step.entry : static_cast<int>(element.points.size()) - 1 - step.entry;
}

}  // namespace

Outcome<double> recount(const Problem& problem, const std::vector<Step>& steps) {
    const std::size_t n = problem.elements.size();
    if (steps.size() != n)
        return fail("the order", fmt::format("has {} steps for {} elements", steps.size(), n));
    std::vector<int> place(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
        const std::string name = fmt::format("step {}", k);
        if (steps[k].element < 0 || at(steps[k].element) >= n)
            return fail(name, fmt::format("there is no element {}", steps[k].element));
        if (place[at(steps[k].element)] >= 0)
            return fail(name, fmt::format("{} a second time", named(problem, steps[k].element)));
        place[at(steps[k].element)] = static_cast<int>(k);
        if (const auto sound = check_step(problem, steps[k], name); !sound)
            return tl::unexpected(sound.error());
    }
    for (std::size_t l = 0; l < problem.links.size(); ++l) {
        const Link& link = problem.links[l];
        const int a = place[at(link.element_a)], b = place[at(link.element_b)];
        const auto holds = [&](int from, int from_vertex, int to, int to_vertex) {
            return to == from + 1 && exit_vertex(problem, steps[at(from)]) == from_vertex &&
                   steps[at(to)].entry == to_vertex;
        };
        if (!holds(a, link.vertex_a, b, link.vertex_b) && !holds(b, link.vertex_b, a, link.vertex_a))
            return fail(fmt::format("link {}", l),
                        fmt::format("{} and {} do not follow each other there",
                                    named(problem, link.element_a), named(problem, link.element_b)));
    }
    for (const auto& [i, j] : problem.before)
        if (place[at(i)] > place[at(j)])
            return fail("before", fmt::format("{} comes after {}", named(problem, i), named(problem, j)));
    int reached = -1;
    for (std::size_t g = 0; g < problem.groups.size(); ++g) {
        int low = static_cast<int>(n), high = -1;
        for (const int e : problem.groups[g]) {
            low = std::min(low, place[at(e)]);
            high = std::max(high, place[at(e)]);
        }
        if (high < 0) continue;
        if (high - low + 1 != static_cast<int>(problem.groups[g].size()))
            return fail(fmt::format("group {}", g), "has others drawn between its own");
        if (problem.keep_group_order && low < reached)
            return fail(fmt::format("group {}", g), "is drawn before an earlier one");
        reached = std::max(reached, high);
    }
    return length_of(problem, steps);
}

}  // namespace strandline::tour
