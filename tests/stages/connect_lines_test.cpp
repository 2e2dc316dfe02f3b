#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

Outcome<Pair> read(const std::string& line, const PairDefaults& defaults = {}) {
    return read_pair(line, 7, defaults);
}

TEST(ConnectLines, APairsOwnFieldsWinOverDefaults) {
    const auto pair =
        read(R"({"start":[1,2,3],"end":[4,5,6],"R":2,"sigma":0.7,"kappa0":0.5,"kappa1":-0.25})", {0.3, 9});
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->from.pose, (Pose{{1, 2}, 3}));
    EXPECT_EQ(pair->to.pose, (Pose{{4, 5}, 6}));
    EXPECT_EQ(pair->limits.radius, 2);
    EXPECT_EQ(pair->limits.sharpness, 0.7);
    EXPECT_EQ(pair->from.curvature, 0.5);
    EXPECT_EQ(pair->to.curvature, -0.25);
}

TEST(ConnectLines, SharpnessFollowsTheRadiusWhenNothingSaysOtherwise) {
    EXPECT_DOUBLE_EQ(read(R"({"start":[0,0,0],"end":[1,0,0]})")->limits.sharpness, 10);
    EXPECT_DOUBLE_EQ(read(R"({"start":[0,0,0],"end":[1,0,0],"R":5})")->limits.sharpness, 0.1);
    EXPECT_DOUBLE_EQ(read(R"({"start":[0,0,0],"end":[1,0,0],"R":5})", {0.5, 3})->limits.sharpness, 3);
}

TEST(ConnectLines, EveryFaultIsNamedWithItsLine) {
    for (const char* line :
         {"", "{", "[]", "3", R"({"start":[0,0,0]})", R"({"start":[0,0],"end":[1,0,0]})",
          R"({"start":[0,0,"east"],"end":[1,0,0]})", R"({"start":[0,0,1e999],"end":[1,0,0]})",
          R"({"start":[0,0,1e308],"end":[1,0,0]})", R"({"start":[0,0,0],"end":[1,0,0],"R":0})",
          R"({"start":[0,0,0],"end":[1,0,0],"R":"wide"})", R"({"start":[0,0,0],"end":[1,0,0],"sigma":-1})",
          R"({"start":[0,0,0],"end":[1,0,0],"kappa0":2.1})", R"({"start":[0,0,0],"end":[9e6,0,0]})",
          R"({"start":[0,0,0],"end":[1,0,0],"obstacles":[[1,2]]})",
          R"({"start":[0,0,0],"end":[1,0,0],"obstacles":[[]]})",
          R"({"start":[0,0,0],"end":[1,0,0],"clearance":-1})", R"({"start":[0,0,NaN],"end":[1,0,0]})"}) {
        const auto pair = read(line);
        ASSERT_FALSE(pair) << line;
        EXPECT_EQ(pair.error().place, "line 7") << line;
        EXPECT_FALSE(pair.error().reason.empty()) << line;
    }
}

TEST(ConnectLines, ACurveIsThePairWithLimitsAndEvenSamples) {
    const auto pair = read(R"({"start":[0,0,0],"end":[3,1,1],"id":"a","note":[1]})");
    ASSERT_TRUE(pair);
    const auto c = connect::connection(pair->from, pair->to, {.limits = pair->limits});
    const auto out = nlohmann::json::parse(write_curve(*pair, c, std::nullopt));
    EXPECT_EQ(out["id"], "a");
    EXPECT_EQ(out["note"][0], 1);
    EXPECT_EQ(out["R"], 0.5);
    EXPECT_EQ(out["sigma"], 10);
    EXPECT_FALSE(out.contains("ok"));
    const auto& samples = out["samples"];
    EXPECT_GE(samples.size(), length(c.curve) / 0.005);
    EXPECT_NEAR(samples.back()[0], 3, 1e-8);
    EXPECT_NEAR(samples.back()[1], 1, 1e-8);
}

TEST(ConnectLines, EvenATurnOnTheSpotHasNineSamples) {
    const auto pair = read(R"({"start":[1,1,0],"end":[1,1,2]})");
    const auto c = connect::connection(pair->from, pair->to, {.style = connect::Style::straight});
    EXPECT_EQ(nlohmann::json::parse(write_curve(*pair, c, std::nullopt))["samples"].size(), 9u);
}

TEST(ConnectLines, AnObstacleOnTheWayIsSeenHoweverThin) {
    const auto hit = [&](const std::string& ring, const std::string& clearance) {
        const auto pair = read(R"({"start":[0,0,0],"end":[10,0,0],"obstacles":[)" + ring +
                               R"(],"clearance":)" + clearance + "}");
        return hits_obstacles(*pair,
                              connect::connection(pair->from, pair->to, {.limits = pair->limits}).curve);
    };
    EXPECT_TRUE(hit("[[4,-1],[5,-1],[5,1],[4,1]]", "0"));
    EXPECT_TRUE(hit("[[4.0021,-1],[4.0022,-1],[4.0022,1]]", "0"));
    EXPECT_TRUE(hit("[[-5,-5],[15,-5],[15,5],[-5,5]]", "0")) << "inside";
    EXPECT_FALSE(hit("[[4,0.3],[5,0.3],[5,1],[4,1]]", "0.25"));
    EXPECT_TRUE(hit("[[4,0.3],[5,0.3],[5,1],[4,1]]", "0.35"));
}

TEST(ConnectLines, AFailureIsWrittenWithItsReason) {
    const auto pair = read(R"({"start":[0,0,0],"end":[1,0,0],"samples":[[9,9]]})");
    const auto c = connect::connection(pair->from, pair->to, {.limits = pair->limits});
    const auto out = nlohmann::json::parse(write_curve(*pair, c, "in the way"));
    EXPECT_EQ(out["ok"], false);
    EXPECT_EQ(out["reason"], "in the way");
    EXPECT_EQ(out["samples"][0][0], 0);
}

}  // namespace
}  // namespace strandline::stages
