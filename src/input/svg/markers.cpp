// Markers: arrow heads and the like at the vertices of a path (SVG 2, 13.7).
#include <fmt/format.h>

#include <cmath>

#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

/// A vertex with the directions in which the path comes and goes; zero where it does not.
struct Vertex {
    Point at, in, out;
};

/// The first of the points that is away from `from` gives the direction.
template <std::size_t N>
Point direction(Point from, const std::array<Point, N>& points) {
    for (const Point p : points)
        if (p != from) return normalized(p - from);
    return {};
}
Point leaving(Point from, const Segment& segment) {
    if (const auto* c = std::get_if<CubicSegment>(&segment))
        return direction(from, std::array{c->control1, c->control2, c->to});
    if (const auto* a = std::get_if<ArcSegment>(&segment))
        return normalized(a->sweep * (std::cos(a->start) * a->v - std::sin(a->start) * a->u));
    return direction(from, std::array{end_of(segment)});
}
Point arriving(Point from, const Segment& segment) {
    if (const auto* c = std::get_if<CubicSegment>(&segment))
        return -direction(c->to, std::array{c->control2, c->control1, from});
    if (const auto* a = std::get_if<ArcSegment>(&segment)) {
        const double end = a->start + a->sweep;
        return normalized(a->sweep * (std::cos(end) * a->v - std::sin(end) * a->u));
    }
    return -direction(end_of(segment), std::array{from});
}

std::vector<Vertex> vertices_of(const std::vector<Path>& outline) {
    std::vector<Vertex> all;
    for (const auto& path : outline) {
        const auto first = all.size();
        all.push_back({path.start, {}, {}});
        for (const auto& segment : path.segments) {
            const Point from = all.back().at;
            all.back().out = leaving(from, segment);
            all.push_back({end_of(segment), arriving(from, segment), {}});
        }
        if (path.closed && all.size() > first + 1) {  // both ends are one vertex, passed twice
            all[first].in = all.back().in;
            all.back().out = all[first].out;
        }
    }
    return all;
}

/// Half way between coming and going.
double heading_at(const Vertex& vertex) {
    const Point middle = normalized(vertex.in) + normalized(vertex.out);
    return length(middle) > 1e-9 ? heading(middle) : heading(length(vertex.in) > 0 ? vertex.in : vertex.out);
}

/// radians
double fixed_angle(std::string_view orient) {
    Scanner scanner{orient};
    const auto number = take_number(scanner);
    if (number.state != ValueState::good) return 0;
    const auto unit = scanner.text.substr(scanner.at);
    if (unit == "rad") return number.value;
    return number.value * (unit == "grad" ? pi / 200 : unit == "turn" ? 2 * pi : pi / 180);
}

/// Everything of a marker that is the same at all its vertices.
struct Marker {
    pugi::xml_node node;
    Surroundings around;  ///< of its content, but for the place
    Affine to_vertex;     ///< from its viewport's units to those of the shape, the vertex at (0, 0)
    Affine to_port;       ///< from its content's units to its viewport's
    Box port;
    std::string_view orient;
};

/// Nothing when it draws nothing.
std::optional<Marker> marker_of(Walk& walk, std::string_view id, pugi::xml_node user,
                                const Surroundings& shape) {
    const auto node = element_of(walk.references, id);
    if (local_name(node.name()) != "marker") {
        note(walk.notes, "a marker that is not in the file: left out", user, id);
        return std::nullopt;
    }
    Marker marker{node, shape, {}, {}, {}, trimmed(node.attribute("orient").value())};
    auto& around = marker.around;
    around.style = style_where_defined(walk, node, shape);
    const auto side = [&](const char* name, Axis axis, double absent) {
        return length_of(walk, node, name, axis, around).value_or(absent);
    };
    constexpr double usual_size = 3;
    const double width = side("markerWidth", Axis::x, usual_size),
                 height = side("markerHeight", Axis::y, usual_size);
    const auto view = view_box_of(node, walk.notes);
    if (!view && !walk.error) walk.error = view.error();
    if (walk.error || width <= 0 || height <= 0) return std::nullopt;
    marker.port = {{0, 0}, {width, height}};
    if (*view)
        marker.to_port = view_box_map(**view, marker.port, node.attribute("preserveAspectRatio").value());
    const Point ref = apply(marker.to_port, {side("refX", Axis::x, 0), side("refY", Axis::y, 0)});
    const bool by_width = std::string_view(node.attribute("markerUnits").value()) != "userSpaceOnUse";
    const double scale = by_width ? shape.style.stroke_width : 1;
    marker.to_vertex = {scale, 0, 0, scale, -scale * ref.x, -scale * ref.y};
    around.viewport = *view ? Viewport{(*view)->width(), (*view)->height(), shape.viewport.dpi}
                            : Viewport{width, height, shape.viewport.dpi};
    around.instance = node;
    around.context_fill = paint_of(shape.style.fill, shape.style.fill_opacity, shape);
    around.context_stroke = paint_of(shape.style.stroke, shape.style.stroke_opacity, shape);
    return marker;
}

void draw_marker(Walk& walk, const Marker& marker, const Vertex& vertex, bool start, const std::string& id,
                 int depth) {
    Surroundings around = marker.around;
    double angle = marker.orient.starts_with("auto") ? heading_at(vertex) : fixed_angle(marker.orient);
    if (start && marker.orient == "auto-start-reverse") angle += pi;
    const Point along = unit(angle);
    around.map = composed(around.map, {along.x, along.y, -along.y, along.x, vertex.at.x, vertex.at.y});
    around.map = composed(around.map, marker.to_vertex);
    if (!around.style.overflows.value_or(false)) clip_to(walk, around, marker.port);
    around.map = composed(around.map, marker.to_port);
    around.instance_id = id;
    walk_children(walk, marker.node, around, depth);
}

}  // namespace

void add_markers(Walk& walk, pugi::xml_node node, const std::vector<Path>& outline,
                 const Surroundings& around, int depth) {
    const auto& style = around.style;
    const auto vertices = vertices_of(outline);
    std::string shape_id =
        around.instance_id.empty() ? well_formed(node.attribute("id").value()) : around.instance_id;
    const auto [line, column] = spot_of(walk.markup, node);
    if (shape_id.empty()) shape_id = fmt::format("{}@{}:{}", local_name(node.name()), line, column);
    const auto draw = [&](std::string_view id, std::string_view name, std::size_t first, std::size_t last) {
        if (id.empty() || first >= last || walk.over()) return;
        const auto marker = marker_of(walk, id, node, around);
        if (!marker) return;
        through_reference(walk, marker->node, node, [&] {
            for (auto i = first; i < last && !walk.over(); ++i)
                draw_marker(walk, *marker, vertices[i], i == 0, fmt::format("{}/{}-{}", shape_id, name, i),
                            depth);
        });
    };
    draw(style.marker_start, "marker-start", 0, 1);
    draw(style.marker_mid, "marker-mid", 1, vertices.size() - 1);
    draw(style.marker_end, "marker-end", vertices.size() - 1, vertices.size());
}

}  // namespace strandline::svg
