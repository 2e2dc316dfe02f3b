#include "exports/drive.hpp"
#include "result/exports/exports.hpp"

namespace strandline {
namespace {

using namespace testing;

/// Neighbouring runs of one kind are cut where the mask changes: joined as the plan's tracks are.
std::vector<Track> tracks(const Json& collection, const std::string& what, const Site& site) {
    std::vector<Track> list;
    for (const Json& feature : collection.at("features")) {
        if (feature.at("properties").at("what") != what) continue;
        EXPECT_EQ(feature.at("geometry").at("type"), "LineString");
        list.push_back({what == "raked", {}});
        for (const Json& position : feature.at("geometry").at("coordinates"))
            list.back().points.push_back(read_back(site, {position.at(1), position.at(0)}));
    }
    return list;
}

TEST(GeoJsonExport, ReadBackItIsTheDriveWithinAMillimetre) {
    const Plan plan = beach_plan();
    const Json json = Json::parse(exports::geojson(plan).files.at(0).bytes);
    const Site& site = plan.options.site.at;
    expect_same(tracks(json, "raked", site), only_down(tracks_of(plan, true)), millimetre);
    auto up = tracks_of(plan, false);
    std::erase_if(up, [](const Track& t) { return t.down; });
    expect_same(tracks(json, "driven, rake up", site), up, millimetre);
}

TEST(GeoJsonExport, SaysWhatIsRakedWithHowManyPinsForWhichElement) {
    const Json json = Json::parse(exports::geojson(beach_plan()).files.at(0).bytes);
    for (const Json& feature : json.at("features"))
        if (const Json& p = feature.at("properties"); p.at("what") == "raked" && p.at("stroke") == 1) {
            EXPECT_EQ(p.at("element"), "second");
            EXPECT_EQ(p.at("pins"), 3);
            EXPECT_NEAR(p.at("width").get<double>(), 0.18, 1e-9);
            return;
        }
    FAIL() << "no second stroke";
}

TEST(GeoJsonExport, OuterRingsRunCounterClockwiseAndAreClosed) {
    const Json json = Json::parse(exports::geojson(beach_plan()).files.at(0).bytes);
    int polygons = 0;
    for (const Json& feature : json.at("features")) {
        if (feature.at("geometry").at("type") != "Polygon") continue;
        ++polygons;
        const Json& rings = feature.at("geometry").at("coordinates");
        for (std::size_t k = 0; k < rings.size(); ++k) {
            EXPECT_EQ(rings[k].front(), rings[k].back());
            Polygon outline;
            for (const Json& position : rings[k]) outline.push_back({position.at(0), position.at(1)});
            outline.pop_back();
            EXPECT_EQ(signed_area(outline) > 0, k == 0);
        }
    }
    EXPECT_EQ(polygons, 3) << "canvas, border, keep-out";
}

TEST(GeoJsonExport, GdalReadsTheSameLinesAndProperties) {
    if (!there_is("ogrinfo")) GTEST_SKIP() << "ogrinfo (gdal-bin) is not at hand";
    const Plan plan = beach_plan();
    const Scratch file(exports::geojson(plan).files.at(0).bytes, ".geojson");
    const std::string printed = printed_by("ogrinfo -al -ro " + file.path());
    EXPECT_NE(printed.find("WGS 84"), std::string::npos);
    EXPECT_NE(printed.find("why (String) = tool 2"), std::string::npos);
    std::vector<Track> read;
    bool raked = false;
    for (const std::string& line : lines_of(printed)) {
        if (line.find("what (String) = ") != std::string::npos) raked = line.ends_with("= raked");
        const auto at = line.find("LINESTRING (");
        if (!raked || at == std::string::npos) continue;
        read.push_back({true, {}});
        std::istringstream positions(line.substr(at + 12));
        Geographic p;
        for (char after = ','; after == ',' && positions >> p.longitude >> p.latitude >> after;)
            read.back().points.push_back(read_back(plan.options.site.at, p));
    }
    expect_same(read, only_down(tracks_of(plan, true)), millimetre);
}

TEST(GeoJsonExport, WithoutASiteItWarns) {
    Plan plan = beach_plan();
    plan.options.site.known = false;
    const auto written = exports::geojson(plan);
    ASSERT_EQ(written.warnings.size(), 1u);
    EXPECT_EQ(written.warnings[0].place, "site");
}

}  // namespace
}  // namespace strandline
