#include <gtest/gtest.h>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

using areas::with;

/// The zigzag of a rake that is lifted in the turns.
Options lifted() {
    Options options = with(Style::zigzag);
    options.rake_turns = false;
    return options;
}

TEST(FillZigzag, RowsThatFitRakeARectangleExactlyOnce) {
    const Fill fill = fill_region(areas::of({{{0, 0}, {4, 0}, {4, 2.4}, {0, 2.4}}}), 0, "area", lifted());
    EXPECT_NEAR(fill.swept / fill.area, 1, 0.005);
    EXPECT_EQ(fill.strokes.size(), 5u);  // four rows along it, the border
}

TEST(FillZigzag, LineEndsAtSlantedEdgesLeaveAsMuchAsTheyOverlapWithinABudget) {
    const Region trapeze = areas::of({{{0, 0}, {10, 0}, {7, 6}, {3, 6}}});
    const Fill fill = fill_region(trapeze, 0, "area", lifted());
    const auto account = areas::judged(trapeze, fill, 0.4);
    EXPECT_GT(account.coverage, 0.994);
    EXPECT_LT(fill.swept / fill.area, 1.02);
    EXPECT_LT(account.spill, 1e-3);
}

TEST(FillZigzag, TheBarTurnsFlushWithASlantedEdgeOnlyWhereItIsLifted) {
    const Region trapeze = areas::of({{{0, 0}, {10, 0}, {7, 6}, {3, 6}}});
    Options options = lifted();
    options.direction = 0;
    options.partition = Partition::none;
    const Fill fill = fill_region(trapeze, 0, "area", options);
    const Polyline line = areas::line_of(fill.strokes[fill.strokes.size() / 2]);
    const double edge = heading(Point{-3, 6}), last = heading(line.back() - line[line.size() - 2]);
    const double first = heading(line[1] - line[0]);
    const bool leftwards = line.back().x < line.front().x;
    EXPECT_NEAR(std::abs(std::remainder((leftwards ? first : last) - edge, pi)), pi / 2, 0.02);
}

TEST(FillZigzag, AnAreaOfTwoArmsIsFilledInTwoDirectionsWhereThatFitsBetter) {
    // Arms 1.6 and 2 wide: rows along the second one waste none across the first.
    const Region arms = areas::of({{{0, 0}, {8, 0}, {8, 1.7}, {1.9, 1.7}, {1.9, 7}, {0, 7}}});
    Options options = lifted();
    const double fitted = fill_region(arms, 0, "area", options).swept;
    options.partition = Partition::none;
    EXPECT_LT(fitted, 0.98 * fill_region(arms, 0, "area", options).swept);
}

TEST(FillZigzag, CutsPartTheAreaAndEachPartHasItsOwnDirection) {
    const Region cross = areas::of({{{0, 0}, {9, 0}, {9, 2}, {0, 2}}});
    Options options = lifted();
    options.partition = Partition::none;
    const auto directions = [&] {
        std::vector<double> found;
        for (const Stroke& stroke : fill_region(cross, 0, "area", options).strokes)
            found.push_back(std::abs(std::sin(stroke.rake_path.front().start.heading)));
        return found;
    };
    const std::size_t whole = directions().size();
    options.cuts = {{{4, -1}, {5, 3}}};
    EXPECT_GT(directions().size(), whole);
    EXPECT_TRUE(fill_region(cross, 0, "area", options).warnings.empty());
}

TEST(FillZigzag, ACutThatPartsNothingIsNotUsed) {
    Options options = lifted();
    options.cuts = {{{1, 1}, {2, 1}}, {{3, -1}, {3, 7}}};
    const Fill fill = fill_region(areas::square(), 0, "square", options);
    EXPECT_TRUE(fill.warnings.empty());
    EXPECT_EQ(fill.cuts_used, (std::vector<bool>{false, true}));
}

TEST(FillZigzag, CutsAreReadFromText) {
    const auto cuts = cuts_of("0,2 4,2; 1,0 1m,500cm", "here");
    ASSERT_TRUE(cuts);
    ASSERT_EQ(cuts->size(), 2u);
    EXPECT_EQ((*cuts)[1][1], (Point{1, 5}));
    EXPECT_TRUE(cuts_of("", "here")->empty());
    for (const char* bad : {"1,2", "1,2 3", "a,b 1,1", "1,2 3,4; 5,6"})
        EXPECT_EQ(cuts_of(bad, "here").error().place, "here") << bad;
}

TEST(FillZigzag, OneStrokeNeverLifts) {
    for (const Region& region : areas::all()) {
        Options options = lifted();
        options.one_stroke = true;
        const Fill fill = fill_region(region, 0, "area", options);
        EXPECT_EQ(fill.strokes.size(), 1u);
        const auto account = areas::judged(region, fill, 0.4);
        EXPECT_GT(account.coverage, 0.99);
        EXPECT_LT(account.spill, 0.002);
    }
}

TEST(FillZigzag, HardlyAnyWayAroundAHoleGoesOverRakedSand) {
    const Fill fill = fill_region(areas::ring(), 0, "area", lifted());
    EXPECT_LE(account_of(areas::ring(), fill.strokes, fill.ways, lifted()).drives_over, 2);
}

TEST(FillZigzag, ZigzagLinesRunInTheGivenDirection) {
    Options options = with(Style::zigzag);
    options.direction = 0.3;
    options.border = options.rake_turns = false;
    const Fill fill = fill_region(areas::square(), 0, "area", options);
    EXPECT_GT(fill.strokes.size(), 15u);
    for (const Stroke& stroke : fill.strokes)
        EXPECT_NEAR(std::remainder(stroke.rake_path.front().start.heading - 0.3, pi), 0, 1e-9);
}

