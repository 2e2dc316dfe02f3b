// A real drawing on a beach, exported to everything and read back; flags, fences and refusals.
#include "exports/readers.hpp"
#include "program.hpp"

namespace strandline::test {
namespace {

using namespace testing;

const std::string starfish = "'" STRANDLINE_SOURCE "/drawings/starfish.svg'";
const Site beach{{47.3769, 8.5417}, 0, 0, 0, 20 * pi / 180};
const std::string site = " --set site.latitude=47.3769 --set site.longitude=8.5417 --set site.heading=20 ";

/// The CSV's columns, cut where pins go down or up.
std::vector<Track> planned(const std::string& csv, bool rake) {
    const auto lines = lines_of(csv);
    std::vector<Track> tracks;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        double v[11];
        std::istringstream in(lines[k]);
        for (double& value : v) {
            in >> value;
            in.ignore(1);
        }
        const Point at = rake ? Point{v[9], v[10]} : Point{v[2], v[3]};
        if (!tracks.empty()) tracks.back().points.push_back(at);
        if (const bool down = v[8] != 0; tracks.empty() || tracks.back().down != down)
            tracks.push_back({down, {at}});
    }
    return tracks;
}
Polyline joined(const std::vector<Track>& tracks, bool down) {
    Polyline line;
    for (const Track& track : tracks)
        if (track.down == down) line.insert(line.end(), track.points.begin(), track.points.end());
    return line;
}
/// Farthest corner of `points`, or of some 1,500 of them, from the tracks of that kind.
double farthest(const Polyline& points, const std::vector<Track>& tracks, bool down) {
    double most = points.empty() ? 1e9 : 0;
    for (std::size_t k = 0; k < points.size(); k += 1 + points.size() / 1500) {
        const Point p = points[k];
        double nearest = 1e9;
        for (const Track& track : tracks)
            if (track.down == down && track.points.size() > 1)
                nearest = std::min(nearest, distance_to(track.points, p));
        most = std::max(most, nearest);
    }
    return most;
}
void expect_near(const std::vector<Track>& read, const std::vector<Track>& plan, bool down,
                 double tolerance) {
    EXPECT_LT(farthest(joined(read, down), plan, down), tolerance);
    EXPECT_LT(farthest(joined(plan, down), read, down), tolerance);
}

TEST(Export, AStarfishIsReadBackFromEveryFormat) {
    const Folder folder;
    ASSERT_EQ(run(folder, "-q plan " + starfish + site + "-o plan.json").exit, 0);
    const auto exported = [&](const std::string& format) {
        const Result result = run(folder, "export plan.json --format " + format);
        EXPECT_EQ(result.exit, 0) << result.err;
        EXPECT_EQ(result.err.find("no place on earth"), std::string::npos) << "the plan carries its site";
        return result.out;
    };
    const std::string csv = exported("csv");
    const auto rake = planned(csv, true), robot = planned(csv, false);

    std::vector<Track> lines;
    const Json map = Json::parse(exported("geojson"));
    for (const Json& feature : map.at("features")) {
        const Json& geometry = feature.at("geometry");
        if (geometry.at("type") != "LineString") continue;
        const std::string what = feature.at("properties").at("what");
        if (what == "driven, rake down") continue;
        lines.push_back({what == "raked", {}});
        for (const Json& p : geometry.at("coordinates"))
            lines.back().points.push_back(read_back(beach, {p.at(1), p.at(0)}));
    }
    expect_near(lines, rake, true, 1e-3);
    expect_near(lines, robot, false, 1e-3);

    const double by_tolerance = 0.012 + 0.05;  // mission.tolerance, where it must be thinned
    for (const auto& items : {read_wpl(exported("wpl")), read_qgc_plan(exported("qgc-plan"))}) {
        EXPECT_LE(items.size(), 724u);
        const auto tracks = driven(items, beach, 1900);
        expect_near(tracks, robot, true, by_tolerance);
        expect_near(tracks, robot, false, by_tolerance);
    }
    const Result exact = run(folder, "export plan.json --format wpl --set mission.items=60000");
    const auto tracks = driven(read_wpl(exact.out), beach, 1900);
    expect_near(tracks, robot, true, 0.012);
    expect_near(tracks, robot, false, 0.012);

    expect_near(read_gcode(exported("gcode")).tracks, rake, true, 1e-3);
    const Polyline ball = read_thr(exported("thr"));
    EXPECT_LT(farthest(joined(rake, true), {{true, ball}}, true), 1e-3) << "all that is raked is drawn";
    if (!there_is_yaml()) GTEST_SKIP() << "python3-yaml is not at hand";
    Polyline path;  // metres of the robot's map, turned back onto the canvas
    const auto goals = read_yaml(exported("follow-path"));
    for (const Json& pose : goals.at(0).at("path").at("poses"))
        path.push_back(from_local(
            beach, {pose.at("pose").at("position").at("x"), pose.at("pose").at("position").at("y")}));
    EXPECT_LT(farthest(path, {{true, joined(robot, true)}, {true, joined(robot, false)}}, true), 1e-3);
}

TEST(Export, TwiceIsTheSameBytesPdfToo) {
    const Folder folder;
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><path d='M1 1L8 8' "
          "stroke='black'/></svg>");
    ASSERT_EQ(run(folder, "-q plan in.svg -o plan.json").exit, 0);
    for (const std::string format : {"pdf", "geojson", "wpl", "thr", "gcode", "follow-path"}) {
        const Result once = run(folder, "-q export plan.json --format " + format),
                     again = run(folder, "-q export plan.json --format " + format);
        EXPECT_EQ(once.exit, 0) << format << once.err;
        EXPECT_EQ(once.out, again.out) << format;
        EXPECT_GT(once.out.size(), 100u) << format;
    }
    EXPECT_TRUE(run(folder, "-q export plan.json --format pdf").out.starts_with("%PDF-1."));
    EXPECT_EQ(run(folder, "render plan.json -o plan.pdf").exit, 0);
}

