#include "plan_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "result/formats/formats.hpp"
#include "result/sketch/sketch.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::ordered_json;
constexpr auto lenient = Json::error_handler_t::replace;

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, lenient); }

/// Metres, to a tenth of a millimetre: finer than any pixel, a third of the text.
double shown(double metres) { return std::round(metres * 1e4) / 1e4; }

void add(Json& numbers, Point p) {
    numbers.push_back(shown(p.x));
    numbers.push_back(shown(p.y));
}
Json json_of(const std::vector<Point>& points) {
    Json numbers = Json::array();
    for (const Point p : points) add(numbers, p);
    return numbers;
}
Json json_of(Point p) { return {shown(p.x), shown(p.y)}; }

Json nodes_of(const Path& path) {
    Json nodes = Json::array();
    add(nodes, path.start);
    for (std::size_t i = 0; i < path.segments.size(); ++i)
        if (!path.closed || i + 1 < path.segments.size()) add(nodes, end_of(path.segments[i]));
    return nodes;
}

Json json_of(const Element& element, double tolerance) {
    Json json{{"id", element.id}, {"layer", element.layer}, {"inside", element.inside}};
    Json hints = Json::object();
    for (const svg::Hint& hint : element.hints) hints[hint.name] = hint.value;
    json["hints"] = std::move(hints);
    json["length"] = shown(length(element));
    if (const auto* line = std::get_if<LineElement>(&element.what)) {
        json["kind"] = "line";
        json["closed"] = line->path.closed;
        json["pins"] = line->pins;
        json["points"] = json_of(flattened(line->path, tolerance));
        json["nodes"] = nodes_of(line->path);
        return json;
    }
    const Region& region = std::get<RegionElement>(element.what).region;
    json["kind"] = "region";
    json["closed"] = true;
    json["area"] = area(region);
    json["points"] = json_of(region.outer);
    Json holes = Json::array();
    for (const Polygon& hole : region.holes) holes.push_back(json_of(hole));
    json["holes"] = std::move(holes);
    return json;
}

Json json_of(const Warning& warning) { return {{"place", warning.place}, {"reason", warning.reason}}; }
Json json_of(const Spot& spot) {
    return {{"what", spot.what}, {"at", json_of(spot.at)}, {"amount", spot.amount}};
}

template <class Values>
Json list_of(const Values& values) {
    Json list = Json::array();
    for (const auto& value : values) list.push_back(json_of(value));
    return list;
}

/// First and last sample of each stroke.
std::vector<std::pair<int, int>> spans_of(const Plan& plan) {
    std::vector<std::pair<int, int>> spans(plan.strokes.size(), {-1, -1});
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
        const int stroke = plan.samples[i].stroke;
        if (stroke < 0 || plan.samples[i].motion != Motion::draw) continue;
        auto& [first, last] = spans[static_cast<std::size_t>(stroke)];
        if (first < 0) first = static_cast<int>(i);
        last = static_cast<int>(std::min(i + 1, plan.samples.size() - 1));
    }
    return spans;
}

Json strokes_of(const Plan& plan) {
    Json strokes = Json::array();
    const auto spans = spans_of(plan);
    for (std::size_t k = 0; k < plan.strokes.size(); ++k) {
        const Stroke& stroke = plan.strokes[k];
        const Entry& entry = plan.order[k];
        const auto node = static_cast<std::size_t>(entry.node);
        strokes.push_back({{"element", stroke.element},
                           {"fill", stroke.fill},
                           {"closed", stroke.closed},
                           {"pins", stroke.pins},
                           {"reversed", entry.reversed},
                           {"node", node < stroke.nodes.size() ? stroke.nodes[node].drawn : -1},
                           {"first", spans[k].first},
                           {"last", spans[k].second}});
    }
    return strokes;
}

Json runs_of(const Plan& plan) {
    Json runs = Json::array();
    for (const sketch::Run& run : sketch::runs(plan.samples))
        runs.push_back({run.first, run.last, run.mask, run.stroke, run.draws ? 1 : 0});
    return runs;
}

