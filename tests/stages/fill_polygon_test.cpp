#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "result/stages/stages.hpp"

namespace strandline {
namespace {

using nlohmann::json;
using stages::read_polygon;

TEST(StageFill, APolygonWithAHoleIsRead) {
    const auto task = read_polygon(
        R"({"polygon":{"outer":[[0,0],[4,0],[4,4],[0,4],[0,0]],"holes":[[[1,1],[2,1],[2,2],[1,2]]]},"width":0.4})",
        "a.json");
    ASSERT_TRUE(task);
    EXPECT_EQ(task->width, 0.4);
    EXPECT_TRUE(task->warnings.empty());
    ASSERT_EQ(task->regions.size(), 1u);
    EXPECT_NEAR(area(task->regions), 15, 1e-7);
}

TEST(StageFill, ABowTieIsRepairedAndSaid) {
    const auto task = read_polygon(R"({"polygon":{"outer":[[0,0],[2,2],[2,0],[0,2]]}})", "a.json");
    ASSERT_TRUE(task);
    EXPECT_FALSE(task->width);
    EXPECT_EQ(task->regions.size(), 2u);
    EXPECT_EQ(task->warnings.size(), 1u);
}

TEST(StageFill, HolesThatOverlapStayHoles) {
    const auto task = read_polygon(
        R"({"polygon":{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[1,1],[4,1],[4,4],[1,4]],[[2,2],[5,2],[5,5],[2,5]]]}})",
        "a.json");
    ASSERT_TRUE(task);
    EXPECT_NEAR(area(task->regions), 81 - 14, 1e-6);
}

TEST(StageFill, BadInputIsRefusedByPlace) {
    const auto place = [](const char* text) { return read_polygon(text, "a.json").error().place; };
    const auto reason = [](const char* text) { return read_polygon(text, "a.json").error().reason; };
    EXPECT_NE(reason("{\"polygon\":").find("byte"), std::string::npos);
    EXPECT_NE(reason("").find("not JSON"), std::string::npos);
    EXPECT_EQ(reason("[1,2]"), "has no polygon");
    EXPECT_EQ(place(R"({"polygon":{"outer":[[0,0],[1,"x"],[1,1]]}})"), "a.json, outer, point 1");
    EXPECT_EQ(place(R"({"polygon":{"outer":[[0,0],[1e300,0],[1,1]]}})"), "a.json, outer, point 1");
    EXPECT_EQ(place(R"({"polygon":{"outer":[[0,0],[1,0],[1,1]]},"width":-1})"), "a.json, width");
    EXPECT_EQ(reason(R"({"polygon":{"outer":[[0,0],[1,0],[0,0]]}})"),
              "has fewer than three different points");
    EXPECT_EQ(reason(R"({"polygon":{"outer":[[0,0],[1,0],[2,0]]}})"), "has no area");
    EXPECT_EQ(place(R"({"polygon":{"outer":[[0,0],[1,0],[1,1]],"holes":[[[0,0],[1]]]}})"),
              "a.json, hole 0, point 1");
}

TEST(StageFill, StrokesComeBackInTheSameObjectWithTheMovesBetween) {
    const auto task =
        read_polygon(R"({"name":"x","polygon":{"outer":[[0,0],[4,0],[4,4],[0,4]]},"width":2})", "a.json");
    ASSERT_TRUE(task);
    const auto line = [](Point a, Point b) {
        Stroke stroke;
        stroke.rake_path = {straight({a, heading(b - a)}, distance(a, b))};
        return stroke;
    };
    const auto moves = fill::moves_of({line({0, 0}, {1, 0}), line({1, 2}, {0, 2}), line({0, 2}, {0, 3})},
                                      {{}, {{2, 1}}}, {}, 7, 0.01);
    const std::string text = stages::write_moves(*task, 0.5, moves, {});
    const json out = json::parse(text);
    EXPECT_EQ(out["name"], "x");
    EXPECT_EQ(out["width"], 0.5);
    ASSERT_EQ(out["strokes"].size(), 4u);  // down, up, down, down: the last two touch
    EXPECT_EQ(out["strokes"][0]["down"], true);
    EXPECT_EQ(out["strokes"][1]["down"], false);
    ASSERT_EQ(out["strokes"][1]["pts"].size(), 3u);
    EXPECT_EQ(out["strokes"][1]["pts"][1], (json{2, 1}));
    EXPECT_EQ(out["strokes"][3]["down"], true);
}

}  // namespace
}  // namespace strandline