TEST(Export, WithoutASiteOneIsWarnedAndWhatIsPlannedStays) {
    const Folder folder;
    ASSERT_EQ(run(folder, "-q plan " + starfish + " -o plan.json").exit, 0);
    EXPECT_NE(run(folder, "export plan.json --format wpl").err.find("latitude 0, longitude 0 is taken"),
              std::string::npos);
    EXPECT_EQ(run(folder, "export plan.json --format wpl" + site).err.find("latitude 0"), std::string::npos);
    expect_refused(folder, "export plan.json --format wpl --set fill.style=zigzag -o out", 2,
                   "is decided when the drawing is planned");
    expect_refused(folder, "export plan.json --format wpl --set mission.items=50 -o out", 1,
                   "the autopilot holds 50");
}

TEST(Locate, FlagsGiveASiteAndPolesThatPlanAndExportTake) {
    const Folder folder;
    std::string flags = "name,x,y,latitude,longitude,radius\n";
    for (const Point p : {Point{0, 0}, Point{14, 0}, Point{14, 14}}) {
        const Geographic at = to_geographic(beach, p);
        flags += "flag," + std::to_string(p.x) + "," + std::to_string(p.y) + "," +
                 std::to_string(at.latitude) + "," + std::to_string(at.longitude) + ",\n";
    }
    const Geographic pole = to_geographic(beach, {12, 12.5});
    write(folder / "flags.csv", flags + "pole,,," + std::to_string(pole.latitude) + "," +
                                    std::to_string(pole.longitude) + ",30cm\n");
    const Result located = run(folder, "locate flags.csv -o site.toml");
    EXPECT_EQ(located.exit, 0) << located.err;
    EXPECT_NE(located.err.find("cm off"), std::string::npos);
    ASSERT_EQ(run(folder, "-q plan " + starfish + " --config site.toml -o plan.json").exit, 0);
    const Json plan = Json::parse(read(folder / "plan.json"));
    EXPECT_NEAR(std::stod(plan.at("options").at("site.latitude").get<std::string>()), 47.3769, 1e-5);
    EXPECT_EQ(plan.at("options").at("site.known"), "on");
    EXPECT_NE(plan.at("options").at("field.keep_out"), "");
    EXPECT_EQ(run(folder, "locate flags.csv -o site.toml --most 1mm").exit, 3)
        << "degrees of six decimals are some centimetres";
    const Result json = run(folder, "-q --json locate flags.csv");
    EXPECT_EQ(Json::parse(json.out).at("markers").size(), 4u);
    write(folder / "one.csv", "name,x,y,latitude,longitude\na,0,0,47,8\n");
    expect_refused(folder, "locate one.csv -o out", 1, "only one");
}

TEST(Fences, OfGeoJsonAreThoseOfTheCanvas) {
    const Folder folder;
    const auto area = [&](const std::string& name, const Polygon& outline) {
        Json ring = Json::array();
        for (std::size_t k = 0; k <= outline.size(); ++k) {
            const Geographic at = to_geographic(beach, outline[k % outline.size()]);
            ring.push_back({at.longitude, at.latitude});
        }
        write(folder / name, Json{{"type", "Polygon"}, {"coordinates", {ring}}}.dump());
    };
    area("border.geojson", {{-3, -3}, {17, -3}, {17, 17}, {-3, 17}});
    area("rock.geojson", {{12, 12}, {13, 12}, {13, 13}});
    const std::string fences = " --border border.geojson --keep-out rock.geojson --keep-out '0,0 1,0 0,1' ";
    const Result result = run(folder, "plan " + starfish + site + fences + "-o plan.json");
    EXPECT_EQ(result.exit, 0) << result.err;
    const Json plan = Json::parse(read(folder / "plan.json"));
    double x = 0, y = 0;
    const std::string border = plan.at("options").at("field.border");
    ASSERT_EQ(std::sscanf(border.c_str(), "%lf,%lf", &x, &y), 2) << border;
    EXPECT_LT(distance({x, y}, {-3, -3}), 1e-5);
    const std::string keep_out = plan.at("options").at("field.keep_out");
    EXPECT_NE(keep_out.find("; 0,0 1,0 0,1"), std::string::npos) << keep_out;
    expect_refused(folder, "plan " + starfish + " --border border.geojson -o out", 2, "km from the canvas");
}

TEST(Tools, ALayerOrAColourEachIsDrawnInOneGo) {
    const Folder folder;
    std::string shapes;
    for (int k = 0; k < 6; ++k)
        shapes += "<path d='M" + std::to_string(10 + 10 * k) + " 10v60' fill='none' stroke='" +
                  (k % 2 ? "red" : "black") + "'/>";
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + shapes + "</svg>");
    ASSERT_EQ(
        run(folder, "-q plan in.svg --robot plotter --canvas A5 --set drawing.tools=colour -o plan.json")
            .exit,
        0);
    const Result result = run(folder, "-q export plan.json --format gcode --set 'gcode.stop=T{tool} M6'");
    const Program program = read_gcode(result.out);
    EXPECT_EQ(std::ranges::count(program.others, "T2 M6"), 1);
    EXPECT_EQ(std::ranges::count(program.others, "T1 M6"), 0) << "the first tool is in from the start";
}

}  // namespace
}  // namespace strandline::test
