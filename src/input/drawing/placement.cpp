#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

constexpr double metres_per_inch = 0.0254;

std::optional<double> physical_scale(const svg::Document& document) {
    if (!document.size_metres) return std::nullopt;
    double scale =
        std::numeric_limits<double>::infinity();  // the smaller of both: preserveAspectRatio's "meet"
    if (document.view.width() > 0) scale = std::min(scale, document.size_metres->x / document.view.width());
    if (document.view.height() > 0) scale = std::min(scale, document.size_metres->y / document.view.height());
    return std::isfinite(scale) && scale > 0 ? std::optional(scale) : std::nullopt;
}

/// Mirror, y up, turn: everything but scale and place.
Affine turning(const DrawingOptions& options) {
    const Point along = unit(options.rotate);
    const Affine turn{along.x, along.y, -along.y, along.x, 0, 0};
    return composed(turn, Affine{options.mirror ? -1.0 : 1.0, 0, 0, -1, 0, 0});
}

/// Line paths and outlines, with the growth of strokes that are areas at that scale. User units, turned.
Box drawn_box(const std::vector<Inked>& shapes, const Affine& turn, const Robot& robot, double scale) {
    Box box;
    for (const Inked& inked : shapes) {
        if (!inked.drawn()) continue;
        double growth = stroke_is_area(inked, robot, scale) ? inked.shape->stroke_width / 2 : 0;
        if (growth > 0 && inked.shape->cap == svg::LineCap::square) growth *= std::numbers::sqrt2;
        const auto add = [&](const Path& path, double grow) {
            const Box one = bounds(transformed(path, turn));
            // A dot is too short to be drawn; a far-away one must not shrink the rest.
            if (grow > 0 || one.width() > 0 || one.height() > 0) box = united(box, grown(one, grow));
        };
        const bool apart = inked.shape->lines.has_value();  // the stroke does not follow the fill's outline
        for (const Path& path : inked.shape->subpaths)
            if (inked.fill || !apart) add(path, apart ? 0 : growth);
        if (inked.stroke && apart)
            for (const Path& path : *inked.shape->lines) add(path, growth);
    }
    return box;
}

double fit_scale(Box box, const DrawingOptions& options) {
    double scale = std::numeric_limits<double>::infinity();
    if (box.width() > 0) scale = std::min(scale, (options.canvas.width - 2 * options.margin) / box.width());
    if (box.height() > 0)
        scale = std::min(scale, (options.canvas.height - 2 * options.margin) / box.height());
    return scale;
}

Outcome<double> scale_for(Box box, const svg::Document& document, const DrawingOptions& options) {
    const double own_size = physical_scale(document).value_or(metres_per_inch / document.dpi);
    switch (options.place) {
        case Place::fit:
            return fit_scale(box, options);
        case Place::actual:
            return own_size;
        case Place::scale:
            return own_size / options.scale_denominator;
        case Place::width:
            if (!(box.width() > 0))
                return fail("place.width", "the drawing has no width to scale by", "use fit or scale");
            return options.place_width / box.width();
    }
    return 1.0;
}

