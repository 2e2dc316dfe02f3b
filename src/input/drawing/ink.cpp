#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

constexpr svg::Colour start_mark{0, 255, 0};
// Widths that went through transforms: 3 must not become 3.0000001 and two pins more.
constexpr double width_slack = 1e-6;

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// The thresholds of 2014: strokes up to the first leave no mark, then 1, 3, 5 and 7 of 7 pins, more than the
/// last one too.
int pins_by_sizes(const std::vector<double>& sizes, const Robot& robot, double width) {
    constexpr std::array<int, 5> of_seven{0, 1, 3, 5, 7};
    std::size_t step = 0;
    while (step + 1 < sizes.size() && width > sizes[step] * (1 + width_slack)) ++step;
    const int wanted = of_seven[std::min(step, of_seven.size() - 1)];
    if (wanted == 0 || robot.pins == 7) return wanted;
    return std::clamp(static_cast<int>(std::lround(wanted * robot.pins / 7.0)), 1, robot.pins);
}

/// All points on one straight line: nothing to fill.
bool is_flat(const Path& path) {
    const Box box = bounds(path);
    const double extent = std::max(box.width(), box.height());
    if (!(extent > 0)) return true;
    const std::vector<Point> points = flattened(path, extent / 100);
    const Point a = points.front();
    const Point b = *std::ranges::max_element(points, {}, [&](Point p) { return distance(a, p); });
    return std::ranges::all_of(points,
                               [&](Point p) { return distance_to_segment(p, a, b) <= 1e-9 * extent; });
}

/// Relative luminance (IEC 61966-2-1) of the paint laid on a grey ground, 0 black to 1 white.
double luminance(const svg::Paint& paint, double ground) {
    const auto seen = [&](unsigned char channel) {
        return linear(ground + (channel / 255.0 - ground) * std::clamp(paint.opacity, 0.0, 1.0));
    };
    const svg::Colour c = paint.colour;
    return 0.2126 * seen(c.r) + 0.7152 * seen(c.g) + 0.0722 * seen(c.b);
}

/// What a paint does to the sheet.
struct Effect {
    bool ink = false;    ///< laid on white it is dark
    bool hides = false;  ///< laid on black it is bright: no ink shows through
};
Effect effect_of(std::optional<svg::Paint> paint, const DrawingOptions& options) {
    if (!paint || !(paint->opacity > 0)) return {};
    if (options.invert) {
        const auto negative = [](unsigned char channel) { return static_cast<unsigned char>(255 - channel); };
        paint->colour = {negative(paint->colour.r), negative(paint->colour.g), negative(paint->colour.b)};
    }
    return {luminance(*paint, 1) <= options.ink_threshold,
            options.occlusion && luminance(*paint, 0) > options.ink_threshold};
}

}  // namespace

bool stroke_is_area(const Inked& inked, const Robot& robot, double scale) {
    if (!inked.stroke) return false;
    const double width = inked.shape->stroke_width * scale;
    if (!inked.fill && inked.pinned) return false;
    // Beside a fill, a stroke narrower than one groove adds nothing that the rake could show.
    if (inked.fill && width >= robot.pin_pitch) return true;
    return robot.fill_wide_strokes && width > robot.rake_width();
}

namespace {

/// The stroke's pins: by its hint, else by its width; 0 leaves no mark.
int pins_of(const svg::Shape& shape, const std::vector<svg::Hint>& hints, const svg::Document& document,
            const Robot& robot, Warnings& warnings) {
    if (const std::string* asked = value_of(hints, "pins")) {
        int pins = 0;
        const auto [end, error] = std::from_chars(asked->data(), asked->data() + asked->size(), pins);
        if (error == std::errc{} && end == asked->data() + asked->size() && pins >= 1 && pins <= robot.pins)
            return pins;
        warnings.push_back(
            {shape.place,
             fmt::format("pins \"{}\" is not a number from 1 to {}: its width decides", *asked, robot.pins)});
    }
    return document.rake_sizes.empty() ? pins_for_width(robot, shape.stroke_width)
                                       : pins_by_sizes(document.rake_sizes, robot, shape.stroke_width);
}

Outcome<void> layers_are_there(const svg::Document& document, const DrawingOptions& options) {
    for (const std::string& wanted : options.layers) {
        if (std::ranges::any_of(document.layers, [&](const svg::Layer& layer) {
                return !is_left_out(layer.name) && matches(wanted, layer.name);
            }))
            continue;
        if (std::ranges::any_of(document.layers,
                                [&](const svg::Layer& layer) { return matches(wanted, layer.name); }))
            return fail("layer \"" + wanted + "\"", "is never drawn: its name begins with %", "rename it");
        std::string names;
        for (const svg::Layer& layer : document.layers)
            if (!is_left_out(layer.name))
                names += (names.empty() ? "" : ", ") + fmt::format("\"{}\"", layer.name);
        return fail("layer \"" + wanted + "\"", "is not in the drawing",
                    names.empty() ? "the drawing has no layers" : "choose among " + names);
    }
    return {};
}

}  // namespace

