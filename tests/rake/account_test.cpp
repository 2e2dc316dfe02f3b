#include <gtest/gtest.h>

#include "path/rake/rake.hpp"
#include "region/areas.hpp"

namespace strandline::rake {
namespace {

const Regions bar{areas::of({{{0, 0}, {8, 0}, {8, 1}, {0, 1}}})};
const AccountOptions one_wide{.width = 1, .pins = 4};
constexpr unsigned all = 0b1111;

Account of(const Regions& regions, const std::vector<Move>& moves) {
    return account_of(regions, moves, one_wide);
}

TEST(RakeAccount, OneStrokeAsWideAsTheBarRakesItAll) {
    const Account account = of(bar, {{{{0, 0.5}, {8, 0.5}}, all}});
    EXPECT_NEAR(account.coverage, 1, 1e-9);
    EXPECT_EQ(account.overdraw, 0);
    EXPECT_EQ(account.spill, 0);
    EXPECT_EQ(account.spill_reach, 0);
    EXPECT_NEAR(account.ratio, 1, 1e-9);
    EXPECT_NEAR(account.crisp_edge, 1, 1e-9);
    EXPECT_NEAR(account.end_off_border, -0.5, 1e-9);  // the rake's middle is on the outline
    EXPECT_TRUE(account.gaps.empty());
}

TEST(RakeAccount, WhatTwoStrokesShareIsRakedTwice) {
    // 8 m forth and 6 m back over the same sand: 6 of 8 m2.
    const Account account = of(bar, {{{{0, 0.5}, {8, 0.5}}, all}, {{{7, 0.5}, {1, 0.5}}, all}});
    EXPECT_NEAR(account.overdraw, 0.75, 0.02);
    EXPECT_NEAR(account.coverage, 1, 1e-9);
    EXPECT_NEAR(account.ratio, 14.0 / 8, 1e-9);
}

TEST(RakeAccount, ARepeatWithinAWidthOfTravelIsNone) {
    const Account account = of(bar, {{{{0, 0.5}, {8, 0.5}}, all}, {{{8, 0.5}, {7.6, 0.5}}, all}});
    EXPECT_EQ(account.overdraw, 0);
}

TEST(RakeAccount, AStrokeHalfOutsideSpillsHalfOfItself) {
    const Account account = of(bar, {{{{0, 1}, {8, 1}}, all}});
    EXPECT_NEAR(account.coverage, 0.5, 0.01);
    EXPECT_NEAR(account.spill, 0.5, 0.01);
    EXPECT_NEAR(account.spill_reach, 0.5, account.cell);
    ASSERT_EQ(account.gaps.size(), 1u);
    EXPECT_NEAR(account.gaps[0].area, 4, 0.1);
    EXPECT_NEAR(account.gaps[0].disc, 0.5, 2 * account.cell);
}

TEST(RakeAccount, TheCornersOfARingAreWedges) {
    // A square ring of passes: at each outer corner the bar sweeps a quarter disc of the square beside it.
    const Regions ring{areas::of({shapes::square({0, 0}, 4), shapes::square({1, 1}, 2)})};
    const Account account =
        of(ring, {{{{0.5, 2}, {0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}, {0.5, 2}}, all}});
    EXPECT_NEAR(account.coverage, 1 - 4 * (0.25 - pi / 16) / 12, 0.003);
    EXPECT_LT(account.overdraw, 0.003);
    EXPECT_EQ(account.gaps.size(), 4u);
}

TEST(RakeAccount, LiftedMovesAreHopsAndPivots) {
    const Account account = of(bar, {{{{0, 0.5}, {2, 0.5}}, all},
                                     {{{2, 0.5}, {2.6, 0.5}}, 0},
                                     {{{2.6, 0.5}, {4, 0.5}}, all},
                                     {{{4, 0.5}, {6, 0.5}}, 0},
                                     {{{6, 0.5}, {8, 0.5}}, all}});
    EXPECT_EQ(account.pivots, 1);
    EXPECT_EQ(account.hops, 1);
    EXPECT_NEAR(account.hops_length, 2.6, 1e-9);
    ASSERT_EQ(account.gaps.size(), 2u);
    EXPECT_NEAR(account.gaps[0].area, 2, 0.05);
    EXPECT_NEAR(account.gaps[1].area, 0.6, 0.05);
}

TEST(RakeAccount, AWayOverFinishedSandIsDrivenOver) {
    const Regions field{areas::of({shapes::square({0, 0}, 8)})};
    const Polyline first{{4, 0}, {4, 8}};
    const std::vector<Move> across{
        {first, all}, {{{4, 8}, {0, 8}, {0, 4}, {8, 4}}, 0}, {{{8, 4}, {8, 2}}, all}};
    const Account account = of(field, across);
    EXPECT_EQ(account.drives_over, 1);
    EXPECT_NEAR(account.driven_over, 1, 2 * account.cell);
    const std::vector<Move> around{{first, all}, {{{4, 8}, {8, 8}, {8, 4}}, 0}, {{{8, 4}, {8, 2}}, all}};
    EXPECT_EQ(of(field, around).drives_over, 0);
}

TEST(RakeAccount, AGapIsNamedByItsPlace) {
    const Account account = of(bar, {{{{0, 0.5}, {5, 0.5}}, all}, {{{5.5, 0.5}, {8, 0.5}}, all}});
    ASSERT_EQ(account.gaps.size(), 1u);
    EXPECT_NEAR(account.gaps[0].at.x, 5.25, account.cell);
    EXPECT_NEAR(account.gaps[0].area, 0.5, 0.02);
    EXPECT_NEAR(account.gaps[0].disc, 0.5, 2 * account.cell);
}

TEST(RakeAccount, LiftedPinsLeaveTheirSand) {
    const Account account = of(bar, {{{{0, 0.5}, {8, 0.5}}, 0b0111}});  // the leftmost is up
    EXPECT_NEAR(account.coverage, 0.75, 0.01);
    EXPECT_NEAR(account.ratio, 0.75, 1e-9);
    ASSERT_EQ(account.gaps.size(), 1u);
    EXPECT_GT(account.gaps[0].at.y, 0.75);
}

TEST(RakeAccount, AccountsOfAreasAddUp) {
    const Account a = of(bar, {{{{0, 0.5}, {8, 0.5}}, all}}), b = of(bar, {{{{0, 0.5}, {4, 0.5}}, all}});
    const Account both = joined(a, b);
    EXPECT_NEAR(both.area, 16, 1e-9);
    EXPECT_NEAR(both.coverage, 0.75, 0.01);
    EXPECT_EQ(both.gaps.size(), 1u);
    EXPECT_EQ(joined({}, a), a);
}

}  // namespace
}  // namespace strandline::rake
