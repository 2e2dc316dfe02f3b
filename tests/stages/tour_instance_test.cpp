#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

std::string refused(std::string_view text) {
    const auto instance = read_instance(text, "x.json");
    return instance ? "accepted" : sentence(instance.error());
}

TEST(TourInstance, EveryOptionalKeyIsRead) {
    const auto instance = read_instance(R"({"start": [1, 2], "end": [3, 4], "elements": [
        {"closed": false, "points": [[0, 0], [1, 0]], "direction": "backward"},
        {"closed": true, "points": [[0, 0], [1, 0], [0, 1]], "entry": 2, "sense": "cw"}],
        "links": [[[0, 1], [1, 2]]], "before": [[0, 1]], "groups": [[0], [1]], "group_order": "kept"})",
                                        "x.json");
    ASSERT_TRUE(instance) << sentence(instance.error());
    const tour::Problem& problem = instance->problem;
    EXPECT_TRUE(instance->warnings.empty());
    EXPECT_EQ(problem.start, (Point{1, 2}));
    EXPECT_EQ(problem.end, tour::End::at_point);
    EXPECT_EQ(problem.end_point, (Point{3, 4}));
    EXPECT_EQ(problem.elements[0].direction, tour::Direction::backward);
    EXPECT_EQ(problem.elements[1].entry, 2);
    EXPECT_EQ(problem.elements[1].sense, tour::Sense::cw);
    EXPECT_EQ(problem.links[0].vertex_b, 2);
    EXPECT_EQ(problem.before[0], std::pair(0, 1));
    EXPECT_EQ(problem.groups.size(), 2U);
    EXPECT_TRUE(problem.keep_group_order);
}

TEST(TourInstance, AnUnknownKeyIsAWarningWithItsPlace) {
    const auto instance = read_instance(
        R"({"start": null, "elements": [{"closed": false, "points": [[0, 0], [1, 0]], "colour": 3}], "title": ""})",
        "x.json");
    ASSERT_TRUE(instance);
    ASSERT_EQ(instance->warnings.size(), 2U);
    EXPECT_EQ(sentence(instance->warnings[0]), "x.json, element 0: unknown key \"colour\" is ignored");
    EXPECT_EQ(sentence(instance->warnings[1]), "x.json: unknown key \"title\" is ignored");
}

TEST(TourInstance, BrokenJsonIsNamedByLineAndColumn) {
    EXPECT_EQ(refused("{\"start\": null,\n \"elements\": [}").substr(0, 25), "x.json, line 2, column 15");
    EXPECT_NE(refused("{\"start\": ").find("ends inside"), std::string::npos);
    EXPECT_NE(refused("").find("ends inside"), std::string::npos);
    EXPECT_NE(refused("{\"start\": [1e999, 0], \"elements\": []}").find("too large"), std::string::npos);
}

TEST(TourInstance, WrongFieldsAreNamedByPlace) {
    const auto with = [](const char* element) {
        return refused(std::string("{\"elements\": [") + element + "]}");
    };
    EXPECT_NE(refused("[]").find("is not a JSON object"), std::string::npos);
    EXPECT_NE(refused("{}").find("has no \"elements\""), std::string::npos);
    EXPECT_NE(with("3").find("element 0: is not an object"), std::string::npos);
    EXPECT_NE(with(R"({"points": []})").find("has no \"closed\""), std::string::npos);
    EXPECT_NE(with(R"({"closed": false, "points": [[0, 0]]})").find("an open line needs 2"),
              std::string::npos);
    EXPECT_NE(
        with(R"({"closed": false, "points": [[0, 0], [0]]})").find("element 0.points[1]: is not a point"),
        std::string::npos);
    EXPECT_NE(with(R"({"closed": true, "points": [[0, 0]], "direction": "forward"})").find("use \"sense\""),
              std::string::npos);
    EXPECT_NE(refused(R"({"elements": [], "links": [[[0, 1]]]})").find("links[0]"), std::string::npos);
    EXPECT_NE(refused(R"({"elements": [], "before": [[0, -1]]})").find("before[0]"), std::string::npos);
    EXPECT_NE(refused(R"({"elements": [], "end": "home"})").find("end: is not a word known here"),
              std::string::npos);
}

TEST(TourInstance, ASolutionIsABareArrayWithAllThreeKeys) {
    EXPECT_EQ(write_solution({}, {}), "[]\n");
    tour::Problem problem;
    problem.elements.resize(2);
    problem.elements[0].closed = true;
    tour::Tour tour;
    tour.steps = {{1, 0, false}, {0, 2, true}};
    EXPECT_EQ(write_solution(tour, problem),
              "[{\"element\":1,\"entry_index\":0,\"reversed\":false},\n "
              "{\"element\":0,\"entry_index\":2,\"reversed\":true}]\n");
    EXPECT_EQ(write_solution(tour, problem, tour::Entries{{{5, 5}, {0.5, 0}}, 3}),
              "[{\"element\":1,\"entry_index\":0,\"reversed\":false},\n "
              "{\"element\":0,\"entry_index\":2,\"reversed\":true,\"at\":[0.5,0]}]\n");
}

TEST(TourInstance, TheSmallDrawingsReachTheirProvenOptima) {
    const std::filesystem::path folder = std::filesystem::path(STRANDLINE_SHARED) / "judge/tour/instances";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the judges' instances are not here";
    for (const auto& [name, length] :
         {std::pair("lion_example", 1104.838), std::pair("shark_test", 636.189),
          std::pair("asl_logo", 858.085), std::pair("asl_font", 352.550), std::pair("flower_example", 60.701),
          std::pair("maleficient", 558.238)}) {
        std::ifstream file(folder / (std::string("asset_") + name + ".json"));
        const auto instance = read_instance(std::string(std::istreambuf_iterator<char>(file), {}), name);
        ASSERT_TRUE(instance) << name;
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const auto tour = tour::solve(instance->problem, {.seed = seed});
            EXPECT_NEAR(tour->length, length, 1e-3) << name;
            EXPECT_NEAR(*tour::recount(instance->problem, tour->steps), tour->length, 1e-9) << name;
        }
    }
}

}  // namespace
}  // namespace strandline::stages
