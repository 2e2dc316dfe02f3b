// The walk: which elements draw, and what each takes over from those around it.
#include "input/svg/walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandline::svg {

namespace {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

/// Follows xmlns declarations. Files that declare nothing, or misspell it on the root, still count as SVG.
void follow_namespaces(pugi::xml_node node, Surroundings& around, bool root) {
    for (const auto attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        if (!name.starts_with("xmlns")) continue;
        const bool svg = trimmed(attribute.value()) == svg_namespace;
        if (name == "xmlns") {
            if (!root) around.bare_is_svg = svg;
        } else if (svg && name.size() > 6 && name[5] == ':') {
            around.svg_prefix = name.substr(6);
        }
    }
}

/// Adds data-strandline-* to what the groups around gave; the nearest one counts.
void enter_hints(pugi::xml_node node, Surroundings& around) {
    constexpr std::string_view prefix = "data-strandline-";
    std::vector<Hint> hints;
    for (const auto attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        if (name.starts_with(prefix) && name.size() > prefix.size())
            hints.push_back({well_formed(name.substr(prefix.size())), well_formed(attribute.value())});
    }
    if (hints.empty()) return;
    if (around.hints) hints.insert(hints.end(), around.hints->begin(), around.hints->end());
    std::ranges::stable_sort(hints, {}, &Hint::name);
    const auto doubled = std::ranges::unique(hints, {}, &Hint::name);
    hints.erase(doubled.begin(), doubled.end());
    around.hints = std::make_shared<const std::vector<Hint>>(std::move(hints));
}

/// SVG 2, 8.5: the point that stays where it is; lengths, percentages of the view box, or words.
std::optional<Point> read_origin(std::string_view text, const Surroundings& around) {
    Point origin;
    if (text.empty()) return origin;
    const auto end = std::min(text.find_first_of(" \t\n\r,"), text.size());
    std::array<std::string_view, 2> words{text.substr(0, end), trimmed(text.substr(end))};
    if (words[0] == "top" || words[0] == "bottom" || words[1] == "left" || words[1] == "right")
        std::swap(words[0], words[1]);
    for (const bool vertical : {false, true}) {
        const auto word = words[vertical ? 1 : 0];
        const std::string_view share = word.empty() || word == "center"      ? "50%"
                                       : word == "left" || word == "top"     ? "0%"
                                       : word == "right" || word == "bottom" ? "100%"
                                                                             : word;
        const auto length =
            read_length(share, vertical ? Axis::y : Axis::x, around.viewport, around.style.font_size);
        if (length.state != ValueState::good) return std::nullopt;
        (vertical ? origin.y : origin.x) = length.value;
    }
    return origin;
}

Affine transform_of(Walk& walk, pugi::xml_node node, const Surroundings& around) {
    const auto text = around.style.transform;
    if (text.empty()) return {};
    const auto read = read_transform(text);
    if (read.state == ValueState::refused) walk.refuse_number(node, "transform");
    if (read.state == ValueState::malformed)
        note(walk.notes, "a transform that is not understood: passed over", node, text);
    if (read.state != ValueState::good) return {};
    const auto origin = read_origin(around.style.transform_origin, around);
    if (!origin) {
        note(walk.notes, "a transform-origin that is not understood: passed over", node,
             around.style.transform_origin);
        return read.map;
    }
    const auto& [x, y] = *origin;
    return composed({1, 0, 0, 1, x, y}, composed(read.map, {1, 0, 0, 1, -x, -y}));
}

/// False when the walk must end here.
bool counted(Walk& walk, pugi::xml_node node, int depth) {
    const auto& limits = walk.options.limits;
    if (depth > limits.depth) {
        walk.refuse(node, fmt::format("elements are nested deeper than {}", limits.depth),
                    "ungroup the drawing");
        return false;
    }
    const bool again = !walk.active.empty() || walk.collected.purpose != Purpose::shapes;
    if (again && ++walk.expanded > limits.expanded)
        walk.refuse(
            node,
            fmt::format("more than {} elements are drawn through <use>, markers and clips", limits.expanded),
            "simplify the drawing");
    if (!again && ++walk.elements > limits.elements)
        walk.refuse(node, fmt::format("more than {} elements in the file", limits.elements),
                    "simplify the drawing");
    constexpr std::size_t between_reports = 1024;
    if ((walk.elements + walk.expanded) % between_reports == 1) {
        walk.progress.report("reading the drawing", static_cast<double>(node.offset_debug()) /
                                                        static_cast<double>(walk.markup.text.size()));
        if (walk.progress.stopped()) {
            walk.stopped = true;
            note(walk.notes, "stopped here: the rest of the file is left out", node);
        }
    }
    return !walk.over();
}

}  // namespace

