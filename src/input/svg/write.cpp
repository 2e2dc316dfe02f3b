// Document -> SVG text. The inverse of read().
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

#include "base/units/units.hpp"
#include "input/svg/svg.hpp"

namespace strandline::svg {
namespace {

// SVG's flags for an arc of nearly half a turn or more hang on its last digit (SVG 2, 9.5.1): it is written
// as two.
constexpr double longest_sweep = 3;

void append(std::string& text, char command, std::initializer_list<Point> points) {
    text += command;
    const char* gap = "";
    for (const Point p : points) {
        fmt::format_to(std::back_inserter(text), "{}{} {}", gap, number_text(p.x), number_text(p.y));
        gap = " ";
    }
}

/// Half axes of the ellipse of conjugate radii u and v, by the singular values of the matrix with these
/// columns, and the direction of the longer one in radians.
struct Axes {
    double longer, shorter, direction;
};
Axes axes_of(Point u, Point v) {
    const double e = (u.x + v.y) / 2, f = (u.x - v.y) / 2, g = (u.y + v.x) / 2, h = (u.y - v.x) / 2;
    const double q = std::hypot(e, h), r = std::hypot(f, g);
    return {q + r, std::abs(q - r), (std::atan2(h, e) + std::atan2(g, f)) / 2};
}

struct Writer {
    std::string& text;

    void operator()(const LineSegment& s) { append(text, 'L', {s.to}); }
    void operator()(const CubicSegment& s) { append(text, 'C', {s.control1, s.control2, s.to}); }
    void operator()(const ArcSegment& s) {
        if (std::abs(s.sweep) > longest_sweep) {
            const double half = s.sweep / 2, t = s.start + half;
            const Point middle = s.center + std::cos(t) * s.u + std::sin(t) * s.v;
            (*this)(ArcSegment{s.center, s.u, s.v, s.start, half, middle});
            (*this)(ArcSegment{s.center, s.u, s.v, t, half, s.to});
            return;
        }
        const Axes axes = axes_of(s.u, s.v);
        const bool positive = (cross(s.u, s.v) > 0) == (s.sweep > 0);
        fmt::format_to(std::back_inserter(text), "A{} {} {} 0 {} {} {}", number_text(axes.longer),
                       number_text(axes.shorter), number_text(axes.direction * 180 / pi), positive ? 1 : 0,
                       number_text(s.to.x), number_text(s.to.y));
    }
};

std::string path_data(const std::vector<Path>& subpaths) {
    std::string text;
    for (const Path& path : subpaths) {
        append(text, 'M', {path.start});
        for (const Segment& segment : path.segments) std::visit(Writer{text}, segment);
        if (path.closed) text += 'Z';
    }
    return text;
}

std::string escaped(std::string_view plain) {
    std::string text;
    for (const char c : plain) {
        switch (c) {
            case '&':
                text += "&amp;";
                break;
            case '<':
                text += "&lt;";
                break;
            case '"':
                text += "&quot;";
                break;
            default:
                text += c;
        }
    }
    return text;
}

std::string paint_text(const char* property, const std::optional<Paint>& paint) {
    if (!paint) return fmt::format(" {}=\"none\"", property);
    const Colour c = paint->colour;
    std::string text = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", property, c.r, c.g, c.b);
    if (paint->opacity != 1) text += fmt::format(" {}-opacity=\"{}\"", property, number_text(paint->opacity));
    return text;
}

std::string stroke_text(const Shape& shape) {
    constexpr std::array caps{"butt", "round", "square"}, joins{"miter", "round", "bevel"};
    std::string text = paint_text("stroke", shape.stroke) +
                       fmt::format(" stroke-width=\"{}\"", number_text(shape.stroke_width));
    if (shape.cap != LineCap::butt)
        text += fmt::format(" stroke-linecap=\"{}\"", caps[static_cast<std::size_t>(shape.cap)]);
    if (shape.join != LineJoin::miter)
        text += fmt::format(" stroke-linejoin=\"{}\"", joins[static_cast<std::size_t>(shape.join)]);
    return text;
}

std::string element(const std::string& id, const std::string& attributes, const std::vector<Path>& paths) {
    return fmt::format("<path id=\"{}\"{} d=\"{}\"/>\n", escaped(id), attributes, path_data(paths));
}

std::string shape_text(const Shape& shape) {
    std::string hints, fill = paint_text("fill", shape.fill);
    for (const Hint& hint : shape.hints)
        hints += fmt::format(" data-strandline-{}=\"{}\"", hint.name, escaped(hint.value));
    if (shape.fill && shape.fill_rule == FillRule::even_odd) fill += " fill-rule=\"evenodd\"";
    if (!shape.stroke) return element(shape.id, fill + hints, shape.subpaths);
    if (!shape.lines) return element(shape.id, fill + stroke_text(shape) + hints, shape.subpaths);
    const std::string lines = paint_text("fill", {}) + stroke_text(shape) + hints;
    if (!shape.fill) return element(shape.id, lines, *shape.lines);
    return element(shape.id, fill + hints, shape.subpaths) +
           element(shape.id + "/stroke", lines, *shape.lines);
}

}  // namespace

std::string write(const Document& document) {
    const Box view = document.view;
    std::string text =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"";
    if (document.size_metres)
        text += fmt::format(" width=\"{}mm\" height=\"{}mm\"", number_text(1000 * document.size_metres->x),
                            number_text(1000 * document.size_metres->y));
    text += fmt::format(" viewBox=\"{} {} {} {}\"", number_text(view.low.x), number_text(view.low.y),
                        number_text(view.width()), number_text(view.height()));
    if (!document.rake_sizes.empty()) {
        std::string sizes;
        for (const double size : document.rake_sizes)
            sizes += fmt::format("{}{}", sizes.empty() ? "" : " ", number_text(size));
        text += fmt::format(" rake_sizes=\"{}\"", sizes);
    }
    text += ">\n";
    std::string layer;
    const auto close_layer = [&] { text += layer.empty() ? "" : "</g>\n"; };
    for (const Shape& shape : document.shapes) {
        if (shape.layer != layer) {
            close_layer();
            layer = shape.layer;
            if (!layer.empty())
                text +=
                    fmt::format("<g inkscape:groupmode=\"layer\" inkscape:label=\"{}\">\n", escaped(layer));
        }
        text += shape_text(shape);
    }
    close_layer();
    return text + "</svg>\n";
}

}  // namespace strandline::svg
