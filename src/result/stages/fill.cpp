// `strandline fill`: a polygon in, the same object with strokes out.
#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

using Json = nlohmann::ordered_json;

/// A ring as the file has it: one that repeats its first point at the end is closed by it, as GeoJSON does;
/// other repeated points are left out and said.
Outcome<Polygon> ring_from(const Json& json, const std::string& place, Warnings& warnings) {
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
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    Polygon distinct = without_duplicate_corners(ring);
    if (distinct.size() < ring.size()) {
        std::size_t first = 1;
        while (first < ring.size() && !(ring[first] == ring[first - 1])) ++first;
        warnings.push_back({fmt::format("{}, point {}", place, first % ring.size()),
                            fmt::format("{} points that repeat the one before are left out",
                                        ring.size() - distinct.size())});
    }
    return distinct;
}

std::string metres(Point p) { return fmt::format("({:.4g}, {:.4g})", p.x, p.y); }

/// What is wrong with the rings (the outer one first), by place. `names` has the rings' places.
void say_contacts(const std::vector<Polygon>& rings, const std::vector<std::string>& names,
                  Warnings& warnings) {
    constexpr double same_place = 1e-9;  // of the extent
    Box box;
    for (const Polygon& ring : rings) box = united(box, bounds(ring));
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Point>> places;
    for (const Contact& contact : contacts(rings, same_place * std::max(box.width(), box.height())))
        places[{contact.a, contact.b}].push_back(contact.at);
    for (const auto& [pair, at] : places) {
        const auto [a, b] = pair;
        const std::string where = at.size() == 1
                                      ? "at " + metres(at[0])
                                      : fmt::format("at {} places, one of them {}", at.size(), metres(at[0]));
        if (a == b)
            warnings.push_back(
                {names[a],
                 fmt::format("touches or crosses itself {}: repaired by the even-odd rule", where)});
        else
            warnings.push_back(
                {names[b],
                 fmt::format("touches or crosses {} {}: {}", a == 0 ? "the outline" : names[a], where,
                             a == 0 ? "what lies outside is ignored" : "the holes are cut out together")});
    }
}

/// As short as reads back the same, without a JSON value for each.
void append(std::string& text, double number) {
    if (std::isfinite(number))
        fmt::format_to(std::back_inserter(text), "{}", number);
    else
        text += "null";
}

void append(std::string& text, const Polyline& line) {
    text += '[';
    for (Point p : line) {
        text += text.back() == '[' ? "[" : ",[";
        append(text, p.x);
        text += ',';
        append(text, p.y);
        text += ']';
    }
    text += ']';
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
    if (json.contains("width")) {
        const Json& width = json["width"];
        if (!width.is_number() || !std::isfinite(width.get<double>()) || width.get<double>() <= 0)
            return fail(place + ", width", "is not a number above 0");
        task.width = width.get<double>();
    }
    json.erase("width");
    json.erase("strokes");
    task.source = json.dump();
    const Json& polygon = json["polygon"];
    const auto outer = ring_from(polygon["outer"], place + ", outer", task.warnings);
    if (!outer) return tl::unexpected(outer.error());
    if (outer->size() < 3) return fail(place + ", outer", "has fewer than three different points");
    std::vector<Polygon> rings{*outer};
    std::vector<std::string> names{place + ", outer"};
    task.regions = resolved({*outer}, FillRule::even_odd);
    if (polygon.contains("holes")) {
        if (!polygon["holes"].is_array()) return fail(place + ", holes", "is not a list of rings");
        const Regions whole = task.regions;
        Regions cut_out;  // united: holes that overlap stay holes
        for (std::size_t i = 0; i < polygon["holes"].size(); ++i) {
            const std::string name = fmt::format("{}, hole {}", place, i);
            const auto hole = ring_from(polygon["holes"][i], name, task.warnings);
            if (!hole) return tl::unexpected(hole.error());
            const Regions inside = hole->size() < 3 ? Regions{} : resolved({*hole}, FillRule::even_odd);
            if (inside.empty()) {
                task.warnings.push_back({name, "has no area: left out"});
                continue;
            }
            if (!contains(whole, point_inside(inside[0])) && intersected(inside, whole).empty())
                task.warnings.push_back({name, "lies outside the outline: left out"});
            rings.push_back(*hole);
            names.push_back(name);
            cut_out.insert(cut_out.end(), inside.begin(), inside.end());
        }
        if (!cut_out.empty()) task.regions = subtracted(task.regions, united(cut_out, {}));
    }
    say_contacts(rings, names, task.warnings);
    constexpr double sliver = 1e-9;  // of the area: what rounding leaves between outlines that touch
    const double whole = area(task.regions);
    for (const Region& region : task.regions)
        if (area(region) < sliver * whole)
            task.warnings.push_back({place, fmt::format("a sliver of {:.2g} m2 near {} is left out",
                                                        area(region), metres(region.outer.front()))});
    std::erase_if(task.regions, [&](const Region& region) { return area(region) < sliver * whole; });
    if (task.regions.empty()) return fail(place, "has no area", "check the outline and its holes");
    return task;
}

std::string write_moves(const FillTask& task, double width, const std::vector<rake::Move>& moves,
                        std::optional<int> pins) {
    std::string text = task.source;
    text.pop_back();  // the object is not over
    text += ",\"width\":";
    append(text, width);
    text += ",\"strokes\":[";
    for (const rake::Move& move : moves) {
        text += text.back() == '[' ? "{\"pts\":" : ",{\"pts\":";
        append(text, move.line);
        text += move.mask != 0 ? ",\"down\":true" : ",\"down\":false";
        if (pins && move.mask != 0) {  // leftmost pin first
            text += ",\"mask\":\"";
            for (int pin = *pins - 1; pin >= 0; --pin) text += (move.mask >> pin & 1U) != 0 ? '1' : '0';
            text += '"';
        }
        text += '}';
    }
    return text + "]}\n";
}

std::string write_account(const rake::Account& account) {
    Json gaps = Json::array();
    for (const rake::Gap& gap : account.gaps)
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
