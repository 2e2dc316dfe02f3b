#include <gtest/gtest.h>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

using areas::with;

TEST(FillLaws, NearlyAllIsRakedAndNothingOutside) {
    for (Style style : {Style::rings, Style::zigzag})
        for (const Region& region : areas::all()) {
            const auto account = areas::judged(region, fill_region(region, 0, "area", with(style)), 0.4);
            EXPECT_GT(account.coverage, 0.97);
            EXPECT_LT(account.spill, 0.001);
        }
}

TEST(FillLaws, TurnedAndMirroredAreasAreFilledAsWell) {
    for (Style style : {Style::rings, Style::zigzag})
        for (const Region& region : areas::all())
            for (const Affine& map : {shapes::turned, shapes::mirrored}) {
                const Region other = shapes::moved({region}, map)[0];
                const auto account = areas::judged(other, fill_region(other, 0, "area", with(style)), 0.4);
                EXPECT_GT(account.coverage, 0.97);
                EXPECT_LT(account.spill, 0.001);
            }
}

TEST(FillLaws, AScaledAreaWithAScaledRakeIsFilledTheSame) {
    for (Style style : {Style::rings, Style::zigzag})
        for (const Region& region : areas::all()) {
            const Region large = shapes::moved({region}, {8, 0, 0, 8, 0, 0})[0];
            Options options = with(style);
            const Fill here = fill_region(region, 0, "area", options);
            options.width *= 8;
            options.spacing *= 8;
            options.tolerance *= 8;
            options.min_area *= 64;
            const Fill there = fill_region(large, 0, "area", options);
            EXPECT_EQ(here.strokes.size(), there.strokes.size());
            EXPECT_NEAR(here.swept / here.area, there.swept / there.area, 0.01);
        }
}

TEST(FillLaws, RandomAreasWithHolesAreFilledWithoutSpill) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
        for (const Region& region : shapes::random_regions(seed))
            for (Style style : {Style::rings, Style::zigzag}) {
                Options options = with(style);
                options.narrow = Narrow::warn;  // else arms narrower than the rake spill, and are said
                const Fill fill = fill_region(region, 0, "area", options);
                EXPECT_TRUE(!fill.strokes.empty() || !fill.warnings.empty()) << seed;
                if (inset({region}, 0.2).empty()) continue;
                const auto account = areas::judged(region, fill, 0.4);
                EXPECT_LT(account.spill, 0.003) << seed;
                // What a disc as wide as the rake cannot reach is not asked for.
                const double reachable = area(inset(inset({region}, 0.2), -0.2)) / area(region);
                EXPECT_GT(account.coverage, reachable - 0.08) << seed;
            }
}

TEST(FillLaws, TheSameAreaGivesTheSameStrokes) {
    for (Style style : {Style::rings, Style::zigzag})
        for (const Region& region : areas::all())
            EXPECT_EQ(fill_region(region, 0, "area", with(style)).strokes,
                      fill_region(region, 0, "area", with(style)).strokes);
}

TEST(FillLaws, StrokesAreFillStrokesWithNodesAtTheirEnds) {
    for (Style style : {Style::rings, Style::zigzag}) {
        Options options = with(style);
        options.pins = 5;
        const Fill fill = fill_region(areas::two_holes(), 3, "area", options);
        EXPECT_EQ(fill.ways.size(), fill.strokes.size());
        double swept_area = 0;
        for (const Stroke& stroke : fill.strokes) {
            EXPECT_TRUE(stroke.one_way && stroke.fill && !stroke.closed);
            EXPECT_EQ(stroke.element, 3);
            EXPECT_EQ(stroke.pins, 5);
            ASSERT_EQ(stroke.nodes.size(), 2u);
            EXPECT_EQ(stroke.nodes[0].at, stroke.rake_path.front().start.at);
            EXPECT_NEAR(distance(stroke.nodes[1].at, end_pose(stroke.rake_path.back()).at), 0, 1e-9);
            const double length_of_all = length(stroke.rake_path);
            EXPECT_NEAR(stroke.nodes[1].s, length_of_all, 1e-9);
            swept_area += length_of_all * 0.4;
            for (std::size_t i = 1; i < stroke.rake_path.size(); ++i)
                EXPECT_NEAR(distance(end_pose(stroke.rake_path[i - 1]).at, stroke.rake_path[i].start.at), 0,
                            1e-9);
        }
        EXPECT_NEAR(fill.swept, swept_area, 0.02);
        EXPECT_NEAR(fill.area, area(areas::two_holes()), 1e-9);
    }
}

TEST(FillLaws, TheLastStrokeEndsOnTheBorder) {
    for (Style style : {Style::rings, Style::zigzag})
        for (const Region& region : areas::all()) {
            const Fill fill = fill_region(region, 0, "area", with(style));
            EXPECT_NEAR(distance_to_outline(region.outer, fill.strokes.back().nodes.back().at), 0.2, 0.01);
        }
}

TEST(FillLaws, RakeUpWaysStayInside) {
    for (const Region& region : areas::all()) {
        const Fill fill = fill_region(region, 0, "area", with(Style::rings));
        for (const Polyline& way : fill.ways)
            for (Point p : way) EXPECT_TRUE(contains(region, p));
    }
}

}  // namespace
}  // namespace strandline::fill
