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

/// Of the gradient's own stops; none: nothing.
std::optional<Served> mean_of_stops(pugi::xml_node gradient) {
    int stops = 0;
    double red = 0, green = 0, blue = 0, alpha = 0;
    bool uniform = true;
    Ink first;
    for (const auto stop : gradient.children()) {
        if (local_name(stop.name()) != "stop") continue;
        const auto ink = stop_ink(stop);
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
    return Served{{Brush::Kind::ink, mean}, uniform};
}

/// Of the gradient, or of the one whose stops it takes over. Every gradient's stops are read once, however
/// many refer to it.
Served served_gradient(std::string_view id, PaintServers& servers) {
    constexpr std::size_t longest_chain = 32;  // gradients that refer to gradients; also ends a circle
    std::vector<std::string_view> chain;
    Served served;  // without stops a gradient paints nothing (SVG 2, 14.2.4)
    while (chain.size() < longest_chain) {
        const auto node = servers.by_id.find(id);
        if (node == servers.by_id.end() || !is_gradient(node->second)) break;
        if (const auto known = servers.resolved.find(id); known != servers.resolved.end()) {
            served = known->second;
            break;
        }
        chain.push_back(node->first);
        if (const auto own = mean_of_stops(node->second)) {
            served = *own;
            break;
        }
        const auto reference = reference_of(node->second);
        if (!reference.starts_with('#')) break;
        id = reference.substr(1);
    }
    for (const auto member : chain) servers.resolved.insert_or_assign(member, served);
    return served;
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
    if (!is_gradient(node)) return std::nullopt;
    const auto served = served_gradient(server->first, servers);
    if (!served.uniform) note(notes, "a gradient: drawn as one ink, the mean of its stops", user);
    return served.brush;
}

}  // namespace strandline::svg
