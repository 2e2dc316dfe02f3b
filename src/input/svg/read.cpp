// The walk: from the XML tree to shapes in painting order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "input/svg/elements.hpp"
#include "input/svg/frame.hpp"
#include "input/svg/markup.hpp"
#include "input/svg/notes.hpp"
#include "input/svg/outline.hpp"
#include "input/svg/style.hpp"
#include "input/svg/svg.hpp"

namespace strandline::svg {

namespace {

/// What an element takes over from those around it.
struct Surroundings {
    Style style;
    Affine map;  ///< to the root's user units
    std::string layer;
    Viewport viewport;
    bool percent_known = false;
    bool bare_is_svg = true;  ///< names without prefix are SVG's
    std::string svg_prefix;   ///< a prefix that means SVG
};

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

bool is_svg_element(std::string_view name, const Surroundings& around) {
    const auto colon = name.rfind(':');
    if (colon == std::string_view::npos) return around.bare_is_svg;
    const auto prefix = name.substr(0, colon);
    return prefix == around.svg_prefix || prefix == "svg";
}

bool within_range(Point p) { return std::abs(p.x) <= largest_number && std::abs(p.y) <= largest_number; }
bool within_range(const Path& path) {
    struct Check {
        bool operator()(const LineSegment& s) const { return within_range(s.to); }
        bool operator()(const CubicSegment& s) const {
            return within_range(s.control1) && within_range(s.control2) && within_range(s.to);
        }
        bool operator()(const ArcSegment& s) const {
            return within_range(s.center) && within_range(s.u) && within_range(s.v) && within_range(s.to);
        }
    };
    return within_range(path.start) &&
           std::ranges::all_of(path.segments, [](const Segment& s) { return std::visit(Check{}, s); });
}

std::optional<Paint> paint_of(const Brush& brush, double opacity, const Style& style) {
    if (brush.kind == Brush::Kind::none) return std::nullopt;
    const bool current = brush.kind == Brush::Kind::current;
    const double total = opacity * style.group_opacity * (current ? 1 : brush.ink.alpha);
    if (total <= 0) return std::nullopt;
    return Paint{current ? style.color : brush.ink.colour, total};
}

struct Walk {
    const Markup& markup;
    const Limits& limits;
    const Progress& progress;
    Notes notes;
    PaintServers servers;
    Document document;
    Frame frame;
    std::optional<Error> error;
    bool stopped = false;
    std::size_t elements = 0, segments = 0;
    std::unordered_set<std::string> ids;

    bool over() const { return error || stopped; }

    void refuse(pugi::xml_node node, std::string reason, std::string remedy = "mend the file") {
        if (!error) error = Error{place_of(markup, node), std::move(reason), std::move(remedy)};
    }
    void refuse_number(pugi::xml_node node, std::string_view what) {
        refuse(node, fmt::format("{} is not finite or beyond {:g}", what, largest_number));
    }

    // ---- attributes
    // --------------------------------------------------------------------------------------------

    /// A length attribute; nothing when it is absent or not understood (noted).
    std::optional<double> length(pugi::xml_node node, const char* name, Axis axis,
                                 const Surroundings& around) {
        const auto attribute = node.attribute(name);
        if (!attribute) return std::nullopt;
        const auto text = trimmed(attribute.value());
        const auto read = read_length(text, axis, around.viewport, around.style.font_size);
        if (read.state == ValueState::refused) refuse_number(node, name);
        if (read.percent && !around.percent_known)
            note(notes, "a percentage of a page without size: 300 x 150 taken", node);
        if (read.state == ValueState::good) return read.value;
        if (text != "auto")
            note(notes, "a length that is not understood: passed over", node,
                 fmt::format("{}=\"{}\"", name, text));
        return std::nullopt;
    }
    double length_or_zero(pugi::xml_node node, const char* name, Axis axis, const Surroundings& around) {
        return length(node, name, axis, around).value_or(0);
    }

