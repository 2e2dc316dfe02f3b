// Elements that hold or name others: layers, nested <svg>, <symbol>, <switch>, <use>.
#include <fmt/format.h>

#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

/// Illustrator writes what an id may not hold as _xHH_: "Layer_x20_1".
std::string plain_name(std::string_view id) {
    std::string name;
    const auto digit = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    for (std::size_t i = 0; i < id.size(); ++i) {
        const bool escape = id.substr(i).starts_with("_x") && i + 4 < id.size() && id[i + 4] == '_' &&
                            digit(id[i + 2]) >= 2 && digit(id[i + 2]) < 8 && digit(id[i + 3]) >= 0;
        name += escape ? static_cast<char>(16 * digit(id[i + 2]) + digit(id[i + 3])) : id[i];
        if (escape) i += 4;
    }
    return name;
}

/// The name that the drawing program shows for a group.
std::string shown_name(pugi::xml_node node) {
    for (const char* attribute : {"inkscape:label", "data-name", "serif:id"})
        if (const std::string_view name = node.attribute(attribute).value(); !name.empty())
            return std::string(name);
    return plain_name(node.attribute("id").value());
}

/// What can be drawn through a reference.
bool draws(Kind kind) { return kind != Kind::unknown && kind != Kind::silent && kind != Kind::left_out; }

}  // namespace

void enter_layer(Walk& walk, pugi::xml_node node, Surroundings& around) {
    if (around.instance || walk.collected.purpose != Purpose::shapes) return;
    const bool marked = std::string_view(node.attribute("inkscape:groupmode").value()) == "layer";
    if (walk.has_layers ? !marked : around.grouped) return;
    const auto name = shown_name(node);
    if (name.empty()) return;
    constexpr std::size_t longest = 300;  // every shape holds its copy
    const auto& paths = walk.layer_paths;
    const auto outer = around.layer < 0 ? "" : paths[static_cast<std::size_t>(around.layer)] + "/";
    around.grouped = true;
    walk.document.layers.push_back(
        {clipped(name, longest), well_formed(node.attribute("id").value()), around.layer, marked});
    around.layer = static_cast<int>(paths.size());
    walk.layer_paths.push_back(marked ? clipped(outer + name, longest) : std::string());
}

bool enter_nested_svg(Walk& walk, pugi::xml_node node, Surroundings& around) {
    const Point low{length_of(walk, node, "x", Axis::x, around).value_or(0),
                    length_of(walk, node, "y", Axis::y, around).value_or(0)};
    const auto side = [&](const char* name, Axis axis, std::optional<double> of_use, double all) {
        return of_use ? *of_use : length_of(walk, node, name, axis, around).value_or(all);
    };
    const double width = side("width", Axis::x, around.use_width, around.viewport.width);
    const double height = side("height", Axis::y, around.use_height, around.viewport.height);
    around.use_width = around.use_height = std::nullopt;
    if (width <= 0 || height <= 0) {
        note(walk.notes, "a nested <svg> without extent: draws nothing", node);
        return false;
    }
    const Box port{low, low + Point{width, height}};
    const auto view = view_box_of(node, walk.notes);
    if (!view) {
        if (!walk.error) walk.error = view.error();
        return false;
    }
    if (!around.style.overflows.value_or(false)) clip_to(walk, around, port);
    const auto size = *view ? Point{(*view)->width(), (*view)->height()} : Point{width, height};
    around.viewport = {size.x, size.y, around.viewport.dpi};
    const Affine inner = *view ? view_box_map(**view, port, node.attribute("preserveAspectRatio").value())
                               : Affine{1, 0, 0, 1, low.x, low.y};
    around.map = composed(around.map, inner);
    return true;
}

void walk_choice(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth) {
    for (const auto child : node.children()) {
        if (child.type() != pugi::node_element || !is_svg_element(child.name(), around)) continue;
        const auto kind = kind_named(local_name(child.name())).kind;
        if (kind == Kind::unknown || kind == Kind::silent || kind == Kind::symbol) continue;
        if (local_name(child.name()) == "foreignObject") continue;
        if (const auto needed = child.attribute("requiredExtensions");
            needed && !trimmed(needed.value()).empty())
            continue;
        const auto language = child.attribute("systemLanguage");
        if (language && std::string_view(language.value()).find("en") == std::string_view::npos) continue;
        note(walk.notes, "<switch>: its first fitting child is drawn, the others are left out", node);
        return walk_element(walk, child, around, depth + 1);
    }
    note(walk.notes, "<switch>: none of its children can be drawn", node);
}

void walk_use(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth) {
    const auto reference = href_of(node);
    if (!reference.starts_with('#'))
        return note(walk.notes, "<use> of another file: left out", node, reference);
    const auto target = element_of(walk.references, reference.substr(1));
    if (!target) return note(walk.notes, "<use> of what is not in the file: draws nothing", node, reference);
    const auto kind = kind_named(local_name(target.name())).kind;
    if (!draws(kind))
        return note(walk.notes, "<use> of an element that draws nothing by itself", node, target.name());

    Surroundings inner = around;
    const Point shift{length_of(walk, node, "x", Axis::x, around).value_or(0),
                      length_of(walk, node, "y", Axis::y, around).value_or(0)};
    inner.map = composed(inner.map, {1, 0, 0, 1, shift.x, shift.y});
    if (kind == Kind::symbol || kind == Kind::nested_svg) {
        inner.use_width = length_of(walk, node, "width", Axis::x, around);
        inner.use_height = length_of(walk, node, "height", Axis::y, around);
    }
    if (node != around.instance) {
        std::string id = well_formed(node.attribute("id").value());
        const auto [line, column] = spot_of(walk.markup, node);
        if (id.empty()) id = fmt::format("use@{}:{}", line, column);
        inner.instance_id = around.instance_id.empty() ? id : around.instance_id + "/" + id;
    }
    inner.instance = target;
    if (walk.over()) return;
    through_reference(walk, target, node, [&] { walk_element(walk, target, inner, depth + 1); });
}

}  // namespace strandline::svg
