// Problems for solvers of others, and back.
#include <gtest/gtest.h>

#include <algorithm>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

tour::Element element(bool closed, std::vector<Point> points) {
    tour::Element made;
    made.closed = closed;
    made.points = std::move(points);
    return made;
}
tour::Problem two_lines() {
    tour::Problem problem;
    problem.elements = {element(false, {{0, 0}, {5, 5}, {10, 0}}), element(false, {{10, 20}, {0, 20}})};
    return problem;
}

TEST(Tsplib, LinesAreNodesWithFixedEdges) {
    const auto text = write_tsplib(two_lines());
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("TYPE : HPP\nDIMENSION : 4\n"), std::string::npos) << *text;
    EXPECT_NE(text->find("FIXED_EDGES_SECTION\n1 2\n3 4\n-1\n"), std::string::npos) << *text;
}

TEST(Tsplib, TheStartIsTiedToAPointFarAway) {
    tour::Problem problem = two_lines();
    problem.start = Point{1, 1};
    const auto text = write_tsplib(problem);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("DIMENSION : 6\n"), std::string::npos);
    EXPECT_NE(text->find("\n5 6\n-1\n"), std::string::npos);
}

TEST(Tsplib, ToursOfLinesAreReadFromEitherEndAndAnyTurn) {
    tour::Problem problem = two_lines();
    // line 0 from its end, then line 1 backwards
    const std::vector<tour::Step> wanted{{0, 2, true}, {1, 1, true}};
    EXPECT_EQ(read_tsplib_tour("NAME : x\nTOUR_SECTION\n2\n1\n4\n3\n-1\nEOF\n", "t", problem), wanted);
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n3\n2\n1\n4\n-1\n", "t", problem), wanted) << "as a ring";
    problem.start = Point{1, 1};
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n2 1 4 3 6 5 -1", "t", problem), wanted) << "turned";
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n3 4 1 2 5 6 -1", "t", problem), wanted) << "backwards";
}

TEST(Tsplib, AClosedTourOfLinesIsARing) {
    tour::Problem problem = two_lines();
    problem.end = tour::End::at_start;
    auto text = write_tsplib(problem);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("TYPE : TSP\nDIMENSION : 4\n"), std::string::npos) << *text;
    const std::vector<tour::Step> wanted{{0, 2, true}, {1, 1, true}};
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n3\n2\n1\n4\n-1\n", "t", problem), wanted);
    problem.start = Point{1, 1};
    text = write_tsplib(problem);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("TYPE : TSP\nDIMENSION : 5\n"), std::string::npos) << *text;
    EXPECT_NE(text->find("\n1 2\n3 4\n-1\n"), std::string::npos) << *text;
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n4 3 5 2 1 -1", "t", problem), wanted);
    EXPECT_FALSE(read_tsplib_tour("TOUR_SECTION\n4 3 2 1 -1", "t", problem));
}

TEST(Tsplib, ClosedLinesMakeSetsOfWays) {
    tour::Problem problem = two_lines();
    problem.elements.push_back(element(true, {{0, 30}, {4, 30}, {4, 34}}));
    const auto text = write_tsplib(problem);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("TYPE : AGTSP\nDIMENSION : 8\nGTSP_SETS : 4\n"), std::string::npos) << *text;
    EXPECT_NE(text->find("GTSP_SET_SECTION\n1 1 -1\n2 2 3 -1\n3 4 5 -1\n4 6 7 8 -1\n"), std::string::npos);
    const std::vector<tour::Step> wanted{{1, 0, false}, {2, 1, false}, {0, 2, true}};
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n3\n1\n4\n7\n-1\n", "t", problem), wanted);
}

TEST(Tsplib, WhatIsNoTourIsRefusedByItsPlace) {
    const tour::Problem problem = two_lines();
    const auto reason = [&](const char* text) {
        return sentence(read_tsplib_tour(text, "t", problem).error());
    };
    EXPECT_NE(reason("1 2 3 4").find("TOUR_SECTION"), std::string::npos);
    EXPECT_NE(reason("TOUR_SECTION\n1\ntwo\n").find("line 3"), std::string::npos);
    EXPECT_NE(reason("TOUR_SECTION\n1 3 2 4 -1").find("two ends"), std::string::npos);
    EXPECT_NE(reason("TOUR_SECTION\n1 2 9 10 -1").find("two ends"), std::string::npos);
}

TEST(Tsplib, RulesThatTheFormatLacksAreRefused) {
    tour::Problem problem = two_lines();
    problem.before = {{0, 1}};
    EXPECT_FALSE(write_tsplib(problem));
    EXPECT_FALSE(write_tsplib({}));
}

TEST(Tsplib, AnEndOrADirectionNeedsTheMatrix) {
    tour::Problem problem = two_lines();
    problem.end = tour::End::at_point;
    EXPECT_NE(write_tsplib(problem)->find("AGTSP"), std::string::npos);
    problem = two_lines();
    problem.elements[0].direction = tour::Direction::backward;
    const auto text = write_tsplib(problem);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("DIMENSION : 4\n"), std::string::npos) << "one way for line 0, two for line 1";
    EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n1 2 4 -1", "t", problem),
              (std::vector<tour::Step>{{0, 2, true}, {1, 1, true}}));
}

}  // namespace
}  // namespace strandline::stages
