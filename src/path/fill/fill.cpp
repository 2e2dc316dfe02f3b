#include "path/fill/fill.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "path/fill/passes.hpp"

namespace strandline::fill {
namespace {

constexpr double bare_share = 0.03;  // of the area: less is corners that no rake can reach
// Joints of a pass that turn less (radians) are a bend drawn by chords, where that bulges by less than the
// tolerance.
constexpr double smooth_turn = 0.5;

Stroke stroke_of(const Polyline& line, int element, const Options& options) {
    Stroke stroke;
    stroke.element = element;
    stroke.one_way = stroke.fill = true;
    stroke.pins = options.pins;
    // Rings come as chords of their arcs: a robot that took each joint for a corner would stop there.
    stroke.rake_path =
        fitted(path_through(line, false), {.tolerance = options.tolerance, .smooth_angle = smooth_turn});
    stroke.nodes = {{0, line.front(), -1}, {length(stroke.rake_path), line.back(), -1}};
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
    const auto passes_of = options.style == Style::zigzag   ? zigzag_passes
                           : options.style == Style::spiral ? spiral_passes
                                                            : ring_passes;
    std::vector<Pass> passes = passes_of(region, place, options, fill);
    if (passes.empty()) passes = narrow_passes(region, place, options, fill);
    for (Pass& pass : passes) {
        fill.swept += length(pass.line) * options.width;
        fill.strokes.push_back(stroke_of(pass.line, element, options));
        fill.ways.push_back(std::move(pass.way));
    }
    if (options.account)
        fill.account =
            account_of({region}, moves_of(fill.strokes, fill.ways, {}, options.pins, options.tolerance),
                       {.width = options.width, .pins = options.pins});
    return fill;
}

}  // namespace strandline::fill