    Affine transform_of(pugi::xml_node node) {
        const std::string_view css = node.attribute("style").value();
        std::string text(trimmed(node.attribute("transform").value()));
        if (css.find("transform") != std::string_view::npos)
            each_declaration(css, [&](const std::string& name, std::string_view value) {
                if (name == "transform") text = value;
                if (name == "transform-origin")
                    note(notes, "transform-origin is not supported yet: passed over", node);
            });
        if (node.attribute("transform-origin"))
            note(notes, "transform-origin is not supported yet: passed over", node);
        const auto read = read_transform(text);
        if (read.state == ValueState::refused) refuse_number(node, "transform");
        if (read.state == ValueState::malformed)
            note(notes, "a transform that is not understood: passed over", node, text);
        return read.state == ValueState::good ? read.map : Affine{};
    }

    // ---- shapes
    // ------------------------------------------------------------------------------------------------

    Outline one(Path path) const {
        Outline outline;
        outline.segments = path.segments.size();
        outline.subpaths.push_back(std::move(path));
        return outline;
    }

    /// rx and ry; one that is absent or negative is as the other (SVG 2, 10.2 and 10.4), both: 0.
    std::pair<double, double> radii(pugi::xml_node node, const Surroundings& around) {
        constexpr double absent = -1;
        const double rx = length(node, "rx", Axis::x, around).value_or(absent);
        const double ry = length(node, "ry", Axis::y, around).value_or(absent);
        return {std::max(0.0, rx < 0 ? ry : rx), std::max(0.0, ry < 0 ? rx : ry)};
    }

    Outline rect_outline(pugi::xml_node node, const Surroundings& around) {
        const double x = length_or_zero(node, "x", Axis::x, around),
                     y = length_or_zero(node, "y", Axis::y, around);
        const double width = length_or_zero(node, "width", Axis::x, around);
        const double height = length_or_zero(node, "height", Axis::y, around);
        if (width <= 0 || height <= 0) return {};
        const auto [rx, ry] = radii(node, around);
        return one(rectangle(x, y, width, height, std::min(rx, width / 2), std::min(ry, height / 2)));
    }

    Outline ellipse_outline(pugi::xml_node node, const Surroundings& around, bool circle) {
        const Point center{length_or_zero(node, "cx", Axis::x, around),
                           length_or_zero(node, "cy", Axis::y, around)};
        const double r = circle ? length_or_zero(node, "r", Axis::diagonal, around) : 0;
        const auto [rx, ry] = circle ? std::pair{r, r} : radii(node, around);
        if (rx <= 0 || ry <= 0) return {};
        return one(svg::ellipse(center, rx, ry));
    }

    Outline outline_of(pugi::xml_node node, Kind kind, const Surroundings& around) {
        const std::size_t room = limits.segments - segments;
        switch (kind) {
            case Kind::path:
                return read_path(node.attribute("d").value(), room);
            case Kind::rect:
                return rect_outline(node, around);
            case Kind::circle:
                return ellipse_outline(node, around, true);
            case Kind::ellipse:
                return ellipse_outline(node, around, false);
            case Kind::line: {
                const Point from{length_or_zero(node, "x1", Axis::x, around),
                                 length_or_zero(node, "y1", Axis::y, around)};
                const Point to{length_or_zero(node, "x2", Axis::x, around),
                               length_or_zero(node, "y2", Axis::y, around)};
                return one(Path{from, {LineSegment{to}}, false});
            }
            default:
                return read_points(node.attribute("points").value(), kind == Kind::polygon, room);
        }
    }

    /// Unique, because edits name elements by it.
    std::string id_of(pugi::xml_node node, Spot spot) {
        std::string id = well_formed(node.attribute("id").value());
        if (id.empty() || ids.contains(id))
            id = fmt::format("{}@{}:{}", id.empty() ? local_name(node.name()) : id, spot.line, spot.column);
        while (!ids.insert(id).second) id += '+';
        return id;
    }

