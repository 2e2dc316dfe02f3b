#pragma once
// Areas of a GeoJSON text (RFC 7946) -> areas on the canvas: borders and keep-outs as maps and surveys give
// them.
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/site/site.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline::geojson {

struct Areas {
    std::vector<Region> regions;  ///< metres on the canvas; outer counter-clockwise, holes clockwise
    Warnings warnings;            ///< what bounds no area and was passed over
};
/// Polygons and MultiPolygons, alone or within features and collections, whichever way round their rings run;
/// a Point whose feature has a property "radius" (metres) is a pole. Heights are passed over. Error: text
/// that is not JSON or not GeoJSON, with the place in it; coordinates that are no degrees; rings that are not
/// closed; no area at all; an area farther from the canvas than any drive (10 km).
Outcome<Areas> read_areas(std::string_view text, const std::string& place, const Site& site);

}  // namespace strandline::geojson
