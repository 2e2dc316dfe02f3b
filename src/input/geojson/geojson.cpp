#include "input/geojson/geojson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace strandline::geojson {
namespace {

using Json = nlohmann::json;

constexpr double farthest = 10'000;  // m: nobody drives there; the site is wrong, or degrees are swapped
constexpr int deepest = 20;          // collections within collections

class Reader {
  public:
    explicit Reader(const Site& site) : site_(site) {}

    /// Geometry, feature or collection. `place` names it in errors.
    Outcome<void> object(const Json& json, const std::string& place, double radius, int depth) {
        if (depth > deepest) return fail(place, "is nested too deeply", "give the areas themselves");
        if (!json.is_object()) return fail(place, "is no GeoJSON object", "it begins with {\"type\": ...");
        const std::string type =
            json.contains("type") && json["type"].is_string() ? json["type"].get<std::string>() : "";
        if (json.contains("crs") && json["crs"].dump().find("CRS84") == std::string::npos)
            return fail(place + "/crs", "names a coordinate system; GeoJSON has degrees of WGS 84 alone",
                        "convert it: ogr2ogr -t_srs EPSG:4326 out.geojson in.geojson");
        if (type == "FeatureCollection") return each(json, "features", place, radius, depth);
        if (type == "GeometryCollection") return each(json, "geometries", place, radius, depth);
        if (type == "Feature") {
            const Json properties = json.value("properties", Json());
            if (properties.is_object() && properties.contains("radius") && properties["radius"].is_number())
                radius = properties["radius"].get<double>();
            if (!json.contains("geometry")) return fail(place, "is a feature without geometry");
            if (json["geometry"].is_null()) return {};
            return object(json["geometry"], place + "/geometry", radius, depth + 1);
        }
        if (!json.contains("coordinates") || !json["coordinates"].is_array())
            return fail(place, type.empty() ? "has no type" : type + " without coordinates",
                        "use Polygon, MultiPolygon, Feature or FeatureCollection");
        return geometry(type, json["coordinates"], place, radius);
    }
    Areas done() { return std::move(areas_); }

  private:
    Outcome<void> each(const Json& json, const char* members, const std::string& place, double radius,
                       int depth) {
        if (!json.contains(members) || !json[members].is_array())
            return fail(place, fmt::format("has no {}", members));
        for (std::size_t k = 0; k < json[members].size(); ++k)
            if (auto read =
                    object(json[members][k], fmt::format("{}/{}/{}", place, members, k), radius, depth + 1);
                !read)
                return read;
        return {};
    }

    Outcome<void> geometry(const std::string& type, const Json& coordinates, const std::string& place,
                           double radius) {
        if (type == "Polygon") return polygon(coordinates, place);
        if (type == "MultiPolygon") {
            for (std::size_t k = 0; k < coordinates.size(); ++k)
                if (auto read = polygon(coordinates[k], fmt::format("{}/{}", place, k)); !read) return read;
            return {};
        }
        if (type == "Point" && radius > 0) {
            const auto at = position(coordinates, place);
            if (!at) return tl::unexpected(at.error());
            areas_.regions.push_back({pole_outline(*at, radius), {}});
            return {};
        }
        areas_.warnings.push_back(
            {place, type + " bounds no area: passed over" +
                        (type == "Point" ? "; with a property radius it is a pole" : "")});
        return {};
    }

    Outcome<Point> position(const Json& json, const std::string& place) const {
        if (!json.is_array() || json.size() < 2 || !json[0].is_number() || !json[1].is_number())
            return fail(place, "is no position", "write [longitude, latitude]");
        const Geographic at{json[1].get<double>(), json[0].get<double>()};
        if (!(std::abs(at.latitude) <= 90 && std::abs(at.longitude) <= 180))
            return fail(place, fmt::format("[{}, {}] are no degrees", at.longitude, at.latitude),
                        "write [longitude, latitude] in degrees of WGS 84");
        const Point canvas = to_canvas(site_, at);
        if (!(length(canvas) < farthest))
            return fail(place, fmt::format("is {:.0f} km from the canvas", length(canvas) / 1000),
                        "check site.latitude and site.longitude, and that longitude comes first here");
        return canvas;
    }

    Outcome<Polygon> ring(const Json& json, const std::string& place) const {
        if (!json.is_array() || json.size() < 4)
            return fail(place, "is no ring of four positions or more, the last as the first");
        Polygon outline;
        for (std::size_t k = 0; k < json.size(); ++k) {
            const auto at = position(json[k], fmt::format("{}/{}", place, k));
            if (!at) return tl::unexpected(at.error());
            outline.push_back(*at);
        }
        constexpr double same = 1e-3;  // m: other programs round the last position differently
        if (distance(outline.front(), outline.back()) > same)
            return fail(place, "is not closed", "end the ring with its first position");
        outline.pop_back();
        return outline;
    }

    Outcome<void> polygon(const Json& rings, const std::string& place) {
        if (!rings.is_array() || rings.empty()) return fail(place, "is a polygon without rings");
        Region region;
        for (std::size_t k = 0; k < rings.size(); ++k) {
            auto outline = ring(rings[k], fmt::format("{}/{}", place, k));
            if (!outline) return tl::unexpected(outline.error());
            if (k == 0)
                region.outer = counter_clockwise(std::move(*outline));
            else
                region.holes.push_back(reversed(counter_clockwise(std::move(*outline))));
        }
        areas_.regions.push_back(std::move(region));
        return {};
    }

    const Site& site_;
    Areas areas_;
};

}  // namespace

Outcome<Areas> read_areas(std::string_view text, const std::string& place, const Site& site) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        return fail(place, fmt::format("is not JSON: stopped at byte {}", error.byte), "name a GeoJSON file");
    }
    Reader reader(site);
    if (auto read = reader.object(json, place, 0, 0); !read) return tl::unexpected(read.error());
    Areas areas = reader.done();
    if (areas.regions.empty()) return fail(place, "holds no area", "draw a polygon");
    return areas;
}

}  // namespace strandline::geojson
