// Elements that draw: their outlines, and what paint, dashes and clips make of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/svg/dashes.hpp"
#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

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

std::size_t count_segments(const std::vector<Path>& paths) {
    std::size_t count = 0;
    for (const auto& path : paths) count += path.segments.size();
    return count;
}

/// Counts them; false when they are too many.
bool room_for(Walk& walk, pugi::xml_node node, std::size_t segments) {
    const auto most = walk.options.limits.segments;
    if (segments > most - walk.segments) {
        walk.refuse(node, fmt::format("more than {} path segments in the file", most),
                    "simplify the drawing");
        return false;
    }
    walk.segments += segments;
    return true;
}

Outline one(Path path) {
    Outline outline;
    outline.segments = path.segments.size();
    outline.subpaths.push_back(std::move(path));
    return outline;
}

/// rx and ry; one that is absent or negative is as the other (SVG 2, 10.2 and 10.4), both: 0.
std::pair<double, double> radii(Walk& walk, pugi::xml_node node, const Surroundings& around) {
    constexpr double absent = -1;
    const double rx = length_of(walk, node, "rx", Axis::x, around).value_or(absent);
    const double ry = length_of(walk, node, "ry", Axis::y, around).value_or(absent);
    return {std::max(0.0, rx < 0 ? ry : rx), std::max(0.0, ry < 0 ? rx : ry)};
}

/// Unique, because edits name elements by it. `part` tells pieces of one element apart.
std::string id_of(Walk& walk, pugi::xml_node node, Spot spot, const Surroundings& around,
                  std::string_view part) {
    std::string id = well_formed(node.attribute("id").value());
    const auto nameless = [&] {
        return fmt::format("{}@{}:{}", local_name(node.name()), spot.line, spot.column);
    };
    if (!around.instance_id.empty())
        id = node == around.instance ? around.instance_id
                                     : around.instance_id + "/" + (id.empty() ? nameless() : id);
    if (id.empty()) id = nameless();
    id += part;
    if (walk.ids.contains(id)) id += fmt::format("@{}:{}", spot.line, spot.column);
    while (!walk.ids.insert(id).second) id += '+';
    return id;
}

/// The dashes of a stroke in the root's units; nothing where it is solid.
std::optional<std::vector<Path>> dashes_of(Walk& walk, pugi::xml_node node, const std::vector<Path>& own,
                                           const std::vector<Path>& mapped, const Surroundings& around) {
    const auto& style = around.style;
    if (!style.dashes) return std::nullopt;
    // A stroke that does not scale is laid on the page: its dashes too.
    const auto& source = style.scaling_stroke ? own : mapped;
    double unit = style.scaling_stroke ? 1 : 1 / walk.frame.pixels_per_unit;
    if (const auto attribute = node.attribute("pathLength")) {
        Scanner scanner{trimmed(attribute.value())};
        const auto stated = take_number(scanner);
        double whole = 0;
        for (const auto& path : own) whole += length(path);
        if (stated.state == ValueState::good && stated.value > 0) unit *= whole / stated.value;
    }
    DashPattern pattern{*style.dashes, style.dash_offset * unit, style.cap != LineCap::butt};
    double sum = 0;
    for (double& length : pattern.lengths) sum += (length *= unit);
    constexpr std::size_t most = 100'000;  // of one subpath; nobody rakes more
    std::vector<Path> all;
    if (!(sum > 0) || !std::isfinite(sum)) return std::nullopt;
    for (const auto& path : source) {
        auto some = dashed(path, pattern, most);
        if (!some || !room_for(walk, node, some ? count_segments(*some) : 0)) {
            note(walk.notes, "dashes too fine to be drawn one by one: drawn solid", node);
            return std::nullopt;
        }
        for (auto& dash : *some)
            all.push_back(style.scaling_stroke ? transformed(dash, around.map) : std::move(dash));
    }
    return all;
}

strandline::FillRule region_rule(FillRule rule) {
    return rule == FillRule::even_odd ? strandline::FillRule::even_odd : strandline::FillRule::nonzero;
}