TEST(FillZigzag, TheBestDirectionOfALongAreaIsItsLength) {
    Options options = with(Style::zigzag);
    options.border = false;
    const Region bar = shapes::moved({areas::of({{{0, 0}, {9, 0}, {9, 1.6}, {0, 1.6}}})}, shapes::turned)[0];
    const Fill fill = fill_region(bar, 0, "area", options);
    const double along = heading(apply_to_vector(shapes::turned, {1, 0}));
    EXPECT_NEAR(std::remainder(fill.strokes.front().rake_path.front().start.heading - along, pi), 0, 1e-6);
    EXPECT_NEAR(fill.swept / fill.area, 1, 0.15);
}

TEST(FillZigzag, NeighbouringLinesKeepTheSpacing) {
    Options options{.style = Style::zigzag, .width = 0.4, .spacing = 0.3};
    options.direction = 0;
    options.border = options.rake_turns = false;
    const Fill fill = fill_region(areas::square(), 0, "area", options);
    ASSERT_EQ(fill.strokes.size(), 20u);
    for (std::size_t i = 1; i < fill.strokes.size(); ++i) {
        const double step = std::abs(fill.strokes[i].nodes[0].at.y - fill.strokes[i - 1].nodes[0].at.y);
        EXPECT_LE(step, 0.3 + 1e-9);
        EXPECT_GT(step, 0.29);
    }
}

TEST(FillZigzag, RakedTurnsJoinLinesAndLiftedOnesDoNot) {
    Options options = with(Style::zigzag);
    EXPECT_EQ(fill_region(areas::square(), 0, "area", options).strokes.size(), 2u);  // lines, border
    options.rake_turns = false;
    EXPECT_GT(fill_region(areas::square(), 0, "area", options).strokes.size(), 10u);
}

TEST(FillZigzag, EveryPartitionFills) {
    for (Partition partition :
         {Partition::none, Partition::monotone, Partition::optimal_convex, Partition::fitted})
        for (const Region& region : {areas::square(), areas::letter_l()}) {
            const Fill fill =
                fill_region(region, 0, "area",
                            {.style = Style::zigzag, .width = 0.4, .spacing = 0.4, .partition = partition});
            EXPECT_TRUE(fill.warnings.empty());
            EXPECT_GT(areas::judged(region, fill, 0.4).coverage, 0.98) << static_cast<int>(partition);
        }
}

TEST(FillZigzag, ConvexPartsOfAnAreaWithHolesAreReplacedWithAWarning) {
    const Fill fill = fill_region(
        areas::ring(), 0, "the ring",
        {.style = Style::zigzag, .width = 0.4, .spacing = 0.4, .partition = Partition::optimal_convex});
    ASSERT_EQ(fill.warnings.size(), 1u);
    EXPECT_EQ(fill.warnings[0].place, "the ring");
    EXPECT_NE(fill.warnings[0].reason.find("monotone"), std::string::npos);
    EXPECT_GT(areas::judged(areas::ring(), fill, 0.4).coverage, 0.98);
}

/// A C, 3 m wide, of chords.
Region letter_c() {
    Polygon outline;
    const auto arc = [&](double radius, double from, double to) {
        for (int i = 0; i <= 80; ++i) outline.push_back(radius * unit(from + (to - from) * i / 80));
    };
    arc(6, 0.8, 2 * pi - 0.8);
    arc(3, 2 * pi - 0.8, 0.8);
    return areas::of({outline});
}

TEST(FillZigzag, ChordsOfAnArcAreNoPartsOfTheirOwn) {
    for (double radius : {0.0, 0.3}) {
        Options options = with(Style::zigzag);
        options.partition = Partition::optimal_convex;
        options.turn_radius = radius;
        const Fill fill = fill_region(letter_c(), 0, "C", options);
        EXPECT_TRUE(fill.warnings.empty());
        EXPECT_LT(fill.strokes.size(), 16u);
    }
}

TEST(FillZigzag, AVehicleThatCannotTurnOnTheSpotIsGivenFewerTurnsAndParts) {
    const auto strokes = [](double radius) {
        Options options = with(Style::zigzag);
        options.turn_radius = radius;
        return fill_region(letter_c(), 0, "C", options).strokes.size();
    };
    EXPECT_LT(strokes(0.3), strokes(0));
}

TEST(FillZigzag, AnInsetOfThePartsLeavesSandBetweenThem) {
    Options options = with(Style::zigzag);
    const double full = fill_region(areas::ring(), 0, "area", options).swept;
    options.part_inset = 0.3;
    const Fill fill = fill_region(areas::ring(), 0, "area", options);
    EXPECT_LT(fill.swept, 0.95 * full);
    EXPECT_LT(areas::judged(areas::ring(), fill, 0.4).spill, 0.001);
}

TEST(FillZigzag, ACellBetweenTwoOutermostRingsIsRakedAllTheSame) {
    // Two rooms and a neck a hair narrower than the rake: whatever is raked next parts what is left.
    const Region hall = areas::of({{{0, -0.6},
                                    {1.5, -0.6},
                                    {1.5, -0.1995},
                                    {1.55, -0.1995},
                                    {1.55, -0.6},
                                    {3, -0.6},
                                    {3, 0.6},
                                    {1.55, 0.6},
                                    {1.55, 0.1995},
                                    {1.5, 0.1995},
                                    {1.5, 0.6},
                                    {0, 0.6}}});
    const Fill fill = fill_region(hall, 0, "hall", areas::with(Style::zigzag));
    EXPECT_GT(areas::judged(hall, fill, 0.4).coverage, 0.95);
}

}  // namespace
}  // namespace strandline::fill
