#include <gtest/gtest.h>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

using areas::with;

TEST(FillStyles, ASquareIsOneSpiralStroke) {
    const Fill fill = fill_region(areas::square(), 0, "area", with(Style::rings));
    EXPECT_EQ(fill.strokes.size(), 1u);
    EXPECT_LT(fill.swept / fill.area, 1.03);
}

TEST(FillStyles, ARingIsFilledFromItsHoleOutwardsInOneStroke) {
    const Region ring =
        areas::of({shapes::square({0, 0}, 9.2), shapes::square({3.2, 3.2}, 2.8)});  // four rakes of 0.8
    const Fill fill = fill_region(ring, 0, "area", {.style = Style::rings, .width = 0.8, .spacing = 0.8});
    ASSERT_FALSE(fill.strokes.empty());
    const Point first = fill.strokes.front().nodes.front().at, last = fill.strokes.back().nodes.back().at;
    EXPECT_LT(distance_to_outline(ring.holes[0], first), distance_to_outline(ring.outer, first));
    EXPECT_NEAR(distance_to_outline(ring.outer, last), 0.4, 0.01);
}

TEST(FillStyles, ATurnRadiusLeavesHardlyAnyCorners) {
    Options options{.style = Style::rings, .width = 0.4, .spacing = 0.4, .turn_radius = 0.25};
    const Fill round = fill_region(areas::letter_l(), 0, "area", options);
    options.turn_radius = 0;
    const Fill sharp = fill_region(areas::letter_l(), 0, "area", options);
    const auto corners = [](const Fill& fill) {
        int count = 0;
        for (const Stroke& stroke : fill.strokes)
            for (std::size_t i = 1; i < stroke.rake_path.size(); ++i) {
                const double before = end_pose(stroke.rake_path[i - 1]).heading;
                if (std::abs(wrap_angle(stroke.rake_path[i].start.heading - before)) > 0.4) ++count;
            }
        return count;
    };
    EXPECT_GT(corners(sharp), 15);
    EXPECT_LE(corners(round), 6);  // about the spine, where there is no room to turn
    EXPECT_GT(areas::judged(areas::letter_l(), round, 0.4).coverage, 0.95);
}

TEST(FillStyles, AnAreaNarrowerThanTheRakeIsOnePassWithAWarning) {
    for (Style style : {Style::rings, Style::zigzag}) {
        const Fill fill =
            fill_region(areas::of({{{0, 0}, {5, 0}, {5, 0.3}, {0, 0.3}}}), 0, "bar", with(style));
        ASSERT_EQ(fill.strokes.size(), 1u);
        ASSERT_EQ(fill.warnings.size(), 1u);
        EXPECT_EQ(fill.warnings[0].place, "bar");
        EXPECT_NEAR(fill.swept, 5 * 0.4, 0.05);
    }
}

TEST(FillStyles, OneStrokeNeverLifts) {
    for (Style style : {Style::rings, Style::spiral, Style::zigzag})
        for (const Region& region : areas::all()) {
            Options options = areas::with(style);
            options.pivots = true;
            options.one_stroke = true;
            const Fill fill = fill_region(region, 0, "area", options);
            EXPECT_EQ(fill.strokes.size(), 1u);
            EXPECT_GT(areas::judged(region, fill, 0.4).coverage, 0.97);
        }
}

TEST(FillStyles, EveryJoinFillsAndTheyDiffer) {
    std::vector<double> swept;
    for (Join join : {Join::half_step, Join::nearest, Join::alternating, Join::longest_edge}) {
        Options options = areas::with(Style::rings);
        options.join = join;
        const Fill fill = fill_region(areas::letter_l(), 0, "area", options);
        const auto account = areas::judged(areas::letter_l(), fill, 0.4);
        EXPECT_GT(account.coverage, 0.96) << static_cast<int>(join);
        EXPECT_LT(account.spill, 0.001) << static_cast<int>(join);
        swept.push_back(fill.swept);
    }
    EXPECT_GT(swept[1], swept[0]);  // rings that close whole are raked twice where they are left
    EXPECT_NE(swept[2], swept[0]);
    EXPECT_NE(swept[3], swept[0]);
}

TEST(FillStyles, WhatIsTooSmallIsDroppedCountedAndSaid) {
    const Fill fill =
        fill_region(areas::of({shapes::square({0, 0}, 0.05)}), 0, "speck", {.width = 0.4, .spacing = 0.4});
    EXPECT_TRUE(fill.strokes.empty());
    EXPECT_EQ(fill.dropped_parts, 1);
    EXPECT_EQ(fill.warnings.size(), 1u);
}

TEST(FillStyles, AnArmTooNarrowForTheRakeIsNamedByPlace) {
    const Region key = areas::of({{{0, 0}, {3, 0}, {3, 1.4}, {8, 1.4}, {8, 1.6}, {3, 1.6}, {3, 3}, {0, 3}}});
    const Fill fill = fill_region(key, 0, "key", {.width = 0.4, .spacing = 0.4, .narrow = Narrow::warn});
    ASSERT_EQ(fill.warnings.size(), 1u);
    EXPECT_NE(fill.warnings[0].reason.find("left bare"), std::string::npos);
}

}  // namespace
}  // namespace strandline::fill