Json connections_of(const Plan& plan) {
    Json connections = Json::array();
    for (const PlannedConnection& c : plan.connections) {
        Json json{{"from", c.from}, {"to", c.to}, {"length", shown(length(c.curve))}};
        if (c.from >= 0 && c.to >= 0) {
            const Stroke &a = plan.strokes[static_cast<std::size_t>(c.from)],
                         &b = plan.strokes[static_cast<std::size_t>(c.to)];
            if (a.fill && a.element == b.element) {
                Json& hop = json["hop"] = Json::array();
                add(hop, end_pose(a.rake_path.back()).at);
                add(hop, b.rake_path.front().start.at);
            }
        }
        connections.push_back(std::move(json));
    }
    return connections;
}

template <class Number>
void put(std::string& bytes, Number value) {
    static_assert(std::endian::native == std::endian::little);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

}  // namespace

Part part_of(std::string bytes, std::string type) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return {std::move(bytes), std::move(type), fmt::format("{:016x}", hash)};
}

Part drawing_part(const Plan& plan) {
    const Box field = field_of(plan);
    const DriveArea area = drive_area_of(plan);
    Json keep_out = Json::array();
    for (const Region& region : area.keep_out) {
        Json rings = Json::array();
        rings.push_back(json_of(region.outer));
        for (const Polygon& hole : region.holes) rings.push_back(json_of(hole));
        keep_out.push_back(std::move(rings));
    }
    Json elements = Json::array();
    for (const Element& element : plan.drawing.elements)
        elements.push_back(json_of(element, plan.options.drawing.tolerance));
    const Canvas& canvas = plan.drawing.canvas;
    return part_of(text_of({{"canvas", {{"width", canvas.width}, {"height", canvas.height}}},
                            {"field", {field.low.x, field.low.y, field.high.x, field.high.y}},
                            {"border", json_of(area.border.outer)},
                            {"keep_out", std::move(keep_out)},
                            {"scale", plan.drawing.scale},
                            {"start", plan.drawing.start ? json_of(*plan.drawing.start) : Json()},
                            {"elements", std::move(elements)}}),
                   json_type);
}

Part drive_part(const Plan& plan) {
    Json stops = Json::array();
    for (const Stop& stop : plan.stops)
        stops.push_back({{"why", stop.why}, {"stroke", stop.stroke}, {"time", stop.time}});
    return part_of(text_of({{"strokes", strokes_of(plan)},
                            {"connections", connections_of(plan)},
                            {"runs", runs_of(plan)},
                            {"stops", std::move(stops)},
                            {"figures", Json::parse(formats::write_figures(plan))},
                            {"robot", Json::parse(formats::write_robot_json(plan.robot))},
                            {"warnings", list_of(plan.warnings)},
                            {"idle", plan.idle_edits},
                            {"undrivable", list_of(plan.undrivable)},
                            {"bare", list_of(plan.bare)}}),
                   json_type);
}

Part samples_part(const Plan& plan) {
    std::string bytes = "SLS1";
    bytes.reserve(8 + plan.samples.size() * 33);
    put(bytes, static_cast<std::uint32_t>(plan.samples.size()));
    const auto column = [&](auto value) {
        for (const Sample& sample : plan.samples) put(bytes, value(sample));
    };
    column([](const Sample& s) { return static_cast<float>(s.t); });
    column([](const Sample& s) { return static_cast<float>(s.pose.at.x); });
    column([](const Sample& s) { return static_cast<float>(s.pose.at.y); });
    column([](const Sample& s) { return static_cast<float>(s.pose.heading); });
    column([](const Sample& s) { return static_cast<float>(s.rake.x); });
    column([](const Sample& s) { return static_cast<float>(s.rake.y); });
    column([](const Sample& s) { return static_cast<std::uint32_t>(s.mask); });
    column([](const Sample& s) { return static_cast<std::int32_t>(s.stroke); });
    column([](const Sample& s) { return static_cast<std::uint8_t>(s.motion); });
    return part_of(std::move(bytes), "application/octet-stream");
}

Part report_part(const check::Report& report) { return part_of(formats::write_report(report), json_type); }

}  // namespace strandline::serve
