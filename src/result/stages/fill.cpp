// `strandline fill`: a polygon in, the same object with strokes out.
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

using Json = nlohmann::ordered_json;

Outcome<Polygon> ring_from(const Json& json, const std::string& place) {
    if (!json.is_array()) return fail(place, "is not a list of points", "write [[x,y],[x,y],...]");
    Polygon ring;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const Json& point = json[i];
        if (!point.is_array() || point.size() < 2 || !point[0].is_number() || !point[1].is_number())
            return fail(fmt::format("{}, point {}", place, i), "is not a pair of numbers", "write [x,y]");
        const Point p{point[0].get<double>(), point[1].get<double>()};
        constexpr double farthest = 1e12;  // beyond that no digits are left for a shape
        if (!is_finite(p) || std::abs(p.x) > farthest || std::abs(p.y) > farthest)
            return fail(fmt::format("{}, point {}", place, i), "is out of range",
                        "keep coordinates below 1e12");
        ring.push_back(p);
    }
    return without_duplicate_corners(ring);
}

Json written(const Polyline& line) {
    Json points = Json::array();
    for (Point p : line) points.push_back({p.x, p.y});
    return points;
}

}  // namespace

Outcome<FillTask> read_polygon(std::string_view text, const std::string& place) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        return fail(place, fmt::format("is not JSON: it goes wrong at byte {}", error.byte),
                    "write {\"polygon\":{\"outer\":[[x,y],...]},\"width\":w}");
    }
    if (!json.is_object() || !json.contains("polygon") || !json["polygon"].is_object() ||
        !json["polygon"].contains("outer"))
        return fail(place, "has no polygon",
                    "write {\"polygon\":{\"outer\":[[x,y],...],\"holes\":[...]},\"width\":w}");
    FillTask task;
    task.source = text;
    if (json.contains("width")) {
        const Json& width = json["width"];
        if (!width.is_number() || !std::isfinite(width.get<double>()) || width.get<double>() <= 0)
            return fail(place + ", width", "is not a number above 0");
        task.width = width.get<double>();
    }
    const Json& polygon = json["polygon"];
    const auto outer = ring_from(polygon["outer"], place + ", outer");
    if (!outer) return tl::unexpected(outer.error());
    if (outer->size() < 3) return fail(place + ", outer", "has fewer than three different points");
    task.regions = resolved({*outer}, FillRule::even_odd);
    const double drawn = area(*outer);
    std::vector<Polygon> holes;
    if (polygon.contains("holes")) {
        if (!polygon["holes"].is_array()) return fail(place + ", holes", "is not a list of rings");
        for (std::size_t i = 0; i < polygon["holes"].size(); ++i) {
            const auto hole = ring_from(polygon["holes"][i], fmt::format("{}, hole {}", place, i));
            if (!hole) return tl::unexpected(hole.error());
            if (hole->size() < 3)
                task.warnings.push_back({fmt::format("{}, hole {}", place, i), "has no area: left out"});
            else
                holes.push_back(*hole);
        }
    }
    constexpr double same_area = 1e-6;
    if (task.regions.size() > 1 || std::abs(area(task.regions) - drawn) > same_area * area(task.regions))
        task.warnings.push_back(
            {place + ", outer", "touches or crosses itself: repaired by the even-odd rule"});
    if (!holes.empty()) {
        Regions cut_out;  // one by one: holes that overlap stay holes
        for (const Polygon& hole : holes) cut_out = united(cut_out, resolved({hole}, FillRule::even_odd));
        task.regions = subtracted(task.regions, cut_out);
    }
    if (task.regions.empty()) return fail(place, "has no area", "check the outline and its holes");
    return task;
}

std::string write_strokes(const FillTask& task, double width, const std::vector<Stroke>& strokes,
                          const std::vector<Polyline>& ways, double tolerance) {
    Json json = Json::parse(task.source);
    json["width"] = width;
    Json list = Json::array();
    Point last;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        Polyline line;
        for (const Curve& curve : strokes[i].rake_path) {
            // A chord of length c leaves an arc of curvature k by k c^2 / 8; a straight curve needs its ends
            // only.
            const double bend = max_curvature(curve);
            const double whole = length(curve);
            const double step = bend > 0 ? std::min(whole, std::sqrt(8 * tolerance / bend)) : whole;
            for (const CurvePoint& p : sampled(curve, std::max(step, 1e-9)))
                if (line.empty() || distance(line.back(), p.pose.at) > 1e-9) line.push_back(p.pose.at);
        }
        if (line.size() < 2) continue;
        if (!list.empty()) {
            Polyline way{last};
            if (i < ways.size()) way.insert(way.end(), ways[i].begin(), ways[i].end());
            way.push_back(line.front());
            way = without_duplicates(way);
            if (way.size() >= 2 && length(way) > 0) list.push_back({{"pts", written(way)}, {"down", false}});
        }
        last = line.back();
        list.push_back({{"pts", written(line)}, {"down", true}});
    }
    json["strokes"] = std::move(list);
    return json.dump() + "\n";
}

}  // namespace strandline::stages
