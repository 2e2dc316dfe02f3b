#include "input/geojson/geojson.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace strandline {
namespace {

const Site beach{{47.37, 8.55}, 0, 0, 0, 0.6};

std::string ring_of(Polygon outline) {
    outline.push_back(outline.front());
    std::string text;
    for (const Point p : outline) {
        const Geographic at = to_geographic(beach, p);
        text += fmt::format("{}[{:.12f}, {:.12f}, 3.5]", text.empty() ? "" : ", ", at.longitude, at.latitude);
    }
    return "[" + text + "]";
}
const Polygon square{{1, 1}, {5, 1}, {5, 5}, {1, 5}}, hole{{2, 2}, {3, 2}, {3, 3}};

std::string error_of(const std::string& text) {
    const auto read = geojson::read_areas(text, "fence.geojson", beach);
    return read ? "" : sentence(read.error());
}

TEST(GeoJson, APolygonWithAHoleIsReadWhicheverWayItRuns) {
    for (const bool turned : {false, true}) {
        const auto read = geojson::read_areas(R"({"type": "Polygon", "coordinates": [)" +
                                                  ring_of(turned ? reversed(square) : square) + ", " +
                                                  ring_of(turned ? reversed(hole) : hole) + "]}",
                                              "fence.geojson", beach);
        ASSERT_TRUE(read) << sentence(read.error());
        ASSERT_EQ(read->regions.size(), 1u);
        EXPECT_NEAR(area(read->regions[0]), 15.5, 1e-5);
        EXPECT_GT(signed_area(read->regions[0].outer), 0);
        EXPECT_LT(signed_area(read->regions[0].holes[0]), 0);
        EXPECT_LT(distance_to_outline(read->regions[0].outer, {1, 1}), 1e-6);
    }
}

TEST(GeoJson, CollectionsPolesAndWhatBoundsNoArea) {
    const Geographic pole = to_geographic(beach, {8, 9});
    const auto read = geojson::read_areas(
        R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": null, "geometry": {"type": "MultiPolygon", "coordinates": [[)" +
            ring_of(square) + "]]}}," +
            fmt::format(R"({{"type": "Feature", "properties": {{"radius": 0.5}},
"geometry": {{"type": "Point", "coordinates": [{:.12f}, {:.12f}]}}}},)",
                        pole.longitude, pole.latitude) +
            R"({"type": "Feature", "properties": {}, "geometry": null},
{"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[8.55, 47.37], [8.56, 47.37]]}}]})",
        "fence.geojson", beach);
    ASSERT_TRUE(read) << sentence(read.error());
    ASSERT_EQ(read->regions.size(), 2u);
    EXPECT_NEAR(distance(centroid(read->regions[1].outer), {8, 9}), 0, 1e-5);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_NE(read->warnings[0].reason.find("LineString"), std::string::npos);
    EXPECT_NE(read->warnings[0].place.find("/features/3/geometry"), std::string::npos);
}

TEST(GeoJson, WhatIsWrongIsRefusedWithItsPlace) {
    EXPECT_NE(error_of("{").find("is not JSON"), std::string::npos);
    EXPECT_NE(error_of("[]").find("no GeoJSON object"), std::string::npos);
    EXPECT_NE(error_of(R"({"type": "FeatureCollection"})").find("has no features"), std::string::npos);
    EXPECT_NE(error_of(R"({"type": "FeatureCollection", "features": []})").find("no area"),
              std::string::npos);
    EXPECT_NE(error_of(R"({"type": "Polygon", "coordinates": [[[8, 47], [8, 48], [9, 48]]]})").find("/0"),
              std::string::npos);
    EXPECT_NE(error_of(R"({"type": "Polygon", "coordinates": [[[47.37, 8.55], [47.38, 8.55], [47.37, 8.56],
[47.37, 8.55]]]})")
                  .find("km from the canvas"),
              std::string::npos)
        << "latitude first";
    EXPECT_NE(error_of(R"({"type": "Polygon", "coordinates": [[[2683000, 1247000], [2683010, 1247000],
[2683010, 1247010], [2683000, 1247000]]]})")
                  .find("no degrees"),
              std::string::npos);
    const std::string open = ring_of(square);
    EXPECT_NE(error_of(R"({"type": "Polygon", "coordinates": [)" + open.substr(0, open.rfind(", [")) + "]]}")
                  .find("not closed"),
              std::string::npos);
    EXPECT_NE(error_of(R"({"type": "Polygon", "crs": {"type": "name", "properties": {"name": "EPSG:2056"}},
"coordinates": []})")
                  .find("/crs"),
              std::string::npos);
    std::string deep = "null";
    for (int k = 0; k < 100; ++k) deep = R"({"type": "GeometryCollection", "geometries": [)" + deep + "]}";
    EXPECT_NE(error_of(deep).find("too deeply"), std::string::npos);
}

}  // namespace
}  // namespace strandline