    void add_shape(pugi::xml_node node, Kind kind, const Surroundings& around) {
        const auto& style = around.style;
        for (const auto child : node.children())
            if (const auto named = kind_named(local_name(child.name())); named.kind == Kind::left_out)
                note(notes, named.reason, child);
        if (!style.visible) return note(notes, "hidden (visibility): left out", node);
        Shape shape;
        if (kind != Kind::line)
            shape.fill = paint_of(style.fill, style.fill_opacity, style);  // a line bounds no area
        if (style.stroke_width > 0) shape.stroke = paint_of(style.stroke, style.stroke_opacity, style);
        if (!shape.fill && !shape.stroke)
            return note(notes, "neither filled nor stroked: draws nothing", node);
        if (determinant(around.map) == 0)
            return note(notes, "a transform that leaves no area: draws nothing", node);

        auto outline = outline_of(node, kind, around);
        if (outline.state == ValueState::refused) return refuse(node, outline.message);
        if (outline.over_limit || outline.segments > limits.segments - segments)
            return refuse(node, fmt::format("more than {} path segments in the file", limits.segments),
                          "simplify the drawing");
        if (error) return;
        segments += outline.segments;
        if (outline.state == ValueState::malformed)
            note(notes, "a faulty outline: kept up to its fault", node, outline.message);
        else if (outline.subpaths.empty())
            note(notes, "a shape without extent: draws nothing", node);
        if (outline.subpaths.empty()) return;

        for (const auto& path : outline.subpaths) {
            shape.subpaths.push_back(transformed(path, around.map));
            if (!within_range(shape.subpaths.back())) return refuse_number(node, "a coordinate");
        }
        shape.stroke_width =
            style.stroke_width * (style.scaling_stroke ? mean_scale(around.map) : 1 / frame.pixels_per_unit);
        if (!(shape.stroke_width <= largest_number)) return refuse_number(node, "stroke-width");
        const auto spot = spot_of(markup, node);
        shape.id = id_of(node, spot);
        shape.layer = around.layer;
        shape.place = place_of(markup, node);
        shape.line = spot.line;
        shape.fill_rule = style.fill_rule;
        shape.cap = style.cap;
        shape.join = style.join;
        document.shapes.push_back(std::move(shape));
    }

    // ---- containers
    // --------------------------------------------------------------------------------------------

    void enter_layer(pugi::xml_node node, Surroundings& around) const {
        if (std::string_view(node.attribute("inkscape:groupmode").value()) != "layer") return;
        std::string_view name = node.attribute("inkscape:label").value();
        if (name.empty()) name = node.attribute("id").value();
        if (name.empty()) return;
        constexpr std::size_t longest = 300;  // every shape holds its copy
        if (!around.layer.empty()) around.layer += '/';
        around.layer = clipped(around.layer + std::string(name), longest);
    }

    /// False when nothing of it can be seen.
    bool enter_nested_svg(pugi::xml_node node, Surroundings& around) {
        const Point low{length_or_zero(node, "x", Axis::x, around),
                        length_or_zero(node, "y", Axis::y, around)};
        const double width = length(node, "width", Axis::x, around).value_or(around.viewport.width);
        const double height = length(node, "height", Axis::y, around).value_or(around.viewport.height);
        if (width <= 0 || height <= 0) {
            note(notes, "a nested <svg> without extent: draws nothing", node);
            return false;
        }
        const Box port{low, low + Point{width, height}};
        const auto view = view_box_of(node, notes);
        if (!view) {
            if (!error) error = view.error();
            return false;
        }
        if (std::string_view(node.attribute("overflow").value()) != "visible")
            note(notes, "what reaches beyond a nested <svg> is not cut off", node);
        around.viewport = *view ? Viewport{(*view)->width(), (*view)->height()} : Viewport{width, height};
        const Affine inner = *view ? view_box_map(**view, port, node.attribute("preserveAspectRatio").value())
                                   : Affine{1, 0, 0, 1, low.x, low.y};
        around.map = composed(around.map, inner);
        return true;
    }

    void walk_choice(pugi::xml_node node, const Surroundings& around, int depth) {
        for (const auto child : node.children()) {
            if (child.type() != pugi::node_element || !is_svg_element(child.name(), around)) continue;
            const auto kind = kind_named(local_name(child.name())).kind;
            if (kind == Kind::unknown || kind == Kind::silent) continue;
            if (local_name(child.name()) == "foreignObject") continue;
            if (const auto needed = child.attribute("requiredExtensions");
                needed && !trimmed(needed.value()).empty())
                continue;
            const auto language = child.attribute("systemLanguage");
            if (language && std::string_view(language.value()).find("en") == std::string_view::npos) continue;
            note(notes, "<switch>: its first fitting child is drawn, the others are left out", node);
            return walk(child, around, depth + 1);
        }
        note(notes, "<switch>: none of its children can be drawn", node);
    }