/// Cuts subpaths (the fill) and lines (the stroke, where it does not follow the subpaths) to the clip; paint
/// that has nothing left is taken off.
void cut(Shape& shape, std::optional<std::vector<Path>>& lines, const std::shared_ptr<Clip>& limit) {
    Clip& clip = *limit;
    const auto& stroked = lines ? *lines : shape.subpaths;
    Box box = bounds_of(shape.subpaths);
    if (lines) box = united(box, bounds_of(*lines));
    if (shape.stroke) box = grown(box, shape.stroke_width / 2);
    const auto cover = clip.index.cover_of(box);
    if (cover == AreaIndex::Cover::inside) return;
    if (shape.stroke) {
        auto left = clipped_lines(stroked, clip);
        if (left.empty())
            shape.stroke.reset();
        else
            shape.stroke_clip = std::shared_ptr<const Regions>(limit, &limit->regions);
        if (left != stroked) lines = std::move(left);
    }
    if (shape.fill && clip.index.cover_of(bounds_of(shape.subpaths)) != AreaIndex::Cover::inside) {
        auto left = clipped_area(shape.subpaths, region_rule(shape.fill_rule), clip);
        if (shape.stroke && !lines) lines = shape.subpaths;
        shape.subpaths = std::move(left);
        shape.fill_rule = FillRule::nonzero;
        if (shape.subpaths.empty()) shape.fill.reset();
    }
}

bool has_markers(Kind kind, const Style& style) {
    return (kind == Kind::path || kind == Kind::line || kind == Kind::polyline || kind == Kind::polygon) &&
           !(style.marker_start.empty() && style.marker_mid.empty() && style.marker_end.empty());
}

void add_painted(Walk& walk, pugi::xml_node node, const std::vector<Path>& outline, std::vector<Path> mapped,
                 Shape shape, const Surroundings& around) {
    const auto& style = around.style;
    shape.stroke_width =
        style.stroke_width * (style.scaling_stroke ? mean_scale(around.map) : 1 / walk.frame.pixels_per_unit);
    if (!(shape.stroke_width <= largest_number)) return walk.refuse_number(node, "stroke-width");
    shape.fill_rule = style.fill_rule;
    shape.subpaths = std::move(mapped);
    auto lines = shape.stroke ? dashes_of(walk, node, outline, shape.subpaths, around) : std::nullopt;
    if (walk.error) return;
    if (lines && lines->empty()) shape.stroke.reset();
    if (around.clip) cut(shape, lines, around.clip);
    if (!shape.fill && !shape.stroke)
        return note(walk.notes,
                    "wholly outside its clip or mask, or in the gaps of its dashes: draws nothing", node);
    if (!shape.fill && lines)
        shape.subpaths = std::move(*lines);
    else if (shape.stroke)
        shape.lines = std::move(lines);
    const auto spot = spot_of(walk.markup, node);
    if (around.layer >= 0) {
        shape.layer_index = around.layer;
        shape.layer = walk.layer_paths[static_cast<std::size_t>(around.layer)];
    }
    shape.place = place_of(walk.markup, node);
    shape.line = spot.line;
    shape.cap = style.cap;
    shape.join = style.join;
    if (around.hints) shape.hints = *around.hints;
    walk.document.shapes.push_back(std::move(shape));
}

}  // namespace

std::optional<Paint> paint_of(const Brush& brush, double opacity, const Surroundings& around) {
    switch (brush.kind) {
        case Brush::Kind::none:
            return std::nullopt;
        case Brush::Kind::context_fill:
            return around.context_fill;
        case Brush::Kind::context_stroke:
            return around.context_stroke;
        case Brush::Kind::current:
        case Brush::Kind::ink:
            break;
    }
    const bool current = brush.kind == Brush::Kind::current;
    const double total = opacity * around.style.group_opacity * (current ? 1 : brush.ink.alpha);
    if (total <= 0) return std::nullopt;
    return Paint{current ? around.style.color : brush.ink.colour, total};
}

