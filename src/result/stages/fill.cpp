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

std::string write_moves(const FillTask& task, double width, const std::vector<fill::Move>& moves,
                        std::optional<int> pins) {
    Json json = Json::parse(task.source);
    json["width"] = width;
    Json list = Json::array();
    for (const fill::Move& move : moves) {
        Json item{{"pts", written(move.line)}, {"down", move.mask != 0}};
        if (pins && move.mask != 0) {
            std::string mask;  // leftmost pin first
            for (int pin = *pins - 1; pin >= 0; --pin) mask += (move.mask >> pin & 1U) != 0 ? '1' : '0';
            item["mask"] = mask;
        }
        list.push_back(std::move(item));
    }
    json["strokes"] = std::move(list);
    return json.dump() + "\n";
}

std::string write_account(const fill::Account& account) {
    Json gaps = Json::array();
    for (const fill::Gap& gap : account.gaps)
        gaps.push_back({{"at", {gap.at.x, gap.at.y}}, {"area", gap.area}, {"disc", gap.disc}});
    const Json json{{"area", account.area},
                    {"coverage", account.coverage},
                    {"overdraw", account.overdraw},
                    {"spill", account.spill},
                    {"spill_reach", account.spill_reach},
                    {"ratio", account.ratio},
                    {"hops", account.hops},
                    {"pivots", account.pivots},
                    {"hops_length", account.hops_length},
                    {"drives_over", account.drives_over},
                    {"driven_over", account.driven_over},
                    {"crisp_edge", account.crisp_edge},
                    {"end_off_border", account.end_off_border},
                    {"gaps", std::move(gaps)},
                    {"cell", account.cell}};
    return json.dump() + "\n";
}

}  // namespace strandline::stages