Outcome<void> checked(const DrawingOptions& options) {
    const Canvas& canvas = options.canvas;
    if (!(canvas.width > 0 && canvas.height > 0) || !std::isfinite(canvas.width) ||
        !std::isfinite(canvas.height))
        return fail("canvas", fmt::format("{:g} x {:g} m is no area", canvas.width, canvas.height),
                    "give both sides above zero");
    if (!(options.margin >= 0) || !std::isfinite(options.margin))
        return fail("canvas.margin", fmt::format("{:g} is not a length", options.margin),
                    "give 0 or more metres");
    if (options.place == Place::fit && 2 * options.margin >= std::min(canvas.width, canvas.height))
        return fail("canvas.margin",
                    fmt::format("{:g} m on each side leaves nothing of a canvas of {:g} x {:g} m",
                                options.margin, canvas.width, canvas.height),
                    fmt::format("make it less than {:g} m", std::min(canvas.width, canvas.height) / 2));
    if (options.place == Place::width && !(options.place_width > 0 && std::isfinite(options.place_width)))
        return fail("place.width", fmt::format("{:g} m is not a width", options.place_width),
                    "give metres above zero");
    if (options.place == Place::scale &&
        !(options.scale_denominator > 0 && std::isfinite(options.scale_denominator)))
        return fail("place.scale", fmt::format("1:{:g} is not a scale", options.scale_denominator),
                    "give a number above zero, such as 1:50");
    if (!std::isfinite(options.rotate)) return fail("drawing.rotate", "is not a finite angle");
    if (options.position && !is_finite(*options.position))
        return fail("drawing.position", "is not a finite point");
    if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
        return fail("drawing.tolerance", fmt::format("{:g} m is not a tolerance", options.tolerance),
                    "give metres above zero, such as 2mm");
    if (!(options.join_tolerance >= 0) || !std::isfinite(options.join_tolerance))
        return fail("drawing.join_tolerance", fmt::format("{:g} is not a length", options.join_tolerance),
                    "give 0 or more metres");
    return {};
}

}  // namespace

Outcome<Placement> placed(const svg::Document& document, const std::vector<Inked>& shapes, const Robot& robot,
                          const DrawingOptions& options) {
    if (const auto fine = checked(options); !fine) return tl::unexpected(fine.error());
    const Affine turn = turning(options);

    // Which strokes are areas depends on the scale, and the box on which strokes are areas. The bare paths
    // give the largest scale that can come out, so every stroke that is an area at the final scale has its
    // growth in the second box.
    Box box = drawn_box(shapes, turn, robot, 0);
    if (box.empty() || (box.width() == 0 && box.height() == 0))
        return fail("drawing", "nothing to draw: all shapes are single points", "draw lines or areas");
    auto scale = scale_for(box, document, options);
    if (scale && std::isfinite(*scale)) {
        box = drawn_box(shapes, turn, robot, *scale);
        scale = scale_for(box, document, options);
    }
    if (!scale) return tl::unexpected(scale.error());
    const Point size{box.width() * *scale, box.height() * *scale};
    if (!std::isfinite(*scale) || !(*scale > 0) || !is_finite(box.low) || !is_finite(size))
        return fail("drawing", fmt::format("a scale of {:g} m per user unit cannot be worked with", *scale),
                    "check the drawing's coordinates");

    Placement placement;
    placement.scale = *scale;
    if (const auto own = physical_scale(document))
        placement.scale_denominator = *own / *scale;
    else if (options.place == Place::actual || options.place == Place::scale)
        placement.warnings.push_back(
            {"drawing", fmt::format("the file states no physical size: its units are taken as px of {:g} dpi",
                                    document.dpi)});
    if (document.size_doubt && (options.place == Place::actual || options.place == Place::scale))
        placement.warnings.push_back(*document.size_doubt);

    const Canvas& canvas = options.canvas;
    const Point low =
        options.position.value_or(Point{(canvas.width - size.x) / 2, (canvas.height - size.y) / 2});
    const Point shift = low - *scale * box.low;
    placement.to_canvas = composed(Affine{*scale, 0, 0, *scale, shift.x, shift.y}, turn);

    const double slack = 1e-9 * std::max(canvas.width, canvas.height);
    const Box field{{-slack, -slack}, {canvas.width + slack, canvas.height + slack}};
    if (!contains(field, low) || !contains(field, low + size))
        placement.warnings.push_back(
            {"drawing",
             fmt::format(
                 "leaves the canvas: it is {:.3f} x {:.3f} m with its lower left corner at ({:.3f}, {:.3f}), "
                 "the canvas {:g} x {:g} m",
                 size.x, size.y, low.x, low.y, canvas.width, canvas.height)});
    return placement;
}

}  // namespace strandline::drawing_parts