    void walk_children(pugi::xml_node node, const Surroundings& around, int depth) {
        for (const auto child : node.children()) {
            if (over()) return;
            if (child.type() == pugi::node_element) walk(child, around, depth + 1);
        }
    }

    void count(pugi::xml_node node) {
        constexpr std::size_t between_reports = 1024;
        if (++elements > limits.elements)
            return refuse(node, fmt::format("more than {} elements in the file", limits.elements),
                          "simplify the drawing");
        if (elements % between_reports != 1) return;
        progress.report("reading the drawing",
                        static_cast<double>(node.offset_debug()) / static_cast<double>(markup.text.size()));
        if (progress.stopped()) {
            stopped = true;
            note(notes, "stopped here: the rest of the file is left out", node);
        }
    }

    void walk(pugi::xml_node node, const Surroundings& outside, int depth) {
        if (depth > limits.depth)
            return refuse(node, fmt::format("elements are nested deeper than {}", limits.depth),
                          "ungroup the drawing");
        count(node);
        if (over()) return;
        const bool root = depth == 1;
        Surroundings around = outside;
        follow_namespaces(node, around, root);
        if (!root && !is_svg_element(node.name(), around)) return;  // of another language: never drawn
        const auto named = root ? kind_named("svg") : kind_named(local_name(node.name()));
        if (named.kind == Kind::silent) return;
        if (named.kind == Kind::left_out) return note(notes, named.reason, node);
        if (named.kind == Kind::unknown)
            return note(notes, "an element that SVG does not know: left out", node, node.name());

        StyleContext context{notes, servers, outside.viewport, {}};
        around.style = resolved_style(node, outside.style, context);
        if (context.error && !error) error = context.error;
        if (!around.style.displayed) return note(notes, "hidden (display: none): left out", node);
        around.map = composed(around.map, transform_of(node));
        if (error) return;
        switch (named.kind) {
            case Kind::group:
                enter_layer(node, around);
                return walk_children(node, around, depth);
            case Kind::nested_svg:
                if (root || enter_nested_svg(node, around)) walk_children(node, around, depth);
                return;
            case Kind::choice:
                return walk_choice(node, around, depth);
            default:
                return add_shape(node, named.kind, around);
        }
    }
};

}  // namespace

Outcome<Document> read(std::string_view text, const Limits& limits, const Progress& progress) {
    const auto markup = parse_markup(text, limits);
    if (!markup) return tl::unexpected(markup.error());
    const auto root = (*markup)->tree.document_element();
    if (local_name(root.name()) != "svg")
        return fail(place_of(**markup, root), "the outermost element is not <svg>", "give an SVG file");
    Walk walk{**markup, limits, progress, {**markup, {}}, {}, {}, {}, {}, false, 0, 0, {}};
    auto frame = root_frame(root, walk.notes);
    if (!frame) return tl::unexpected(frame.error());
    walk.frame = *frame;

    Surroundings around;
    around.viewport = frame->viewport;
    around.percent_known = frame->percent_known;
    const std::string_view name = root.name();
    if (const auto colon = name.rfind(':'); colon != std::string_view::npos)
        around.svg_prefix = name.substr(0, colon);
    walk.walk(root, around, 1);
    if (walk.error) return tl::unexpected(*walk.error);

    auto& document = walk.document;
    document.size_metres = frame->size_metres;
    if (frame->view) {
        document.view = *frame->view;
    } else {
        for (const auto& shape : document.shapes)
            for (const auto& path : shape.subpaths) document.view = united(document.view, bounds(path));
    }
    if (const auto sizes = root.attribute("rake_sizes")) {
        auto values = number_list(sizes.value(), place_of(**markup, root), "rake_sizes");
        if (values)
            document.rake_sizes = std::move(*values);
        else
            note(walk.notes, "rake_sizes is not a list of numbers: passed over", root, sizes.value());
    }
    document.warnings = as_warnings(walk.notes);
    progress.report("reading the drawing", 1);
    return std::move(document);
}

}  // namespace strandline::svg
