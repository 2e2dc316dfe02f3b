#include "input/svg/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandline::svg {

namespace {

constexpr double metres_per_inch = 0.0254;

struct Extent {
    std::optional<double> pixels;  ///< absent: none, auto, %, or not understood
    bool in_px = false;            ///< it has no unit of length, or px
};
Outcome<Extent> extent_of(pugi::xml_node root, const char* name, Axis axis, double dpi, Notes& notes) {
    const auto text = trimmed(root.attribute(name).value());
    if (text.empty() || text == "auto") return Extent{};
    const auto length = read_length(text, axis, {0, 0, dpi}, 16);
    if (length.state == ValueState::refused)
        return fail(place_of(notes.markup, root),
                    fmt::format("{} is not finite or beyond {:g}", name, largest_number),
                    "give the drawing a size");
    if (length.state == ValueState::malformed) {
        note(notes, "a width or height that is not understood: passed over", root, text);
        return Extent{};
    }
    if (length.percent) return Extent{};
    if (length.value <= 0) {
        note(notes, "a width or height of zero or less: passed over", root, text);
        return Extent{};
    }
    const char last = text.back();
    return Extent{length.value, text.ends_with("px") || last == '.' || (last >= '0' && last <= '9')};
}

/// SVG 2, 8.2, for a page of w x h px: under `none` the units are stretched until they are square, under
/// `slice` what shows is less than the viewBox.
void follow_aspect(Frame& frame, double w, double h, std::string_view aspect) {
    const Box view = *frame.view;
    if (aspect.starts_with("none")) {
        const double stretch = h * view.width() / (w * view.height());
        constexpr double visible_difference = 1e-9;
        if (std::abs(stretch - 1) < visible_difference) return;
        frame.map = {1, 0, 0, stretch, 0, 0};
        frame.pixels_per_unit = w / view.width();
        frame.view = Box{apply(frame.map, view.low), apply(frame.map, view.high)};
    } else if (aspect.ends_with("slice")) {
        const Affine to_page = view_box_map(view, {{0, 0}, {w, h}}, aspect);
        const Point low{-to_page.e / to_page.a, -to_page.f / to_page.d};
        frame.view = Box{low, low + Point{w / to_page.a, h / to_page.d}};
        frame.pixels_per_unit = to_page.a;
    }
}

}  // namespace

Outcome<std::vector<double>> number_list(std::string_view text, const std::string& place,
                                         std::string_view what) {
    std::vector<double> values;
    Scanner scanner{trimmed(text)};
    while (!scanner.done()) {
        const auto number = take_number(scanner);
        if (number.state == ValueState::refused)
            return fail(place,
                        fmt::format("a number in {} is not finite or beyond {:g}", what, largest_number),
                        "mend the file");
        if (number.state != ValueState::good)
            return fail(place, fmt::format("{} is not a list of numbers", what));
        values.push_back(number.value);
        skip_separator(scanner);
    }
    return values;
}

Outcome<std::optional<Box>> view_box_of(pugi::xml_node node, Notes& notes) {
    const auto text = trimmed(node.attribute("viewBox").value());
    if (text.empty()) return std::optional<Box>{};
    const auto values = number_list(text, place_of(notes.markup, node), "viewBox");
    if (!values && !values.error().remedy.empty()) return tl::unexpected(values.error());
    if (!values || values->size() != 4) {
        note(notes, "a viewBox that is not four numbers: passed over", node, text);
        return std::optional<Box>{};
    }
    const auto& v = *values;
    if (v[2] <= 0 || v[3] <= 0) {
        note(notes, "a viewBox without area: passed over", node, text);
        return std::optional<Box>{};
    }
    return std::optional<Box>{Box{{v[0], v[1]}, {v[0] + v[2], v[1] + v[3]}}};
}

Affine view_box_map(const Box& view, const Box& port, std::string_view preserve_aspect_ratio) {
    auto words = trimmed(preserve_aspect_ratio);
    if (words.starts_with("defer")) words = trimmed(words.substr(5));
    double sx = port.width() / view.width(), sy = port.height() / view.height();
    double share_x = 0.5, share_y = 0.5;
    if (!words.starts_with("none")) {
        sx = sy = words.ends_with("slice") ? std::max(sx, sy) : std::min(sx, sy);
        const auto share = [](std::string_view word) {
            return word == "Min" ? 0.0 : word == "Max" ? 1.0 : 0.5;
        };
        constexpr std::size_t align_length = 8;  // xMidYMid
        if (words.size() >= align_length) {
            share_x = share(words.substr(1, 3));
            share_y = share(words.substr(5, 3));
        }
    }
    const double e = port.low.x - view.low.x * sx + share_x * (port.width() - view.width() * sx);
    const double f = port.low.y - view.low.y * sy + share_y * (port.height() - view.height() * sy);
    return {sx, 0, 0, sy, e, f};
}

Outcome<Frame> root_frame(pugi::xml_node root, double dpi, Notes& notes) {
    Frame frame;
    const auto box = view_box_of(root, notes);
    if (!box) return tl::unexpected(box.error());
    const auto width = extent_of(root, "width", Axis::x, dpi, notes);
    if (!width) return tl::unexpected(width.error());
    const auto height = extent_of(root, "height", Axis::y, dpi, notes);
    if (!height) return tl::unexpected(height.error());
    auto w = width->pixels, h = height->pixels;
    if (*box) {
        const auto& view = **box;
        frame.view = view;
        if (w && !h) h = *w * view.height() / view.width();  // as CSS does for `auto`
        if (h && !w) w = *h * view.width() / view.height();
    } else if (w && h) {
        frame.view = Box{{0, 0}, {*w, *h}};
    }
    frame.viewport.dpi = dpi;
    if (w && h) {
        const double metres_per_pixel = metres_per_inch / dpi;
        frame.size_metres = Point{*w * metres_per_pixel, *h * metres_per_pixel};
        frame.size_in_px = width->in_px || height->in_px;
    }
    if (frame.view) {
        frame.viewport = {frame.view->width(), frame.view->height(), dpi};
        frame.percent_known = true;
        if (w && h) {
            frame.pixels_per_unit = std::min(*w / frame.view->width(), *h / frame.view->height());
            if (*box) follow_aspect(frame, *w, *h, trimmed(root.attribute("preserveAspectRatio").value()));
        }
    }
    return frame;
}

}  // namespace strandline::svg
