#include "plan/pipeline/hints.hpp"

#include <algorithm>
#include <compare>
#include <cstdlib>
#include <map>
#include <set>

#include "base/units/units.hpp"
#include "path/fill/fill.hpp"

namespace strandline::pipeline {
namespace {

int number_of(const Element& element, std::string_view name, int otherwise) {
    const std::string* value = value_of(element.hints, name);
    return value ? std::atoi(value->c_str()) : otherwise;
}

/// Elements of the same rank are ordered by the tour.
struct Rank {
    int section = 0, tool = 1, order = 0;
    auto operator<=>(const Rank&) const = default;
};
std::vector<Rank> ranks_of(const Drawing& drawing) {
    std::vector<Rank> ranks;
    for (const Element& element : drawing.elements)
        ranks.push_back({element.section, number_of(element, "tool", 1), number_of(element, "order", 0)});
    return ranks;
}

}  // namespace

Outcome<void> valid_fill(const Options& options, const Robot& robot) {
    if (const auto cuts = fill::cuts_of(options.fill.cuts, "fill.cuts"); !cuts)
        return tl::unexpected(cuts.error());
    if (const auto segments = fill::segment_choices_of(options.fill.segments, "fill.segments"); !segments)
        return tl::unexpected(segments.error());
    // A width is a product of what people write in decimals.
    if (options.fill.spacing > robot.rake_width() * (1 + 1e-9))
        return fail("fill.spacing",
                    number_text(options.fill.spacing) + " m is wider than the rake of " + robot.name,
                    "use at most " + number_text(robot.rake_width()) + " m");
    return {};
}

Outcome<void> valid_for(const svg::Hint& hint, const Robot& robot) {
    if (auto fine = valid(hint); !fine) return fine;
    if (!is_fill_hint(hint)) return {};
    Options options;
    static_cast<void>(set(options, hint));  // just found valid
    auto fine = valid_fill(options, robot);
    if (!fine) fine.error().place = hint.name;
    return fine;
}

Warnings drop_wrong_hints(svg::Document& document, const Robot& robot) {
    Warnings warnings;
    std::set<std::pair<std::string, std::string>> told;
    for (svg::Shape& shape : document.shapes)
        std::erase_if(shape.hints, [&](const svg::Hint& hint) {
            const auto fine = valid_for(hint, robot);
            if (!fine && told.emplace(hint.name, hint.value).second)
                warnings.push_back({shape.place, "hint " + sentence(fine.error()) + "; it is passed over"});
            return !fine;
        });
    return warnings;
}

Options options_for(const Element& element, const Options& options) {
    Options own = options;
    for (const svg::Hint& hint : element.hints)
        // checked by drop_wrong_hints
        if (is_fill_hint(hint)) static_cast<void>(set(own, hint));
    return own;
}

std::vector<Edit> entries_asked(const Drawing& drawing) {
    std::vector<Edit> edits;
    for (const Element& element : drawing.elements)
        if (value_of(element.hints, "start"))
            edits.push_back(EntryEdit{{element.id, number_of(element, "start", 0)}});
    return edits;
}

std::vector<std::vector<int>> batches_of(const std::vector<order::Group>& groups, const Drawing& drawing) {
    const std::vector<Rank> ranks = ranks_of(drawing);
    std::map<Rank, std::vector<int>> batches;
    for (std::size_t i = 0; i < groups.size(); ++i)
        batches[ranks[static_cast<std::size_t>(groups[i].work.element)]].push_back(static_cast<int>(i));
    std::vector<std::vector<int>> rows;
    if (batches.size() > 1)
        for (auto& [rank, members] : batches) rows.push_back(std::move(members));
    return rows;
}

std::vector<Stop> stops_of(const Plan& plan) {
    std::vector<Stop> stops;
    const std::vector<Rank> ranks = ranks_of(plan.drawing);
    std::size_t at = 0;
    for (std::size_t k = 0; k < plan.strokes.size(); ++k) {
        const auto element = static_cast<std::size_t>(plan.strokes[k].element);
        const std::string* pause = value_of(plan.drawing.elements[element].hints, "pause");
        std::string why;
        if (k == 0) {
            if (pause) why = "pause " + *pause;
        } else {
            const Rank &now = ranks[element],
                       &before = ranks[static_cast<std::size_t>(plan.strokes[k - 1].element)];
            if (now.section != before.section && pause) why = "pause " + *pause;
            if (now.tool != before.tool)
                why += (why.empty() ? "tool " : ", tool ") + std::to_string(now.tool);
        }
        if (why.empty()) continue;
        // the last sample of the stroke before
        while (k > 0 && at < plan.samples.size() && plan.samples[at].stroke != static_cast<int>(k) - 1) ++at;
        while (k > 0 && at < plan.samples.size() && plan.samples[at].stroke == static_cast<int>(k) - 1) ++at;
        stops.push_back({why, static_cast<int>(k), at < plan.samples.size() ? plan.samples[at].t : 0});
    }
    return stops;
}

}  // namespace strandline::pipeline
