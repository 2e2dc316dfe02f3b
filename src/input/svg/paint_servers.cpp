#include <fmt/format.h>

#include "input/svg/style.hpp"

namespace strandline::svg {

namespace {

bool is_gradient(pugi::xml_node node) {
    const auto name = local_name(node.name());
    return name == "linearGradient" || name == "radialGradient" || name == "meshgradient" ||
           name == "meshGradient";
}

Ink stop_ink(pugi::xml_node stop, StyleContext& context) {
    Ink ink;
    double opacity = 1;
    for (const auto& [name, value, important] : cascade(stop, context)) {
        if (name == "stop-color") {
            if (const auto read = read_colour(value)) ink = *read;
        } else if (name == "stop-opacity") {
            if (const auto read = read_share(value)) opacity = *read;
        }
    }
    ink.alpha *= opacity;
    return ink;
}

/// Of the gradient's own stops; none: nothing.
std::optional<Served> mean_of_stops(pugi::xml_node gradient, StyleContext& context) {
    int stops = 0;
    double red = 0, green = 0, blue = 0, alpha = 0;
    bool uniform = true;
    Ink first;
    for (const auto stop : gradient.children()) {
        if (local_name(stop.name()) != "stop") continue;
        const auto ink = stop_ink(stop, context);
        if (stops++ == 0) first = ink;
        if (!(ink.colour == first.colour && ink.alpha == first.alpha)) uniform = false;
        red += ink.alpha * ink.colour.r;
        green += ink.alpha * ink.colour.g;
        blue += ink.alpha * ink.colour.b;
        alpha += ink.alpha;
    }
    if (stops == 0) return std::nullopt;
    const auto channel = [&](double sum) {
        return static_cast<unsigned char>(alpha > 0 ? sum / alpha + 0.5 : 0);
    };
    const Ink mean = uniform ? first : Ink{{channel(red), channel(green), channel(blue)}, alpha / stops};
    return Served{{Brush::Kind::ink, mean, !uniform}, uniform};
}

/// Of the gradient, or of the one whose stops it takes over. Every gradient's stops are read once, however
/// many refer to it.
Served served_gradient(std::string_view id, StyleContext& context) {
    constexpr std::size_t longest_chain = 32;  // gradients that refer to gradients; also ends a circle
    std::vector<std::string_view> chain;
    Served served;  // without stops a gradient paints nothing (SVG 2, 14.2.4)
    while (chain.size() < longest_chain) {
        const auto node = element_of(context.references, id);
        if (!is_gradient(node)) break;
        if (const auto known = context.gradients.find(id); known != context.gradients.end()) {
            served = known->second;
            break;
        }
        chain.push_back(id);
        if (const auto own = mean_of_stops(node, context)) {
            served = *own;
            break;
        }
        const auto reference = href_of(node);
        if (!reference.starts_with('#')) break;
        id = reference.substr(1);
    }
    for (const auto member : chain) context.gradients.insert_or_assign(member, served);
    return served;
}

}  // namespace

std::optional<Brush> served_paint(std::string_view id, pugi::xml_node user, StyleContext& context) {
    const auto node = element_of(context.references, id);
    if (!node) return std::nullopt;
    const auto name = local_name(node.name());
    auto& notes = context.notes;
    if (name == "pattern" || name == "hatch") {
        note(notes, "a pattern: drawn as black ink", user);
        return Brush{Brush::Kind::ink, {}, true};
    }
    if (!is_gradient(node)) return std::nullopt;
    const auto served = served_gradient(id, context);
    if (!served.uniform) note(notes, "a gradient: drawn as one ink, the mean of its stops", user);
    return served.brush;
}

}  // namespace strandline::svg
