#include <fmt/format.h>

#include "input/svg/style.hpp"

namespace strandline::svg {

namespace {

void index_ids(PaintServers& servers, const pugi::xml_document& tree) {
    servers.indexed = true;
    for (auto node = tree.document_element(); node;) {
        if (const auto id = node.attribute("id")) servers.by_id.try_emplace(id.value(), node);
        if (const auto child = node.first_child()) {  // next in document order, without recursion
            node = child;
            continue;
        }
        while (node && !node.next_sibling()) node = node.parent();
        if (node) node = node.next_sibling();
    }
}

bool is_gradient(pugi::xml_node node) {
    const auto name = local_name(node.name());
    return name == "linearGradient" || name == "radialGradient" || name == "meshgradient" ||
           name == "meshGradient";
}

std::string_view reference_of(pugi::xml_node node) {
    for (const auto attribute : node.attributes())
        if (local_name(attribute.name()) == "href") return trimmed(attribute.value());
    return {};
}

Ink stop_ink(pugi::xml_node stop) {
    Ink ink;
    double opacity = 1;
    const auto set = [&](std::string_view name, std::string_view value) {
        if (name == "stop-color") {
            if (const auto read = read_colour(value)) ink = *read;
        } else if (name == "stop-opacity") {
            if (const auto read = read_share(value)) opacity = *read;
        }
    };
    for (const char* name : {"stop-color", "stop-opacity"}) set(name, trimmed(stop.attribute(name).value()));
    each_declaration(stop.attribute("style").value(), set);
    ink.alpha *= opacity;
    return ink;
}

struct StopMean {
    int stops = 0;
    bool uniform = true;
    Ink ink;
};

/// Of the gradient's own stops, or of those it refers to.
StopMean mean_of_stops(pugi::xml_node gradient, const PaintServers& servers) {
    constexpr int longest_chain = 32;  // gradients that refer to gradients; also ends a circle
    for (int hop = 0; hop < longest_chain && gradient; ++hop) {
        StopMean mean;
        double red = 0, green = 0, blue = 0, alpha = 0;
        std::optional<Ink> first;
        for (const auto stop : gradient.children()) {
            if (local_name(stop.name()) != "stop") continue;
            const auto ink = stop_ink(stop);
            if (!first) first = ink;
            if (!(ink.colour == first->colour && ink.alpha == first->alpha)) mean.uniform = false;
            ++mean.stops;
            red += ink.alpha * ink.colour.r;
            green += ink.alpha * ink.colour.g;
            blue += ink.alpha * ink.colour.b;
            alpha += ink.alpha;
        }
        if (mean.stops > 0) {
            const auto channel = [&](double sum) {
                return static_cast<unsigned char>(alpha > 0 ? sum / alpha + 0.5 : 0);
            };
            mean.ink = mean.uniform ? *first
                                    : Ink{{channel(red), channel(green), channel(blue)}, alpha / mean.stops};
            return mean;
        }
        const auto reference = reference_of(gradient);
        const auto next =
            reference.starts_with('#') ? servers.by_id.find(reference.substr(1)) : servers.by_id.end();
        gradient = next == servers.by_id.end() ? pugi::xml_node{} : next->second;
    }
    return {};
}

}  // namespace

std::optional<Brush> served_paint(std::string_view id, pugi::xml_node user, StyleContext& context) {
    auto& servers = context.servers;
    if (!servers.indexed) index_ids(servers, context.notes.markup.tree);
    const auto server = servers.by_id.find(id);
    if (server == servers.by_id.end()) return std::nullopt;
    const auto node = server->second;
    const auto name = local_name(node.name());
    auto& notes = context.notes;
    if (name == "pattern" || name == "hatch") {
        note(notes, "a pattern: drawn as black ink", user);
        return Brush{Brush::Kind::ink, {}};
    }
    if (name == "solidColor" || name == "solidcolor") return Brush{Brush::Kind::ink, {}};
    if (!is_gradient(node)) return std::nullopt;
    auto known = servers.resolved.find(server->first);
    if (known == servers.resolved.end()) {
        const auto mean = mean_of_stops(node, servers);
        Brush brush;  // without stops a gradient paints nothing (SVG 2, 14.2.4)
        if (mean.stops > 0) brush = {Brush::Kind::ink, mean.ink};
        known = servers.resolved.emplace(server->first, Served{brush, mean.uniform}).first;
    }
    if (!known->second.uniform) note(notes, "a gradient: drawn as one ink, the mean of its stops", user);
    return known->second.brush;
}

}  // namespace strandline::svg
