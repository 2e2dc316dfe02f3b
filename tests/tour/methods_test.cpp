// Orders without a search, proofs or nothing, neighbours together, several threads.
#include <gtest/gtest.h>

#include <set>

#include "tour/cases.hpp"

namespace strandline::tour {
namespace {

Problem many(std::uint64_t seed, int elements) {
    Dice dice{std::mt19937_64(seed)};
    return random_problem(dice, elements);
}

Problem three_lines() {
    Problem problem;
    for (const double x : {5.0, 0.0, 9.0}) {
        Element line;
        line.points = {{x, 0}, {x + 1, 0}};
        problem.elements.push_back(line);
    }
    return problem;
}

TEST(Methods, TheFilesOrderIsTheFilesOrder) {
    Problem problem = three_lines();
    problem.start = Point{0, 0};
    const auto tour = solve(problem, {.method = Method::file});
    ASSERT_TRUE(tour);
    EXPECT_EQ(tour->steps, (std::vector<Step>{{0, 0, false}, {1, 0, false}, {2, 0, false}}));
    EXPECT_DOUBLE_EQ(tour->length, 5 + 6 + 8);
    EXPECT_EQ(tour->moves, 0U);
}

TEST(Methods, TheFilesOrderGivesWayToRules) {
    Problem problem = three_lines();
    problem.before = {{2, 0}};
    problem.elements[1].direction = Direction::backward;
    const auto tour = solve(problem, {.method = Method::file});
    ASSERT_TRUE(tour);
    EXPECT_EQ(tour->steps, (std::vector<Step>{{1, 1, true}, {2, 0, false}, {0, 0, false}}));
}

TEST(Methods, NearestTakesTheNearestEnd) {
    Problem problem = three_lines();
    problem.start = Point{8, 0};
    const auto tour = solve(problem, {.method = Method::nearest});
    ASSERT_TRUE(tour);
    // 9 -> 10, then back to 6 -> 5, then 1 -> 0
    EXPECT_DOUBLE_EQ(tour->length, 1 + 4 + 4);
}

TEST(Methods, NoneIsShorterThanTheBest) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Problem problem = many(seed, 8);
        Dice dice{std::mt19937_64(seed)};
        add_rules(dice, problem);
        const auto best = solve(problem);
        for (const Method method : {Method::file, Method::nearest}) {
            const auto tour = solve(problem, {.method = method});
            ASSERT_EQ(tour.has_value(), best.has_value()) << seed;
            if (!tour) continue;
            EXPECT_NEAR(recount(problem, tour->steps).value_or(-1), tour->length, 1e-9) << seed;
            EXPECT_GE(tour->length, best->length - 1e-9) << seed;
        }
    }
}

TEST(Methods, ExactIsProvenOrRefused) {
    const auto tour = solve(many(3, 9), {.method = Method::exact});
    ASSERT_TRUE(tour);
    EXPECT_TRUE(tour->proven_optimal);
    const auto refused = solve(many(3, 41), {.method = Method::exact});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().reason.find("41"), std::string::npos);
}

TEST(Methods, GroupedToursFinishTheirGroupsAndKeepTheRules) {
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Problem problem = many(seed, 45);
        Dice dice{std::mt19937_64(seed)};
        add_rules(dice, problem);
        problem.groups.clear();
        const auto tour = solve(problem, {.grouped = true, .moves = 100});
        if (!tour) continue;
        ++solved;
        EXPECT_NEAR(recount(problem, tour->steps).value_or(-1), tour->length, 1e-9) << seed;
        EXPECT_GE(tour->groups.size(), 2U) << seed;
        std::vector<int> group_of(problem.elements.size(), -1);
        for (std::size_t g = 0; g < tour->groups.size(); ++g)
            for (const int e : tour->groups[g]) group_of[static_cast<std::size_t>(e)] = static_cast<int>(g);
        std::set<int> finished;
        int now = -1;
        for (const Step& step : tour->steps) {
            const int group = group_of[static_cast<std::size_t>(step.element)];
            if (group == now) continue;
            EXPECT_TRUE(finished.insert(group).second) << seed << ": group " << group << " is begun twice";
            now = group;
        }
        EXPECT_EQ(finished.size(), tour->groups.size()) << seed;
    }
    EXPECT_GT(solved, 3);
}

TEST(Methods, GroupsOfTheProblemAreCutIntoPartsInTheirOrder) {
    Problem problem = many(5, 24);
    problem.keep_group_order = true;
    problem.groups = {{}, {}};
    for (int e = 0; e < 24; ++e) problem.groups[static_cast<std::size_t>(e % 2)].push_back(e);
    const auto tour = solve(problem, {.grouped = true});
    ASSERT_TRUE(tour) << sentence(tour.error());
    EXPECT_GT(tour->groups.size(), 2U);
    EXPECT_NEAR(recount(problem, tour->steps).value_or(-1), tour->length, 1e-9);
    problem.groups.pop_back();
    EXPECT_FALSE(solve(problem, {.grouped = true}));
}

TEST(Methods, ThreadsAreAsGoodAsTheBestOfTheirSeedsEveryTime) {
    const Problem problem = many(8, 120);
    double best = std::numeric_limits<double>::infinity();
    for (const std::uint64_t seed : {4U, 5U})
        best = std::min(best, solve(problem, {.seed = seed, .moves = 300})->length);
    for (int run = 0; run < 3; ++run)
        EXPECT_EQ(solve(problem, {.threads = 2, .seed = 4, .moves = 300})->length, best);
}

}  // namespace
}  // namespace strandline::tour
