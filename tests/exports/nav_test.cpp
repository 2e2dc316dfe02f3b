#include "exports/drive.hpp"
#include "result/exports/exports.hpp"

namespace strandline {
namespace {

using namespace testing;

/// nav_msgs/msg/Path: header, poses of geometry_msgs/msg/PoseStamped.
Polyline positions(const Json& path) {
    Polyline line;
    for (const Json& pose : path.at("poses"))
        line.push_back({pose.at("pose").at("position").at("x"), pose.at("pose").at("position").at("y")});
    return line;
}
Polyline local_path(const Plan& plan) {
    Polyline line;
    for (const Sample& sample : plan.samples) line.push_back(to_local(plan.options.site.at, sample.pose.at));
    return line;
}

TEST(NavPath, ReadBackByAnotherParserItIsTheRobotsPathInItsMap) {
    if (!there_is_yaml()) GTEST_SKIP() << "python3-yaml is not at hand";
    const Plan plan = beach_plan();
    const auto documents = read_yaml(exports::nav_path(plan).files.at(0).bytes);
    ASSERT_EQ(documents.size(), 1u);
    const Json& path = documents[0];
    EXPECT_EQ(path.at("header").at("frame_id"), "map");
    EXPECT_LT(apart(positions(path), local_path(plan)), 1e-5);
    ASSERT_EQ(path.at("poses").size(), plan.samples.size());
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
        const Json& pose = path.at("poses")[i];
        const Json& q = pose.at("pose").at("orientation");
        const double heading = 2 * std::atan2(q.at("z").get<double>(), q.at("w").get<double>());
        EXPECT_NEAR(wrap_angle(heading - (plan.samples[i].pose.heading - 0.6)), 0, 1e-6) << i;
        const Json& stamp = pose.at("header").at("stamp");
        EXPECT_NEAR(stamp.at("sec").get<double>() + 1e-9 * stamp.at("nanosec").get<double>(),
                    plan.samples[i].t, 1e-8);
        EXPECT_TRUE(pose.at("pose").at("position").at("x").is_number_float());
    }
}

TEST(FollowPath, IsOneGoalOfThoseFieldsThatEveryReleaseHas) {
    if (!there_is_yaml()) GTEST_SKIP() << "python3-yaml is not at hand";
    Plan plan = beach_plan();
    plan.options.nav.frame = "odom \"1\"";
    plan.options.nav.controller = "Rake";
    const auto documents = read_yaml(exports::follow_path(plan).files.at(0).bytes);
    ASSERT_EQ(documents.size(), 1u);
    EXPECT_EQ(documents[0].size(), 3u);
    EXPECT_EQ(documents[0].at("controller_id"), "Rake");
    EXPECT_EQ(documents[0].at("goal_checker_id"), "");
    EXPECT_EQ(documents[0].at("path").at("header").at("frame_id"), "odom \"1\"");
    EXPECT_LT(apart(positions(documents[0].at("path")), local_path(plan)), 1e-5);
}

TEST(FollowPath, GoalsByStrokesMeetEndToEnd) {
    if (!there_is_yaml()) GTEST_SKIP() << "python3-yaml is not at hand";
    Plan plan = beach_plan();
    plan.options.nav.goals = "strokes";
    const std::string text = exports::follow_path(plan).files.at(0).bytes;
    const auto documents = read_yaml(text);
    ASSERT_EQ(documents.size(), 7u) << "four strokes and what is between them";
    EXPECT_NE(text.find("# goal 1 of 7: rake down, stroke 0"), std::string::npos);
    EXPECT_NE(text.find("# goal 2 of 7: rake up"), std::string::npos);
    for (std::size_t k = 1; k < documents.size(); ++k)
        EXPECT_EQ(positions(documents[k - 1].at("path")).back(), positions(documents[k].at("path")).front());
}

TEST(NavPath, AnEmptyPlanIsAnEmptyPathAndSaidSo) {
    const auto written = exports::nav_path(Plan{});
    EXPECT_EQ(written.warnings.size(), 1u);
    if (!there_is_yaml()) GTEST_SKIP() << "python3-yaml is not at hand";
    EXPECT_EQ(read_yaml(written.files.at(0).bytes).at(0).at("poses").size(), 0u);
}

}  // namespace
}  // namespace strandline