Outcome<Ink> ink_of(const svg::Document& document, const Robot& robot, const DrawingOptions& options) {
    if (const auto there = layers_are_there(document, options); !there) return tl::unexpected(there.error());
    const Choices choices(document, options);
    Ink ink;
    int section = 0;
    std::string pause_before;
    for (const svg::Shape& shape : document.shapes) {
        if (shape.subpaths.empty()) continue;
        if (const std::string fence = choices.fence_of(shape); !fence.empty()) {
            ink.fences.push_back({&shape, fence == "border"});
            continue;
        }
        if (!choices.chosen(shape)) {
            ++ink.unchosen;
            continue;
        }
        if (shape.stroke && shape.stroke->opacity > 0 && shape.stroke->colour == start_mark) {
            if (ink.start)
                ink.warnings.push_back({shape.place, "a second start mark (stroke #00ff00) is ignored"});
            else
                ink.start = shape.subpaths.front().start;
            continue;
        }
        Inked inked{&shape};
        inked.hints = choices.hints_of(shape);
        const std::string* named = value_of(inked.hints, "pause");
        const std::string pause = named != nullptr ? *named : "";
        section += pause != pause_before ? 1 : 0;
        pause_before = pause;
        inked.section = section;
        inked.pinned = value_of(inked.hints, "pins") != nullptr;
        const std::string* asked = value_of(inked.hints, "ink");
        if (asked != nullptr && *asked == "off") {
            ++ink.unchosen;
            continue;
        }
        if (asked != nullptr && *asked != "on")
            ink.warnings.push_back({shape.place, fmt::format("ink \"{}\" is neither on nor off", *asked)});
        Effect fill = effect_of(shape.fill, options), stroke = effect_of(shape.stroke, options);
        if (asked != nullptr && *asked == "on") {
            fill = {.ink = shape.fill && shape.fill->opacity > 0};
            stroke = {.ink = shape.stroke && shape.stroke->opacity > 0};
        }
        const bool flat = (fill.ink || fill.hides) && std::ranges::all_of(shape.subpaths, is_flat);
        inked.fill = fill.ink && !flat;
        inked.stroke = stroke.ink;
        inked.fill_hides = fill.hides && !flat;
        inked.stroke_hides = stroke.hides;
        if (inked.stroke) {
            inked.pins = pins_of(shape, inked.hints, document, robot, ink.warnings);
            inked.stroke = inked.pins > 0;
            if (!inked.stroke) {
                ++ink.bare;
                ink.warnings.push_back(
                    {shape.place, fmt::format("a stroke of width {:.3g} is drawn with no pin: left out",
                                              shape.stroke_width)});
            }
        } else if (shape.stroke) {
            ++ink.bare;
        }
        if (!inked.fill && (shape.fill || !shape.stroke) && !(inked.stroke && fill.ink)) ++ink.bare;
        std::erase_if(inked.hints, [](const svg::Hint& h) { return h.name == "ink" || h.name == "pins"; });
        if (inked.drawn() || inked.fill_hides || inked.stroke_hides) ink.shapes.push_back(inked);
    }
    for (const InkRule& rule : options.rules)
        if (std::ranges::none_of(document.shapes,
                                 [&](const svg::Shape& shape) { return choices.applies(rule, shape); }))
            ink.warnings.push_back(
                {fmt::format("rule for \"{}\"", rule.pattern), "nothing in the drawing is meant by it"});
    return ink;
}

}  // namespace strandline::drawing_parts
