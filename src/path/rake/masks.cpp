// Masks along strokes, and along a drive.
#include <cmath>

#include "path/rake/bar_steps.hpp"
#include "path/rake/masker.hpp"
#include "path/rake/pin_steps.hpp"

namespace strandline::rake {
namespace {

constexpr double longest_step = 1;       // cells
constexpr double least_sliver = 2;       // pins squared
constexpr double least_cells_a_pin = 2;  // a coarser raster does not see single pins

// Room for the whole rake and a cell beside it: samples need no look at the borders.
Raster raster_for(Box box, const Rake& rake) {
    return raster_over(grown(box, rake.width), rake.width / (samples_a_pin * rake.pins));
}

bool sees(const Raster& raster, const Rake& rake) {
    return raster.cell * least_cells_a_pin <= rake.width / rake.pins;
}

}  // namespace

bool sees_single_pins(Box area, const Rake& rake) { return sees(raster_for(area, rake), rake); }

std::vector<PinSpans> pin_masks(const Regions& regions, const std::vector<Stroke>& strokes,
                                const std::vector<Polyline>& ways, const Rake& rake) {
    std::vector<Track> tracks;
    Box box = bounds(regions);
    for (const Stroke& stroke : strokes) {
        tracks.push_back(track_of(stroke.rake_path, rake.tolerance));
        box = united(box, bounds(tracks.back().line));
    }
    const Raster raster = raster_for(box, rake);
    const auto steps = pin_steps(tracks, ways, raster, longest_step);
    Masker<PinStep> masker(regions, raster, rake);
    std::vector<std::vector<unsigned>> visitors;
    for (const auto& of_stroke : steps) visitors.push_back(masker.foresee(of_stroke));
    masker.forget_visits();
    std::vector<PinSpans> masks;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::vector<unsigned> decided = masker.masks_of(steps[i], visitors[i]);
        PinSpans& spans = masks.emplace_back();
        for_stretches(steps[i], decided, 0, steps[i].size(), [&](const PinStep& stretch, unsigned mask) {
            if (!spans.empty() && spans.back().mask == mask)
                spans.back().to = stretch.to;
            else
                spans.push_back({stretch.from, stretch.to, mask});
        });
        std::erase_if(spans, [](const PinSpan& span) { return span.mask == 0; });
    }
    return masks;
}

Regions visible(const Region& region, double pin) {
    const Regions wide = inset(inset({region}, pin / 2), -pin / 2);
    Regions thin = subtracted({region}, wide);
    std::erase_if(thin, [&](const Region& part) { return area(part) < least_sliver * pin * pin; });
    return thin.empty() ? Regions{region} : united({region}, inset(thin, -pin / 2));
}

std::optional<std::vector<DrivenMasks>> driven_masks(const Regions& regions, const std::vector<Driven>& goes,
                                                     const Rake& rake) {
    Box box = bounds(regions);
    for (const Driven& go : goes)
        for (const Pose& pose : go.bar) box = united(box, {pose.at, pose.at});
    const Raster raster = raster_for(box, rake);
    if (!sees(raster, rake)) return {};
    std::vector<std::vector<BarStep>> steps;
    for (const Driven& go : goes) steps.push_back(bar_steps(go, raster));
    Masker<BarStep> masker(regions, raster, rake);
    std::vector<std::vector<unsigned>> visitors;
    for (const auto& of_go : steps) visitors.push_back(masker.foresee(of_go));
    masker.forget_visits();
    std::vector<DrivenMasks> masks;
    for (std::size_t i = 0; i < steps.size(); ++i) masks.push_back(masker.masks_of(steps[i], visitors[i]));
    return masks;
}

}  // namespace strandline::rake
