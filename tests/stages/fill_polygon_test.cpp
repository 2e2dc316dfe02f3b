#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
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
    ASSERT_EQ(task->warnings.size(), 1u);
    EXPECT_EQ(task->warnings[0].place, "a.json, outer");
    EXPECT_NE(task->warnings[0].reason.find("at (1, 1)"), std::string::npos) << task->warnings[0].reason;
}

/// The one warning of a polygon whose area is what it should be.
void expect_repaired(const char* text, double area_left, const char* place, const char* reason) {
    const auto task = read_polygon(text, "a.json");
    ASSERT_TRUE(task) << text;
    EXPECT_NEAR(area(task->regions), area_left, 1e-6) << text;
    ASSERT_EQ(task->warnings.size(), 1u) << text;
    EXPECT_EQ(task->warnings[0].place, place);
    EXPECT_NE(task->warnings[0].reason.find(reason), std::string::npos) << task->warnings[0].reason;
}

TEST(StageFill, InvalidAreasAreRepairedEvenOddAndSaidByPlace) {
    // a pentagram on the circle of radius 1: its middle is outside
    const double tips =
        5 * std::sin(pi / 5) * std::sin(pi / 10) / std::sin(7 * pi / 10);  // of the star's area
    const double middle = 2.5 * std::pow(std::cos(2 * pi / 5) / std::cos(pi / 5), 2) * std::sin(2 * pi / 5);
    std::string star;
    for (int k = 0; k < 5; ++k)
        star += fmt::format("{}[{},{}]", k ? "," : "", std::cos(4 * pi * k / 5), std::sin(4 * pi * k / 5));
    expect_repaired((R"({"polygon":{"outer":[)" + star + "]}}").c_str(), tips - middle, "a.json, outer",
                    "at 5 places");
    // a slit of no width to a hole, and one that ends blind
    expect_repaired(
        R"({"polygon":{"outer":[[0,0],[4,0],[4,4],[0,4],[0,2],[1,2],[1,3],[3,3],[3,1],[1,1],[1,2],[0,2]]}})",
        12, "a.json, outer", "touches or crosses itself");
    expect_repaired(R"({"polygon":{"outer":[[0,0],[4,0],[4,4],[2,4],[2,2],[2,4],[0,4]]}})", 16,
                    "a.json, outer", "touches or crosses itself");
    // holes that share a corner, one that sticks out, one that is outside
    expect_repaired(
        R"({"polygon":{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[1,1],[2,1],[2,2],[1,2]],[[2,2],[3,2],[3,3],[2,3]]]}})",
        79, "a.json, hole 1", "touches or crosses a.json, hole 0 at (2, 2)");
    expect_repaired(
        R"({"polygon":{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[8,1],[10,1],[10,2],[8,2]]]}})", 80,
        "a.json, hole 0", "the outline at 2 places");
    expect_repaired(R"({"polygon":{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[20,1],[21,1],[21,2]]]}})", 81,
                    "a.json, hole 0", "outside");
    expect_repaired(R"({"polygon":{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[1,1],[2,1],[3,1]]]}})", 81,
                    "a.json, hole 0", "no area");
    // points given twice; the closing point is no repetition
    expect_repaired(R"({"polygon":{"outer":[[0,0],[4,0],[4,0],[4,4],[4,4],[0,4],[0,0]]}})", 16,
                    "a.json, outer, point 2", "2 points");
}

TEST(StageFill, ValidAreasAreNotComplainedOf) {
    for (const char* text : {R"({"polygon":{"outer":[[0,0],[2,0],[4,0],[4,4],[0,4],[0,2]]}})",
                             R"({"polygon":{"outer":[[0,0],[4,0],[4,4],[2,1],[0,4]]}})",
                             R"({"polygon":{"outer":[[0,0],[9,0],[9,9]],"holes":[[[6,1],[7,1],[7,2]]]}})"})
        EXPECT_TRUE(read_polygon(text, "a.json")->warnings.empty()) << text;
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
    const auto moves = rake::moves_of({line({0, 0}, {1, 0}), line({1, 2}, {0, 2}), line({0, 2}, {0, 3})},
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
