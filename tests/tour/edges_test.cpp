// Entries anywhere on the edges of closed elements.
#include <gtest/gtest.h>

#include "tour/cases.hpp"

namespace strandline::tour {
namespace {

Element square(Point low, double side) {
    Element element;
    element.closed = true;
    element.points = {low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}};
    return element;
}
Element line(Point a, Point b) {
    Element element;
    element.points = {a, b};
    return element;
}
Problem problem_of(std::vector<Element> elements) {
    Problem problem;
    problem.elements = std::move(elements);
    return problem;
}

/// The legs, and that each entry lies on its element.
double recounted(const Problem& problem, const std::vector<Step>& steps, const Entries& entries) {
    double sum = 0;
    const Point* before = problem.start ? &*problem.start : nullptr;
    Point out;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Element& e = problem.elements[static_cast<std::size_t>(steps[k].element)];
        const Point in = entries.at[k];
        double off = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0, j = e.points.size() - 1; i < e.points.size(); j = i++) {
            const Point a = e.closed ? e.points[j] : e.points[i], edge = e.points[i] - a;
            const double l2 = dot(edge, edge), t = l2 > 0 ? std::clamp(dot(in - a, edge) / l2, 0.0, 1.0) : 0;
            off = std::min(off, distance(in, a + t * edge));
        }
        EXPECT_LT(off, 1e-9);
        if (before) sum += distance(*before, in);
        out = e.closed ? in : steps[k].entry == 0 ? e.points.back() : e.points.front();
        before = &out;
    }
    if (problem.end == End::at_point) sum += distance(out, problem.end_point);
    if (problem.end == End::at_start) sum += distance(out, problem.start ? *problem.start : entries.at[0]);
    return sum;
}

TEST(EntriesOnEdges, AWayPastASquareMeetsItsSideLikeAMirror) {
    // from one line's end to the other's start past a square above both: 3 and 1 below it, 4 apart
    const Problem problem =
        problem_of({line({-9, -3}, {0, -3}), square({-5, 0}, 20), line({4, -1}, {9, -1})});
    const std::vector<Step> steps{{0, 0, false}, {1, 0, false}, {2, 0, false}};
    const Entries entries = entered_on_edges(problem, steps);
    EXPECT_NEAR(entries.at[1].x, 3, 1e-12);
    EXPECT_NEAR(entries.at[1].y, 0, 1e-12);
    EXPECT_NEAR(entries.length, std::hypot(4, 4), 1e-12);
}

TEST(EntriesOnEdges, AWayThroughASquareIsStraight) {
    const Problem problem = problem_of({line({-9, 1}, {-4, 1}), square({0, 0}, 2), line({6, 1}, {9, 1})});
    const Entries entries = entered_on_edges(problem, {{0, 0, false}, {1, 2, false}, {2, 0, false}});
    EXPECT_NEAR(entries.length, 10, 1e-12);
}

TEST(EntriesOnEdges, TheFirstAndTheLastAreMetAtTheirNearestPlaces) {
    const Problem problem = problem_of({square({0, 0}, 2), line({5, 1}, {6, 1}), square({9, 0}, 2)});
    const Entries entries = entered_on_edges(problem, {{0, 0, false}, {1, 0, false}, {2, 2, false}});
    EXPECT_EQ(entries.at[0], (Point{2, 1}));
    EXPECT_EQ(entries.at[2], (Point{9, 1}));
    EXPECT_NEAR(entries.length, 3 + 3, 1e-12);
}

TEST(EntriesOnEdges, FixedAndLinkedEntriesStay) {
    Problem problem = problem_of({square({0, 0}, 2), line({5, 1}, {6, 1}), square({9, 0}, 2)});
    problem.elements[0].entry = 0;
    problem.links = {{1, 1, 2, 2}};
    const std::vector<Step> steps{{0, 0, false}, {1, 0, false}, {2, 2, false}};
    const Entries entries = entered_on_edges(problem, steps);
    EXPECT_EQ(entries.at[0], (Point{0, 0}));
    EXPECT_EQ(entries.at[2], (Point{11, 2}));
    EXPECT_NEAR(entries.length, *recount(problem, steps), 1e-12);
}

TEST(EntriesOnEdges, NeverLongerAndOnTheElements) {
    Dice dice{std::mt19937_64(17)};
    int shorter = 0;
    for (int round = 0; round < 60; ++round) {
        const Problem problem = random_problem(dice, 2 + dice.below(12));
        const auto tour = solve(problem);
        ASSERT_TRUE(tour);
        const Entries entries = entered_on_edges(problem, tour->steps);
        EXPECT_LE(entries.length, tour->length + 1e-9);
        EXPECT_NEAR(entries.length, recounted(problem, tour->steps, entries), 1e-9);
        shorter += entries.length < tour->length - 1e-6 ? 1 : 0;
    }
    EXPECT_GT(shorter, 30);
}

}  // namespace
}  // namespace strandline::tour
