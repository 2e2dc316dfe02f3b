#include <gtest/gtest.h>

#include "path/rake/rake.hpp"
#include "region/areas.hpp"

namespace strandline::rake {
namespace {

const Rake four_pins{.width = 1, .pins = 4, .tolerance = 0.005};

Stroke stroke_along(const Polyline& line) {
    Stroke stroke;
    stroke.rake_path = fitted(path_through(line, false), {.tolerance = 0.005});
    return stroke;
}
Account raked(const Regions& regions, const std::vector<Stroke>& strokes, const Rake& rake) {
    const auto masks = pin_masks(regions, strokes, {}, rake);
    return account_of(regions, moves_of(strokes, {}, masks, rake.pins, rake.tolerance),
                      {.width = rake.width, .pins = rake.pins});
}
Regions box(double x, double y) { return {areas::of({{{0, 0}, {x, 0}, {x, y}, {0, y}}})}; }

TEST(RakeMasks, AStrokeOverFreshSandHasAllPinsDownFromEndToEnd) {
    const auto masks = pin_masks(box(8, 1), {stroke_along({{0, 0.5}, {8, 0.5}})}, {}, four_pins);
    ASSERT_EQ(masks.size(), 1u);
    ASSERT_EQ(masks[0].size(), 1u);
    EXPECT_EQ(masks[0][0].mask, 0b1111u);
    EXPECT_EQ(masks[0][0].from, 0);
    EXPECT_NEAR(masks[0][0].to, 8, 1e-9);
}

TEST(RakeMasks, PinsBesideTheAreaAreUpAndSoIsTheRakeBeyondItsEnd) {
    // The two left pins of four run over a bar of half a width; the path overshoots by a metre each way.
    const auto masks = pin_masks(box(8, 0.5), {stroke_along({{-1, 0}, {9, 0}})}, {}, four_pins);
    ASSERT_EQ(masks[0].size(), 1u);
    EXPECT_EQ(masks[0][0].mask, 0b1100u);
    EXPECT_NEAR(masks[0][0].from, 1, 0.05);
    EXPECT_NEAR(masks[0][0].to, 9, 0.05);
}

TEST(RakeMasks, SharedSandIsLeftToTheLastPass) {
    // Passes three pins apart: their shared pin's width is the second one's.
    const auto masks =
        pin_masks(box(8, 1.75), {stroke_along({{0, 0.5}, {8, 0.5}}), stroke_along({{0, 1.25}, {8, 1.25}})},
                  {}, four_pins);
    ASSERT_EQ(masks[0].size(), 1u);
    ASSERT_EQ(masks[1].size(), 1u);
    EXPECT_EQ(masks[0][0].mask, 0b0111u);
    EXPECT_EQ(masks[1][0].mask, 0b1111u);
}

TEST(RakeMasks, TheSamePathTwiceIsRakedOnce) {
    const Stroke stroke = stroke_along({{0, 0.5}, {8, 0.5}});
    const auto masks = pin_masks(box(8, 1), {stroke, stroke, stroke}, {}, four_pins);
    EXPECT_TRUE(masks[0].empty());
    EXPECT_TRUE(masks[1].empty());
    EXPECT_EQ(masks[2].size(), 1u);
}

TEST(RakeMasks, OvershootingLinesAndABorderRakeEveryAreaOnceAndNothingElse) {
    const Rake rake{.width = 0.42, .pins = 7, .tolerance = 0.002};
    const double spacing = rake.width * 6 / 7;
    for (const Region& region : areas::all())
        for (const double direction : {0.4, 1.1}) {
            std::vector<Stroke> strokes;
            const Point ahead = unit(direction), middle = centroid(region.outer);
            for (int k = -20; k <= 20; ++k) {
                const Point on = middle + k * spacing * left_normal(ahead);
                strokes.push_back(stroke_along({on - 8 * ahead, on + 8 * ahead}));
            }
            for (const Region& room : inset({region}, rake.width / 2)) {
                std::vector<Polygon> rings = room.holes;
                rings.push_back(room.outer);
                for (Polygon& ring : rings) {
                    ring.push_back(ring.front());
                    strokes.push_back(stroke_along(ring));
                }
            }
            const Account account = raked({region}, strokes, rake);
            EXPECT_GT(account.coverage, 0.995);
            EXPECT_LT(account.overdraw, 0.02);
            EXPECT_LT(account.spill, 0.002);
            EXPECT_LT(account.spill_reach, rake.width * (1 / 7.0 + 1 / 16.0));
        }
}

TEST(RakeMoves, WhatIsLiftedIsAMoveAndWhatTouchesIsNot) {
    const std::vector<Stroke> strokes{stroke_along({{0, 0}, {8, 0}})};
    const auto moves = moves_of(strokes, {}, {{{1, 2, 0b1100}, {2, 3, 0b1111}, {5, 6, 0b1000}}}, 4, 0.01);
    const std::vector<Move> expected{{{{1, 0}, {2, 0}}, 0b1100},
                                     {{{2, 0}, {3, 0}}, 0b1111},
                                     {{{3, 0}, {5, 0}}, 0},
                                     {{{5, 0}, {6, 0}}, 0b1000}};
    ASSERT_EQ(moves.size(), expected.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
        EXPECT_EQ(moves[i].mask, expected[i].mask);
        ASSERT_EQ(moves[i].line.size(), 2u);
        EXPECT_NEAR(distance(moves[i].line[0], expected[i].line[0]), 0, 1e-9);
        EXPECT_NEAR(distance(moves[i].line[1], expected[i].line[1]), 0, 1e-9);
    }
}

}  // namespace
}  // namespace strandline::rake
