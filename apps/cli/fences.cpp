// --border and --keep-out: texts, or files of GeoJSON.
#include <fmt/format.h>

#include "arguments.hpp"
#include "base/units/units.hpp"
#include "console.hpp"
#include "input/geojson/geojson.hpp"

namespace strandline::cli {
namespace {

bool is_geojson(const std::string& text) { return text.ends_with(".geojson") || text.ends_with(".json"); }

std::string outline_text(const Polygon& outline) {
    std::string text;
    for (const Point p : outline)
        text += fmt::format("{}{},{}", text.empty() ? "" : " ", number_text(p.x), number_text(p.y));
    return text;
}

void append(std::string& list, const std::string& more) { list += (list.empty() ? "" : "; ") + more; }

Outcome<geojson::Areas> areas_in(Wishes& wishes, const std::string& path) {
    const auto bytes = read_input(path);
    if (!bytes) return tl::unexpected(bytes.error());
    if (!wishes.options.site.known)
        wishes.warnings.push_back({path,
                                   "no place on earth is set for the canvas: latitude 0, longitude 0 is "
                                   "taken; set site.latitude, site.longitude and site.heading"});
    auto areas = geojson::read_areas(*bytes, path, wishes.options.site.at);
    if (areas) wishes.warnings.insert(wishes.warnings.end(), areas->warnings.begin(), areas->warnings.end());
    return areas;
}

}  // namespace

Outcome<void> set_fences(Wishes& wishes, const std::string& border,
                         const std::vector<std::string>& keep_outs) {
    std::string borders = is_geojson(border) ? "" : border;
    std::string list = wishes.options.field.keep_out;
    if (is_geojson(border)) {
        const auto areas = areas_in(wishes, border);
        if (!areas) return tl::unexpected(areas.error());
        for (const Region& region : areas->regions) {
            append(borders, outline_text(region.outer));
            for (const Polygon& hole : region.holes) append(list, outline_text(hole));
        }
    }
    for (const std::string& keep_out : keep_outs) {
        if (!is_geojson(keep_out)) {
            append(list, keep_out);
            continue;
        }
        const auto areas = areas_in(wishes, keep_out);
        if (!areas) return tl::unexpected(areas.error());
        for (const Region& region : areas->regions) {
            append(list, outline_text(region.outer));
            if (!region.holes.empty())
                wishes.warnings.push_back(
                    {keep_out, "holes in keep-outs are kept out of as well: outlines have none here"});
        }
    }
    if (!borders.empty())
        if (auto done = set(wishes.options, "field.border", borders); !done) return done;
    if (list != wishes.options.field.keep_out) return set(wishes.options, "field.keep_out", list);
    return {};
}

}  // namespace strandline::cli
