#include "plan/pipeline/pins.hpp"

#include <map>
#include <variant>

#include "path/rake/rake.hpp"
#include "plan/pipeline/hints.hpp"

namespace strandline::pipeline {
namespace {

/// The draws of one element's fill, and at which sample each begins.
struct Draws {
    std::vector<rake::Driven> goes;
    std::vector<std::size_t> first;
};

std::map<int, Draws> draws_of(const std::vector<Sample>& samples, const std::vector<Stroke>& strokes) {
    std::map<int, Draws> by_element;
    double driven = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        if (i > 0) driven += distance(samples[i - 1].rake, sample.rake);
        if (sample.motion != Motion::draw) continue;
        const Stroke& stroke = strokes[static_cast<std::size_t>(sample.stroke)];
        if (!stroke.fill) continue;
        Draws& draws = by_element[stroke.element];
        const bool goes_on =
            i > 0 && samples[i - 1].motion == Motion::draw && samples[i - 1].stroke == sample.stroke;
        if (!goes_on) {
            draws.goes.push_back({{}, driven});
            draws.first.push_back(i);
        }
        draws.goes.back().bar.push_back({sample.rake, sample.pose.heading});
        const bool ends = i + 1 < samples.size() &&
                          (samples[i + 1].motion != Motion::draw || samples[i + 1].stroke != sample.stroke);
        // Its last piece is driven up to the sample that belongs to what comes next.
        if (ends) draws.goes.back().bar.push_back({samples[i + 1].rake, samples[i + 1].pose.heading});
    }
    return by_element;
}

/// Where the rake has room an edge a pin's width off matters less than sand raked outside. A small or thin
/// area would hardly be seen.
double spill_price(const Region& region, const Robot& robot) {
    constexpr double thin_share = 0.5, even = 1;
    const double half = robot.rake_width() / 2;
    const double roomy = area(inset(inset({region}, half), -half));
    return roomy < thin_share * area(region) ? even : rake::Rake{}.spill_price;
}

}  // namespace

bool lifts_pins(const Options& options, const Robot& robot) {
    return options.fill.lift_pins && robot.pins > 1;
}

bool sees_pins(const Region& region, const Robot& robot) {
    // A turn's width round it: passes reach outside.
    return rake::sees_single_pins(grown(bounds(region), robot.rake_width()),
                                  {.width = robot.rake_width(), .pins = robot.pins});
}

Warnings lift_pins(std::vector<Sample>& samples, const std::vector<Stroke>& strokes, const Drawing& drawing,
                   const Robot& robot, const Options& options) {
    Warnings warnings;
    for (const auto& [number, draws] : draws_of(samples, strokes)) {
        const Element& element = drawing.elements[static_cast<std::size_t>(number)];
        const Options own = options_for(element, options);
        if (!lifts_pins(own, robot)) continue;
        const Region& region = std::get<RegionElement>(element.what).region;
        if (!sees_pins(region, robot)) continue;  // said when it was filled
        const Regions sand =
            own.fill.narrow == "warn" ? Regions{region} : rake::visible(region, robot.pin_pitch);
        const auto masks = rake::driven_masks(
            sand, draws.goes,
            {.width = robot.rake_width(), .pins = robot.pins, .spill_price = spill_price(region, robot)});
        if (!masks) {
            warnings.push_back({element.id, "is too large to lift pins one by one; all are down together"});
            continue;
        }
        for (std::size_t go = 0; go < masks->size(); ++go)
            for (std::size_t k = 0; k < (*masks)[go].size(); ++k)
                samples[draws.first[go] + k].mask = (*masks)[go][k];
    }
    return warnings;
}

}  // namespace strandline::pipeline
