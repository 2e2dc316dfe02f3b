// Cases small enough to see the answer, and refusals by name.
#include <gtest/gtest.h>

#include "path/tour/tour.hpp"

namespace strandline::tour {
namespace {

Element line(Point a, Point b, const char* name = "") { return {false, {a, b}, {}, {}, {}, name}; }
Element square(Point low, double side, const char* name = "") {
    return {true, {low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}}, {}, {}, {},
            name};
}

TEST(Tour, AnEmptyProblemHasAnEmptyTour) {
    const auto tour = solve({});
    ASSERT_TRUE(tour);
    EXPECT_TRUE(tour->steps.empty());
    EXPECT_EQ(tour->length, 0);
}

TEST(Tour, AFarStartIsJoinedToTheNearerEnd) {
    Problem problem;
    problem.elements = {line({1, 0}, {5, 0})};
    problem.start = Point{7, 0};
    const auto tour = solve(problem);
    ASSERT_TRUE(tour);
    EXPECT_EQ(tour->steps, (std::vector<Step>{{0, 1, true}}));
    EXPECT_DOUBLE_EQ(tour->length, 2);
}

TEST(Tour, AClosedTourComesBackWhetherItsStartIsGivenOrNot) {
    Problem problem;
    problem.elements = {line({0, 0}, {4, 0}), line({4, 3}, {0, 3})};
    problem.end = End::at_start;
    EXPECT_DOUBLE_EQ(solve(problem)->length, 6);
    problem.start = Point{0, 0};
    EXPECT_DOUBLE_EQ(solve(problem)->length, 6);
    problem.elements.pop_back();
    problem.start.reset();
    EXPECT_DOUBLE_EQ(solve(problem)->length, 4);
}

TEST(Tour, APolygonIsLeftWhereItWasEntered) {
    // Lines left and right of a square: passing it through one corner costs a detour along its side.
    Problem problem;
    problem.elements = {line({-9, 0}, {-1, 0}), square({0, -1}, 2), line({3, 0}, {9, 0})};
    problem.start = Point{-9, 0};
    const auto tour = solve(problem);
    ASSERT_TRUE(tour);
    EXPECT_TRUE(tour->proven_optimal);
    EXPECT_NEAR(tour->length, std::sqrt(2.0) + std::sqrt(10.0), 1e-12);
}

TEST(Tour, TheSenseDecidesReversedAndNotTheLength) {
    Problem problem;
    problem.elements = {square({0, 0}, 1), square({2, 0}, 1)};
    const double free = solve(problem)->length;
    problem.elements[0].sense = Sense::cw;
    problem.elements[1].sense = Sense::ccw;
    const auto tour = solve(problem);
    EXPECT_DOUBLE_EQ(tour->length, free);
    for (const Step& step : tour->steps) EXPECT_EQ(step.reversed, step.element == 0);
}

TEST(Tour, OfADriveAndItsReverseTheOneFromTheEarlierElementIsTaken) {
    const auto at = [](double x) { return line({x, 0}, {x + 1, 0}); };
    for (const bool mirrored : {false, true}) {
        Problem problem;
        for (const double x : {5.0, 0.0, 10.0}) problem.elements.push_back(at(mirrored ? 10 - x : x));
        const auto tour = solve(problem);
        ASSERT_TRUE(tour);
        EXPECT_EQ(tour->steps.front().element, 1) << "not 2";
        EXPECT_EQ(tour->steps.front().reversed, mirrored);
        EXPECT_DOUBLE_EQ(tour->length, 8);
    }
}

TEST(Tour, AChainOfLinksStaysTogether) {
    Problem problem;
    problem.elements = {line({0, 0}, {1, 0}), line({2, 0}, {3, 0}), line({50, 0}, {51, 0}),
                        square({80, 0}, 1)};
    problem.links = {{0, 1, 2, 0}, {2, 1, 3, 2}};
    problem.start = Point{0, 0};
    const auto tour = solve(problem);
    ASSERT_TRUE(tour);
    EXPECT_TRUE(recount(problem, tour->steps));
    EXPECT_NEAR(tour->length, 2 + 4 + 49 + distance({51, 0}, {81, 1}), 2 + 4);
}

TEST(Tour, RecountNamesWhatIsWrong) {
    Problem problem;
    problem.elements = {line({0, 0}, {1, 0}, "eye"), square({2, 0}, 1)};
    EXPECT_FALSE(recount(problem, {{0, 0, false}}));
    EXPECT_FALSE(recount(problem, {{0, 0, false}, {0, 0, false}}));
    EXPECT_FALSE(recount(problem, {{0, 1, false}, {1, 0, false}}));
    EXPECT_FALSE(recount(problem, {{0, 0, false}, {1, 4, false}}));
    EXPECT_DOUBLE_EQ(*recount(problem, {{0, 0, false}, {1, 0, true}}), 1);
    problem.before = {{1, 0}};
    EXPECT_EQ(recount(problem, {{0, 0, false}, {1, 0, true}}).error().reason,
              "element 1 comes after element 0 (eye)");
}

/// A problem of five lines and a square, changed by `change`, is refused with `words` in the message.
template <class Change>
void refused(const char* words, Change change) {
    Problem problem;
    for (int i = 0; i < 5; ++i)
        problem.elements.push_back(line({0.0 + i, 0}, {0.5 + i, 1}, i == 3 ? "eye" : ""));
    problem.elements.push_back(square({3, 3}, 1));
    ASSERT_TRUE(solve(problem));
    change(problem);
    const auto tour = solve(problem);
    ASSERT_FALSE(tour) << words;
    EXPECT_NE(sentence(tour.error()).find(words), std::string::npos) << sentence(tour.error());
}

TEST(Tour, BadElementsAreRefusedByName) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refused("element 3 (eye)", [&](Problem& p) { p.elements[3].points[1].x = nan; });
    refused("element 3 (eye): has no points", [](Problem& p) { p.elements[3].points.clear(); });
    refused("point 0 is not finite or too large", [](Problem& p) { p.elements[2].points[0].y = 1e308; });
    refused("start", [&](Problem& p) { p.start = Point{nan, 0}; });
    refused("its entry is vertex 7", [](Problem& p) { p.elements[5].entry = 7; });
    refused("inside an open line", [](Problem& p) {
        p.elements[1].points.push_back({9, 9}), p.elements[1].entry = 1;
    });
    refused("contradict each other",
            [](Problem& p) { p.elements[3].entry = 1, p.elements[3].direction = Direction::forward; });
}