Outline outline_of(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around) {
    const std::size_t room = walk.options.limits.segments - walk.segments;
    const auto length = [&](const char* name, Axis axis) {
        return length_of(walk, node, name, axis, around).value_or(0);
    };
    const auto text = [&](const char* name) -> std::string_view {
        const std::string_view value = node.attribute(name).value();
        constexpr std::size_t per_step = 16;  // so that endless <use> of one long text comes to an end
        if (!walk.active.empty()) walk.sheet.steps += value.size() / per_step;
        return value;
    };
    switch (kind) {
        case Kind::path:
            return read_path(text("d"), room);
        case Kind::rect: {
            const double x = length("x", Axis::x), y = length("y", Axis::y);
            const double width = length("width", Axis::x), height = length("height", Axis::y);
            if (width <= 0 || height <= 0) return {};
            const auto [rx, ry] = radii(walk, node, around);
            return one(rectangle(x, y, width, height, std::min(rx, width / 2), std::min(ry, height / 2)));
        }
        case Kind::circle:
        case Kind::ellipse: {
            const Point center{length("cx", Axis::x), length("cy", Axis::y)};
            const double r = kind == Kind::circle ? length("r", Axis::diagonal) : 0;
            const auto [rx, ry] = kind == Kind::circle ? std::pair{r, r} : radii(walk, node, around);
            if (rx <= 0 || ry <= 0) return {};
            return one(svg::ellipse(center, rx, ry));
        }
        case Kind::line: {
            const Point from{length("x1", Axis::x), length("y1", Axis::y)};
            const Point to{length("x2", Axis::x), length("y2", Axis::y)};
            return one(Path{from, {LineSegment{to}}, false});
        }
        default:
            return read_points(text("points"), kind == Kind::polygon, room);
    }
}

void add_outline(Walk& walk, pugi::xml_node node, const std::vector<Path>& outline, Painted painted,
                 const Surroundings& around) {
    std::vector<Path> mapped;
    for (const auto& path : outline) {
        mapped.push_back(transformed(path, around.map));
        if (!within_range(mapped.back())) return walk.refuse_number(node, "a coordinate");
    }
    auto& collected = walk.collected;
    if (collected.purpose == Purpose::box) {
        collected.box = united(collected.box, bounds_of(mapped));
    } else if (collected.purpose == Purpose::outlines || collected.purpose == Purpose::mask) {
        std::vector<Polygon> polygons;
        append_polygons(mapped, polygons);
        const bool mask = collected.purpose == Purpose::mask;
        const auto rule = region_rule(mask ? around.style.fill_rule : around.style.clip_rule);
        auto area =
            around.clip ? resolved_within(polygons, rule, around.clip->regions) : resolved(polygons, rule);
        if (mask) return add_to_mask(collected, around, std::move(area));
        for (auto& [outer, holes] : area) {
            collected.outlines.push_back(std::move(outer));
            std::ranges::move(holes, std::back_inserter(collected.outlines));
        }
    } else {
        Shape shape;
        if (painted.fillable) shape.fill = paint_of(around.style.fill, around.style.fill_opacity, around);
        if (around.style.stroke_width > 0)
            shape.stroke = paint_of(around.style.stroke, around.style.stroke_opacity, around);
        if (!shape.fill && !shape.stroke) return;
        shape.id = id_of(walk, node, spot_of(walk.markup, node), around, painted.part);
        add_painted(walk, node, outline, std::move(mapped), std::move(shape), around);
    }
}

void add_shape(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around, int depth) {
    const auto& style = around.style;
    auto& notes = walk.notes;
    const bool shapes = walk.collected.purpose == Purpose::shapes;
    const bool marked = shapes && has_markers(kind, style);
    if (shapes)
        for (const auto child : node.children())
            if (const auto named = kind_named(local_name(child.name())); named.kind == Kind::left_out)
                note(notes, named.reason, child);
    if (!style.visible && walk.collected.purpose != Purpose::box) {
        if (shapes) note(notes, "hidden (visibility): left out", node);
        return;
    }
    const Painted painted{kind != Kind::line};  // a line bounds no area
    const bool fills = painted.fillable && paint_of(style.fill, style.fill_opacity, around);
    const bool strokes = style.stroke_width > 0 && paint_of(style.stroke, style.stroke_opacity, around);
    if (shapes && !fills && !strokes && !marked)
        return note(notes, "neither filled nor stroked: draws nothing", node);
    if (determinant(around.map) == 0)
        return note(notes, "a transform that leaves no area: draws nothing", node);

    auto outline = outline_of(walk, node, kind, around);
    if (outline.state == ValueState::refused) return walk.refuse(node, outline.message);
    const auto most = walk.options.limits.segments;
    if (!room_for(walk, node, outline.over_limit ? most + 1 : outline.segments) || walk.error) return;
    if (outline.state == ValueState::malformed)
        note(notes, "a faulty outline: kept up to its fault", node, outline.message);
    else if (outline.subpaths.empty())
        note(notes, "a shape without extent: draws nothing", node);
    if (outline.subpaths.empty()) return;
    add_outline(walk, node, outline.subpaths, painted, around);
    if (marked && !walk.over()) add_markers(walk, node, outline.subpaths, around, depth);
}

}  // namespace strandline::svg
