#include "input/drawing/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "input/drawing/parts.hpp"

namespace strandline {

bool is_region(const Element& element) { return std::holds_alternative<RegionElement>(element.what); }

Box bounds(const Element& element) {
    if (const auto* line = std::get_if<LineElement>(&element.what)) return bounds(line->path);
    return bounds(std::get<RegionElement>(element.what).region);
}

double length(const Element& element) {
    if (const auto* line = std::get_if<LineElement>(&element.what)) return length(line->path);
    const Region& region = std::get<RegionElement>(element.what).region;
    return std::accumulate(region.holes.begin(), region.holes.end(), perimeter(region.outer),
                           [](double sum, const Polygon& hole) { return sum + perimeter(hole); });
}

Path drawn_by_hand(const Path& path, double tolerance) { return drawing_parts::smoothed(path, tolerance); }

const std::string* value_of(const std::vector<svg::Hint>& hints, std::string_view name) {
    const auto found = std::ranges::find(hints, name, &svg::Hint::name);
    return found == hints.end() ? nullptr : &found->value;
}

namespace {

tl::unexpected<Error> nothing_to_draw(const DrawingCounts& counts) {
    if (counts.shapes == 0)
        return fail("drawing", "nothing to draw: the file holds no shapes", "draw some lines or areas");
    return fail("drawing",
                fmt::format("nothing to draw: of {} shapes {} paints are bare sand, {} are not chosen, {} "
                            "hidden, {} lines too "
                            "short, {} areas too small",
                            counts.shapes, counts.bare, counts.unchosen, counts.hidden, counts.too_short,
                            counts.too_small),
                "give the shapes a dark fill or stroke, or lower drawing.min_length and fill.min_area");
}

}  // namespace

Outcome<Drawing> make_drawing(const svg::Document& document, const Robot& robot,
                              const DrawingOptions& options, const Progress& progress) {
    using namespace drawing_parts;
    Drawing drawing;
    drawing.canvas = options.canvas;
    drawing.counts.shapes = static_cast<int>(document.shapes.size());

    auto ink = ink_of(document, robot, options);
    if (!ink) return tl::unexpected(ink.error());
    drawing.counts.bare = ink->bare;
    drawing.counts.unchosen = ink->unchosen;
    drawing.warnings = std::move(ink->warnings);
    if (std::ranges::none_of(ink->shapes, &Inked::drawn)) return nothing_to_draw(drawing.counts);

    auto placement = placed(document, ink->shapes, robot, options);
    if (!placement) return tl::unexpected(placement.error());
    drawing.scale = placement->scale;
    drawing.scale_denominator = placement->scale_denominator;
    drawing.to_canvas = placement->to_canvas;
    drawing.warnings.insert(drawing.warnings.end(), placement->warnings.begin(), placement->warnings.end());
    if (ink->start) drawing.start = apply(drawing.to_canvas, *ink->start);

    place_fences(drawing, ink->fences, *placement, options.tolerance);
    drawing.elements =
        elements_of(ink->shapes, *placement, robot, options, drawing.counts, drawing.warnings, progress);
    // Doubled lines would meet in four ends; and two halves may join into what is there already.
    drop_duplicates(drawing.elements, options.join_tolerance, drawing.counts);
    join_lines(drawing.elements, options.join_tolerance, drawing.counts);
    drop_duplicates(drawing.elements, options.join_tolerance, drawing.counts);
    for (Element& element : drawing.elements)
        if (auto* line = std::get_if<LineElement>(&element.what)) {
            if (options.simplify > 0) line->path = simplified(line->path, options.simplify);
            if (options.smooth > 0) line->path = smoothed(line->path, options.smooth);
        }
    drop_short(drawing.elements, options.min_length, drawing.counts);
    if (drawing.elements.empty()) return nothing_to_draw(drawing.counts);
    find_enclosures(drawing.elements, options.join_tolerance);
    progress.report("drawing", 1);
    return drawing;
}

}  // namespace strandline
