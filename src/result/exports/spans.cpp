#include "result/exports/spans.hpp"

#include <algorithm>

namespace strandline::exports {

std::vector<Span> spans_of(const std::vector<Sample>& samples) {
    std::vector<Span> spans;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const bool down = samples[i].mask != 0;
        const int stroke = down ? samples[i].stroke : -1;
        if (spans.empty() || spans.back().down != down || spans.back().stroke != stroke)
            spans.push_back({i, i, down, stroke});
        spans.back().last = i + 1;
    }
    return spans;
}

Polyline tool_track(const Plan& plan, const Span& span) {
    const bool known = span.stroke >= 0 && span.stroke < static_cast<int>(plan.strokes.size());
    const unsigned pins =
        known ? pin_mask(plan.robot, plan.strokes[static_cast<std::size_t>(span.stroke)].pins) : 0;
    Polyline track;
    for (std::size_t i = span.first; i <= span.last; ++i)
        track.push_back(drawn_at(plan.robot, plan.samples[i], pins));
    return track;
}

std::vector<std::size_t> stop_samples(const Plan& plan, const std::vector<Sample>& samples) {
    std::vector<std::size_t> places;
    for (const Stop& stop : plan.stops) {
        const auto at = std::ranges::lower_bound(samples, stop.time, {}, &Sample::t);
        places.push_back(std::min<std::size_t>(static_cast<std::size_t>(at - samples.begin()),
                                               samples.empty() ? 0 : samples.size() - 1));
    }
    return places;
}

int times_backing(const std::vector<Sample>& samples) {
    int times = 0;
    bool back = false;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const bool now = backs(samples[i], samples[i + 1]);
        if (now && !back) ++times;
        back = now;
    }
    return times;
}

Site site_of(const Plan& plan, Warnings& warnings) {
    Site site = plan.options.site.at;
    if (!plan.options.site.known) {
        site.place = {};
        warnings.push_back({"site",
                            "no place on earth is set: latitude 0, longitude 0 is taken; set site.latitude, "
                            "site.longitude and site.heading, or measure them with strandline locate"});
    }
    return site;
}

const Element* element_of(const Plan& plan, int stroke) {
    if (stroke < 0 || stroke >= static_cast<int>(plan.strokes.size())) return nullptr;
    const int element = plan.strokes[static_cast<std::size_t>(stroke)].element;
    if (element < 0 || element >= static_cast<int>(plan.drawing.elements.size())) return nullptr;
    return &plan.drawing.elements[static_cast<std::size_t>(element)];
}

std::string hint_of(const Plan& plan, int stroke, const char* name, const std::string& otherwise) {
    const Element* element = element_of(plan, stroke);
    const std::string* value = element ? value_of(element->hints, name) : nullptr;
    return value ? *value : otherwise;
}

}  // namespace strandline::exports