TEST(Tour, ContradictoryLinksAreRefusedByName) {
    refused("element 3 (eye) to itself", [](Problem& p) { p.links = {{3, 0, 3, 1}}; });
    refused("element 3 (eye) and element 2 a second time", [](Problem& p) {
        p.links = {{2, 0, 3, 1}, {3, 0, 2, 1}};
    });
    refused("third one at element 5", [](Problem& p) {
        p.links = {{5, 0, 1, 0}, {5, 0, 2, 0}, {5, 0, 3, 0}};
    });
    refused("second one at point 1 of the open element 3 (eye)", [](Problem& p) {
        p.links = {{3, 1, 1, 0}, {3, 1, 2, 0}};
    });
    refused("linked at points 0 and 2", [](Problem& p) { p.links = {{5, 0, 1, 0}, {5, 2, 2, 0}}; });
    refused("closes on itself", [](Problem& p) { p.links = {{0, 0, 1, 0}, {1, 1, 2, 0}, {2, 1, 0, 1}}; });
    refused("its fixed entry is 3", [](Problem& p) { p.links = {{5, 0, 1, 0}}, p.elements[5].entry = 3; });
    refused("has no point 9", [](Problem& p) { p.links = {{5, 9, 1, 0}}; });
    refused("there is no element 9", [](Problem& p) { p.links = {{9, 0, 1, 0}}; });
    refused("direction contradicts that of element 0", [](Problem& p) {
        p.links = {{0, 1, 3, 1}};
        p.elements[0].direction = p.elements[3].direction = Direction::forward;
    });
}

TEST(Tour, ContradictoryOrdersAreRefusedByName) {
    refused("element 1 before element 3 (eye), element 3 (eye) before element 1: a circle", [](Problem& p) {
        p.before = {{1, 3}, {3, 1}, {0, 2}};
    });
    refused("cannot come before itself", [](Problem& p) { p.before = {{3, 3}}; });
    refused("is in group 0 already", [](Problem& p) { p.groups = {{1, 3}, {3, 2}}; });
    refused("a circle, given the links", [](Problem& p) {
        p.links = {{0, 1, 1, 0}};
        p.before = {{0, 3}, {3, 1}};
    });
    refused("a circle, given the links and groups", [](Problem& p) {
        p.groups = {{0, 1}};
        p.before = {{0, 3}, {3, 1}};
    });
    refused("group 0 before group 1", [](Problem& p) {
        p.groups = {{0}, {3}};
        p.keep_group_order = true;
        p.before = {{3, 0}};
    });
    refused("comes back", [](Problem& p) {
        p.links = {{0, 1, 1, 0}, {1, 1, 2, 0}};
        p.groups = {{0, 2}};
    });
    refused("both ways", [](Problem& p) { p.links = {{0, 1, 1, 0}, {1, 1, 2, 0}}, p.groups = {{1, 3}}; });
    refused("say otherwise", [](Problem& p) {
        p.links = {{0, 1, 3, 0}};
        p.elements[0].direction = Direction::forward;
        p.before = {{3, 0}};
    });
}

}  // namespace
}  // namespace strandline::tour