void Walk::refuse_number(pugi::xml_node node, std::string_view what) {
    refuse(node, fmt::format("{} is not finite or beyond {:g}", what, largest_number));
}

bool is_svg_element(std::string_view name, const Surroundings& around) {
    const auto colon = name.rfind(':');
    if (colon == std::string_view::npos) return around.bare_is_svg;
    const auto prefix = name.substr(0, colon);
    return prefix == around.svg_prefix || prefix == "svg";
}

std::optional<double> length_of(Walk& walk, pugi::xml_node node, const char* name, Axis axis,
                                const Surroundings& around) {
    const auto attribute = node.attribute(name);
    if (!attribute) return std::nullopt;
    const auto text = trimmed(attribute.value());
    const auto read = read_length(text, axis, around.viewport, around.style.font_size);
    if (read.state == ValueState::refused) walk.refuse_number(node, name);
    if (read.percent && !around.percent_known)
        note(walk.notes, "a percentage of a page without size: 300 x 150 taken", node);
    if (read.state == ValueState::good) return read.value;
    if (text != "auto")
        note(walk.notes, "a length that is not understood: passed over", node,
             fmt::format("{}=\"{}\"", name, text));
    return std::nullopt;
}

Style style_where_defined(Walk& walk, pugi::xml_node node, const Surroundings& user) {
    std::vector<pugi::xml_node> chain;
    for (auto at = node; at.type() == pugi::node_element; at = at.parent()) chain.push_back(at);
    Style style;
    auto context = walk.style_context(user.viewport);
    walk.sheet.steps += chain.size();
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) style = resolved_style(*at, style, context);
    if (context.error && !walk.error) walk.error = context.error;
    style.group_opacity = user.style.group_opacity;
    return style;
}

void walk_children(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth) {
    for (const auto child : node.children()) {
        if (walk.over()) return;
        if (child.type() == pugi::node_element) walk_element(walk, child, around, depth + 1);
    }
}

void walk_content(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around, int depth) {
    if (walk.collected.purpose == Purpose::outlines &&
        (kind == Kind::group || kind == Kind::nested_svg || kind == Kind::symbol || kind == Kind::choice))
        return note(walk.notes, "a group in a clipPath: passed over", node);
    Surroundings inner = around;
    inner.use_width = inner.use_height = std::nullopt;
    switch (kind) {
        case Kind::group:
            enter_layer(walk, node, inner);
            return walk_children(walk, node, inner, depth);
        case Kind::nested_svg:
        case Kind::symbol:
            inner.use_width = around.use_width;
            inner.use_height = around.use_height;
            if (node == walk.markup.tree.document_element() || enter_nested_svg(walk, node, inner))
                walk_children(walk, node, inner, depth);
            return;
        case Kind::choice:
            return walk_choice(walk, node, inner, depth);
        case Kind::use:
            return walk_use(walk, node, inner, depth);
        case Kind::text:
            return add_text(walk, node, inner, depth);
        default:
            return add_shape(walk, node, kind, inner, depth);
    }
}

void walk_element(Walk& walk, pugi::xml_node node, const Surroundings& outside, int depth) {
    if (!counted(walk, node, depth)) return;
    const bool root = depth == 1, target = node == outside.instance;
    Surroundings around = outside;
    follow_namespaces(node, around, root);
    if (!root && !is_svg_element(node.name(), around)) return;  // of another language: never drawn
    const auto named = root ? kind_named("svg") : kind_named(local_name(node.name()));
    if (named.kind == Kind::silent || (named.kind == Kind::symbol && !target)) return;
    if (named.kind == Kind::left_out) {
        walk.collected.unclear = true;
        return note(walk.notes, named.reason, node);
    }
    if (named.kind == Kind::unknown)
        return note(walk.notes, "an element that SVG does not know: left out", node, node.name());

    auto context = walk.style_context(outside.viewport);
    around.style = resolved_style(node, outside.style, context);
    if (context.error && !walk.error) walk.error = context.error;
    if (walk.sheet.steps > walk.sheet.most_steps)
        walk.refuse(node, "style sheets and elements are too many for each other",
                    "simplify the style sheets");
    if (!around.style.displayed) {
        if (walk.collected.purpose == Purpose::shapes)
            note(walk.notes, "hidden (display: none): left out", node);
        return;
    }
    enter_hints(node, around);
    around.map = composed(around.map, transform_of(walk, node, around));
    if (walk.error || !enter_clip(walk, node, named.kind, around, depth)) return;
    walk_content(walk, node, named.kind, around, depth);
}

}  // namespace strandline::svg
