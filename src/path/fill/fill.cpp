#include "path/fill/fill.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "path/fill/passes.hpp"

namespace strandline::fill {
namespace {

constexpr double bare_share = 0.03;  // of the area: less is corners that no rake can reach

Stroke stroke_of(const Polyline& line, int element, const Options& options) {
    Stroke stroke;
    stroke.element = element;
    stroke.one_way = stroke.fill = true;
    stroke.pins = options.pins;
    double s = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double d = distance(line[i - 1], line[i]);
        if (d <= 0) continue;
        stroke.rake_path.push_back(straight({line[i - 1], heading(line[i] - line[i - 1])}, d));
        s += d;
    }
    stroke.nodes = {{0, line.front(), -1}, {s, line.back(), -1}};
    return stroke;
}

/// The region is nowhere as wide as the rake: one pass along its middle, as it is better seen than missing.
std::vector<Pass> narrow_passes(const Region& region, const std::string& place, const Options& options,
                                Fill& account) {
    const Polyline middle = region.holes.empty() ? middle_line(region.outer, options.width) : Polyline{};
    if (middle.size() < 2 || area(region) < options.min_area) {
        ++account.dropped_parts;
        account.warnings.push_back(
            {place, fmt::format("is narrower than the rake ({} m) or smaller than {} m2: not filled",
                                options.width, options.min_area)});
        return {};
    }
    account.warnings.push_back(
        {place, fmt::format("is narrower than the rake ({} m): one pass along its middle", options.width)});
    return {{{}, middle}};
}

}  // namespace

Regions room_for_centre(const Region& region, const std::string& place, const Options& options,
                        Fill& account) {
    const double half = options.width / 2;
    Regions room = inset({region}, half);
    const auto too_small = [&](const Region& part) { return area(inset({part}, -half)) < options.min_area; };
    const auto dropped = std::erase_if(room, too_small);
    account.dropped_parts += static_cast<int>(dropped);
    if (room.empty()) return room;
    const Regions bare = subtracted({region}, inset(room, -half * 1.01));
    if (area(bare) > std::max(options.min_area, bare_share * area(region))) {
        const auto largest =
            std::ranges::max_element(bare, {}, [](const Region& part) { return area(part); });
        const Point at = centroid(largest->outer);
        account.warnings.push_back(
            {place,
             fmt::format(
                 "{:.3g} m2 is too narrow for the rake and left bare, most of it near ({:.2f}, {:.2f})",
                 area(bare), at.x, at.y)});
    }
    return room;
}

Fill fill_region(const Region& region, int element, const std::string& place, const Options& options) {
    Fill fill;
    fill.area = area(region);
    std::vector<Pass> passes = options.style == Style::zigzag ? zigzag_passes(region, place, options, fill)
                                                              : spiral_passes(region, place, options, fill);
    if (passes.empty()) passes = narrow_passes(region, place, options, fill);
    for (Pass& pass : passes) {
        fill.swept += length(pass.line) * options.width;
        fill.strokes.push_back(stroke_of(pass.line, element, options));
        fill.ways.push_back(std::move(pass.way));
    }
    return fill;
}

}  // namespace strandline::fill
