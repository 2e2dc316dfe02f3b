#include "exports/drive.hpp"
#include "result/exports/exports.hpp"

namespace strandline {
namespace {

using namespace testing;

std::string text_of(const Outcome<exports::Written>& written) {
    EXPECT_TRUE(written) << (written ? "" : sentence(written.error()));
    return written ? written->files.at(0).bytes : "QGC WPL 110\n";
}
bool warns_of(const exports::Written& written, const std::string& words) {
    return std::ranges::any_of(
        written.warnings, [&](const Warning& w) { return sentence(w).find(words) != std::string::npos; });
}

TEST(Wpl, ReadBackItIsTheDriveWithinTheDegreesAndSaysSo) {
    const Plan plan = beach_plan();
    const auto written = exports::wpl(plan);
    expect_same(driven(read_wpl(text_of(written)), plan.options.site.at, 1900), tracks_of(plan, false),
                by_degrees);
    EXPECT_TRUE(warns_of(*written, "1e-7 degrees"));
    EXPECT_TRUE(warns_of(*written, "one servo lifts all 7 pins, and 7.4 of 13.6 m"));
    EXPECT_FALSE(warns_of(*written, "no place on earth"));
}

TEST(QgcPlan, HoldsTheSameMissionItemByItem) {
    const Plan plan = beach_plan();
    const auto items = read_wpl(text_of(exports::wpl(plan)));
    const auto same = read_qgc_plan(text_of(exports::qgc_plan(plan)));
    ASSERT_EQ(items.size(), same.size());
    for (std::size_t k = 0; k < items.size(); ++k) {
        EXPECT_EQ(items[k].command, same[k].command);
        EXPECT_EQ(items[k].frame, same[k].frame);
        EXPECT_EQ(items[k].at, same[k].at);
        for (int p = 0; p < 4; ++p) EXPECT_EQ(items[k].parameters[p], same[k].parameters[p]);
    }
}

TEST(QgcPlan, FencesAreWhereTheCanvasHasThem) {
    const Plan plan = beach_plan();
    const Json fences = Json::parse(text_of(exports::qgc_plan(plan))).at("geoFence").at("polygons");
    ASSERT_EQ(fences.size(), 2u);
    EXPECT_EQ(fences[0].at("inclusion"), true);
    EXPECT_EQ(fences[1].at("inclusion"), false);
    const auto corner = fences[1].at("polygon").at(2);
    EXPECT_LT(distance(read_back(plan.options.site.at, {corner.at(0), corner.at(1)}), {9, 9}), 0.01);
}

TEST(Wpl, TheRakeMovesBehindTheWaypointAtWhichItMoves) {
    const auto items = read_wpl(text_of(exports::wpl(beach_plan())));
    EXPECT_EQ(items[1].command, 183);
    EXPECT_EQ(items[1].parameters[1], 1100) << "up before anything is driven";
    int downs = 0, stops = 0;
    for (std::size_t k = 1; k < items.size(); ++k) {
        downs += items[k].command == 183 && items[k].parameters[1] == 1900;
        stops += items[k].command == 17;
        if (items[k].command == 183) {
            EXPECT_EQ(items[k].parameters[0], 9);
        }
    }
    EXPECT_EQ(downs, 4) << "one a stroke";
    EXPECT_EQ(stops, 1) << "where the tool changes";
    EXPECT_EQ(items.back().parameters[1], 1100);
}

TEST(Wpl, ARobotThatBacksUpIsToldSoWhereItDoes) {
    Plan plan = beach_plan();
    const auto before = read_wpl(text_of(exports::wpl(plan)));
    const auto reverses = [](const auto& items) {
        std::vector<double> told;
        for (const auto& item : items)
            if (item.command == 194) told.push_back(item.parameters[0]);
        return told;
    };
    EXPECT_TRUE(reverses(before).empty());
    // the whole drive in reverse: the readers look at places only
    for (Sample& sample : plan.samples) sample.speed = -sample.speed;
    const auto told = reverses(read_wpl(text_of(exports::wpl(plan))));
    ASSERT_GE(told.size(), 2u);
    for (std::size_t k = 0; k < told.size(); ++k) EXPECT_EQ(told[k], k % 2 == 0 ? 1 : 0);
    EXPECT_EQ(told.back(), 0);
    const auto path = exports::nav_path(plan);
    EXPECT_TRUE(warns_of(path, "allow_reversing"));
}

TEST(Wpl, ASlowerRakeIsASpeedOfItsOwn) {
    Plan plan = beach_plan();
    plan.robot.travel_speed = 0.5;
    std::vector<double> speeds;
    for (const MissionItem& item : read_wpl(text_of(exports::wpl(plan))))
        if (item.command == 178) speeds.push_back(item.parameters[1]);
    ASSERT_EQ(speeds.size(), 9u);
    EXPECT_EQ(speeds[0], 0.5);
    EXPECT_EQ(speeds[1], 0.2);
}

TEST(Wpl, ItIsThinnedToTheLimitWithinTheToleranceOrRefused) {
    Plan plan = beach_plan();
    const auto full = read_wpl(text_of(exports::wpl(plan))).size();
    plan.options.mission.items = static_cast<int>(full) - 8;
    const auto fewer = read_wpl(text_of(exports::wpl(plan)));
    EXPECT_LE(static_cast<int>(fewer.size()), plan.options.mission.items);
    expect_same(driven(fewer, plan.options.site.at, 1900), tracks_of(plan, false),
                plan.options.mission.tolerance + by_degrees);
    plan.options.mission.items = 12;
    const auto refused = exports::wpl(plan);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().reason.find("holds 12"), std::string::npos) << refused.error().reason;
    EXPECT_NE(refused.error().remedy.find("split"), std::string::npos);
    EXPECT_NE(refused.error().remedy.find("no tolerance will do"), std::string::npos);
}

TEST(Wpl, ARefusalNamesTheToleranceThatWouldDo) {
    Plan plan = beach_plan();
    plan.options.mission.tolerance = 0.001;
    const int most = static_cast<int>(read_wpl(text_of(exports::wpl(plan))).size()) - 10;
    plan.options.mission.items = most;
    const auto refused = exports::wpl(plan);
    ASSERT_FALSE(refused);
    const std::string& remedy = refused.error().remedy;
    const std::string words = "mission.tolerance to ";
    ASSERT_NE(remedy.find(words), std::string::npos) << remedy;
    const double enough = std::stod(remedy.substr(remedy.find(words) + words.size()));
    EXPECT_GT(enough, plan.options.mission.tolerance);
    plan.options.mission.tolerance = enough;
    EXPECT_LE(static_cast<int>(read_wpl(text_of(exports::wpl(plan))).size()), most) << "what is advised does";
    plan.options.mission.tolerance = enough - 0.002;
    EXPECT_FALSE(exports::wpl(plan)) << "a little less does not";
}

TEST(Wpl, WithoutASiteItLiesAtZeroAndWarns) {
    Plan plan = beach_plan();
    plan.options.site = {};
    const auto written = exports::wpl(plan);
    ASSERT_TRUE(written);
    EXPECT_TRUE(warns_of(*written, "no place on earth is set: latitude 0, longitude 0"));
    expect_same(driven(read_wpl(written->files[0].bytes), {}, 1900), tracks_of(plan, false), by_degrees);
}

TEST(Wpl, APlanWithoutDriveIsRefused) {
    EXPECT_FALSE(exports::wpl(Plan{}));
    EXPECT_FALSE(exports::qgc_plan(Plan{}));
}

TEST(Wpl, PinsThatTakeTimeAreToldEarlier) {
    Plan plan = beach_plan();
    const auto first_down = [&] {
        const auto items = read_wpl(text_of(exports::wpl(plan)));
        bool up = false;
        for (std::size_t k = 3; k < items.size(); ++k) {
            up = up || (items[k].command == 183 && items[k].parameters[1] == 1100);
            if (up && items[k].command == 183 && items[k].parameters[1] == 1900)
                return read_back(plan.options.site.at, items[k - 1].at);
        }
        return Point{};
    };
    const Point in_time = first_down();
    plan.robot.lift_delay = 0.5;
    EXPECT_NEAR(distance(first_down(), in_time), 0.1, 0.02) << "0.2 m/s for half a second";
}

}  // namespace
}  // namespace strandline
