#include "plan_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <unordered_map>
#include <utility>

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

/// Lists that grow with the drawing are written without a tree of values: that takes ten times as long.
class List {
  public:
    List(std::string& text, const char* key) : text_(text) { text_ += fmt::format("\"{}\":[", key); }
    List(const List&) = delete;
    List& operator=(const List&) = delete;
    ~List() { text_ += "],"; }
    std::back_insert_iterator<std::string> next() {
        if (std::exchange(begun_, true)) text_ += ',';
        return std::back_inserter(text_);
    }

  private:
    std::string& text_;
    bool begun_ = false;
};

/// First and last sample of each stroke.
std::vector<std::pair<int, int>> spans_of(const Plan& plan, const std::vector<sketch::Run>& runs) {
    std::vector<std::pair<int, int>> spans(plan.strokes.size(), {-1, -1});
    for (const sketch::Run& run : runs) {
        if (!run.draws) continue;
        auto& [first, last] = spans[static_cast<std::size_t>(run.stroke)];
        if (first < 0) first = static_cast<int>(run.first);
        last = static_cast<int>(run.last);
    }
    return spans;
}

void add_strokes(std::string& text, const Plan& plan, const std::vector<sketch::Run>& runs) {
    List list(text, "strokes");
    const auto spans = spans_of(plan, runs);
    for (std::size_t k = 0; k < plan.strokes.size(); ++k) {
        const Stroke& stroke = plan.strokes[k];
        const Entry& entry = plan.order[k];
        const auto node = static_cast<std::size_t>(entry.node);
        fmt::format_to(
            list.next(),
            R"({{"element":{},"fill":{},"closed":{},"pins":{},"reversed":{},"node":{},"first":{},"last":{}}})",
            stroke.element, stroke.fill, stroke.closed, stroke.pins, entry.reversed,
            node < stroke.nodes.size() ? stroke.nodes[node].drawn : -1, spans[k].first, spans[k].second);
    }
}

void add_runs(std::string& text, const std::vector<sketch::Run>& runs) {
    List list(text, "runs");
    for (const sketch::Run& run : runs)
        fmt::format_to(list.next(), "[{},{},{},{},{}]", run.first, run.last, run.mask, run.stroke,
                       run.draws ? 1 : 0);
}

void add_connections(std::string& text, const Plan& plan) {
    List list(text, "connections");
    for (const PlannedConnection& c : plan.connections) {
        auto at = list.next();
        fmt::format_to(at, R"({{"from":{},"to":{},"length":{})", c.from, c.to, shown(length(c.curve)));
        if (c.from >= 0 && c.to >= 0) {
            const Stroke &a = plan.strokes[static_cast<std::size_t>(c.from)],
                         &b = plan.strokes[static_cast<std::size_t>(c.to)];
            if (a.fill && a.element == b.element) {
                const Point from = end_pose(a.rake_path.back()).at, to = b.rake_path.front().start.at;
                fmt::format_to(at, R"(,"hop":[{},{},{},{}])", shown(from.x), shown(from.y), shown(to.x),
                               shown(to.y));
            }
        }
        text += '}';
    }
}

}  // namespace

Part part_of(std::string bytes, std::string type) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return {std::move(bytes), std::move(type), fmt::format("{:016x}", hash)};
}

Part DrawingMaker::part(const std::shared_ptr<const Plan>& plan) {
    const Drawing& drawing = plan->drawing;
    const double tolerance = plan->options.drawing.tolerance;
    std::unordered_map<std::string_view, std::size_t> known;
    if (last_ && last_->options.drawing.tolerance == tolerance)
        for (std::size_t i = 0; i < last_->drawing.elements.size(); ++i)
            known.try_emplace(last_->drawing.elements[i].id, i);
    std::vector<std::string> texts;
    for (const Element& element : drawing.elements) {
        const auto same = known.find(element.id);
        texts.push_back(same != known.end() && last_->drawing.elements[same->second] == element
                            ? texts_[same->second]
                            : text_of(json_of(element, tolerance)));
    }
    const Box field = field_of(*plan);
    const DriveArea area = drive_area_of(*plan);
    Json keep_out = Json::array();
    for (const Region& region : area.keep_out) {
        Json rings = Json::array();
        rings.push_back(json_of(region.outer));
        for (const Polygon& hole : region.holes) rings.push_back(json_of(hole));
        keep_out.push_back(std::move(rings));
    }
    std::string text = "{";
    {
        List list(text, "elements");
        for (const std::string& element : texts) fmt::format_to(list.next(), "{}", element);
    }
    text += text_of({{"canvas", {{"width", drawing.canvas.width}, {"height", drawing.canvas.height}}},
                     {"field", {field.low.x, field.low.y, field.high.x, field.high.y}},
                     {"border", json_of(area.border.outer)},
                     {"keep_out", std::move(keep_out)},
                     {"scale", drawing.scale},
                     {"start", drawing.start ? json_of(*drawing.start) : Json()}})
                .substr(1);
    texts_ = std::move(texts);
    last_ = plan;
    return part_of(std::move(text), json_type);
}

Part drive_part(const Plan& plan, const SampleRow& samples) {
    const std::vector<sketch::Run> runs = runs_of(samples);
    std::string text = "{";
    add_strokes(text, plan, runs);
    add_connections(text, plan);
    add_runs(text, runs);
    Json stops = Json::array();
    for (const Stop& stop : plan.stops)
        stops.push_back({{"why", stop.why}, {"stroke", stop.stroke}, {"time", stop.time}});
    text += text_of({{"stops", std::move(stops)},
                     {"figures", Json::parse(formats::write_figures(plan))},
                     {"robot", Json::parse(formats::write_robot_json(plan.robot))},
                     {"warnings", list_of(plan.warnings)},
                     {"idle", plan.idle_edits},
                     {"undrivable", list_of(plan.undrivable)},
                     {"bare", list_of(plan.bare)}})
                .substr(1);
    return part_of(std::move(text), json_type);
}

Part report_part(const check::Report& report) { return part_of(formats::write_report(report), json_type); }

}  // namespace strandline::serve
