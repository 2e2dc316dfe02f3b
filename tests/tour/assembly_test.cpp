#include "path/tour/assembly.hpp"

#include <gtest/gtest.h>

#include <set>

#include "cases.hpp"
#include "path/tour/breed.hpp"
#include "path/tour/climb.hpp"
#include "path/tour/order.hpp"
#include "path/tour/parts.hpp"

namespace strandline::tour {
namespace {

/// Dashes one behind the other along a row.
void add_row(Problem& problem, double x, double y, int count) {
    for (int k = 0; k < count; ++k)
        problem.elements.push_back({false, {{x + k, y}, {x + k + 0.8, y}}, {}, {}, {}, {}});
}

std::vector<Visit> forward(std::initializer_list<int> pieces) {
    std::vector<Visit> order;
    for (const int piece : pieces) order.push_back({piece});
    return order;
}

/// Whether every piece comes once.
bool is_whole(const Model& model, const std::vector<Visit>& order) {
    std::set<int> pieces;
    for (const Visit& visit : order) pieces.insert(visit.piece);
    return static_cast<int>(order.size()) == model.piece_count() && pieces.size() == order.size();
}

TEST(TourAssembly, TakesFromAnotherTourWhatIsBetterThereAndKeepsItsOwn) {
    Problem problem;
    add_row(problem, 0, 0, 8);
    add_row(problem, 100, 0, 8);
    problem.start = {-1, 0};
    const auto model = build_model(problem);
    ASSERT_TRUE(model);
    const Candidates near = find_candidates(*model, 8);
    // One is wrong in the left row, the other in the right one.
    const auto ours = forward({0, 5, 4, 1, 2, 3, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    const auto theirs = forward({0, 1, 2, 3, 4, 5, 6, 7, 8, 13, 12, 9, 10, 11, 14, 15});
    Search search{Sequence(*model, ours), near, std::mt19937_64(1), {}, {}};
    const Progress progress;
    Budget budget{progress, 1'000, 1'000'000};
    Descent descent(search, budget);
    find_longest(search);
    Vain vain;
    const double before = search.tour.length();
    const double gain = absorb(search, descent, Sequence(*model, theirs), vain);
    EXPECT_GT(gain, 1);
    EXPECT_NEAR(search.tour.length(), before - gain, 1e-9);
    EXPECT_LE(search.tour.length(), Sequence(*model, theirs).length());
}

TEST(TourAssembly, IsNeverLongerAndStatesItsGain) {
    Dice dice{std::mt19937_64(11)};
    double all = 0;
    for (int round = 0; round < 60; ++round) {
        const Problem problem = random_problem(dice, 30 + dice.below(40));
        const auto model = build_model(problem);
        ASSERT_TRUE(model);
        const Candidates near = find_candidates(*model, 8);
        const auto first = *first_order(*model);
        const Progress progress;
        Budget budget{progress, 1'000, 1'000'000};
        Search search{
            Sequence(*model, first), near, std::mt19937_64(static_cast<std::uint64_t>(round)), {}, {}};
        Descent descent(search, budget);
        diverge(search, descent);
        const Sequence other = search.tour;
        search.tour = Sequence(*model, first);
        diverge(search, descent);
        const double before = search.tour.length();
        Vain vain;
        const double gain = absorb(search, descent, other, vain);
        EXPECT_GE(gain, 0);
        EXPECT_NEAR(search.tour.length(), before - gain, 1e-7);
        EXPECT_TRUE(is_whole(*model, search.tour.order()));
        EXPECT_TRUE(recount(problem, steps_of(*model, search.tour.order())));
        all += gain;
    }
    EXPECT_GT(all, 1);
}

TEST(TourParts, HoldEveryPieceOnceAndAreNotTooLarge) {
    Dice dice{std::mt19937_64(12)};
    const Problem problem = random_problem(dice, 333);
    const auto model = build_model(problem);
    for (const double shift : {0.0, 0.5}) {
        std::set<int> pieces;
        for (const auto& part : parts_of(*model, 50, shift)) {
            EXPECT_LE(part.size(), 56U);
            pieces.insert(part.begin(), part.end());
        }
        EXPECT_EQ(pieces.size(), 333U);
    }
    EXPECT_NE(parts_of(*model, 50, 0), parts_of(*model, 50, 0.5));
}

TEST(TourParts, WhatAPartGainsTheWholeGains) {
    Dice dice{std::mt19937_64(13)};
    for (int round = 0; round < 12; ++round) {
        const Problem problem = random_problem(dice, 120);
        const auto model = build_model(problem);
        const Candidates near = find_candidates(*model, 8);
        const auto order = *first_order(*model);
        for (const auto& pieces : parts_of(*model, 40, 0)) {
            const Part part = part_of(*model, near, order, pieces);
            const double whole = Sequence(*model, order).length();
            const auto same = put_back(*model, part, part.order, order);
            EXPECT_NEAR(Sequence(*model, same).length(), whole, 1e-9);
            const Progress progress;
            Budget budget{progress, 300, 1'000'000};
            const auto found = bred(part.model, part.near, part.order, 1, budget, {0, 1}, 0);
            const double gain =
                Sequence(part.model, part.order).length() - Sequence(part.model, found).length();
            EXPECT_GT(gain, 0);
            const auto better = put_back(*model, part, found, order);
            EXPECT_TRUE(is_whole(*model, better));
            EXPECT_NEAR(Sequence(*model, better).length(), whole - gain, 1e-7);
        }
    }
}

TEST(TourBreed, ManyToursThatLearnFromEachOtherBeatOne) {
    // Lines shorter than the gaps between them, as in a drawing of hatching.
    Dice dice{std::mt19937_64(14)};
    Problem problem;
    for (int i = 0; i < 1'600; ++i) {
        const Point at = 10.0 * dice.point();
        problem.elements.push_back({false, {at, at + 0.1 * dice.point()}, {}, {}, {}, {}});
    }
    const auto model = build_model(problem);
    const Candidates near = find_candidates(*model, 8);
    const auto first = *first_order(*model);
    const Progress progress;
    // The same budget; a member said to take all of it leaves room for one tour only.
    const auto length_with = [&](double member) {
        Budget budget{progress, 25'000, 1'000'000};
        return Sequence(*model, bred(*model, near, first, 1, budget, {0, 1}, member)).length();
    };
    EXPECT_LT(length_with(0.03), length_with(1));
}

}  // namespace
}  // namespace strandline::tour
