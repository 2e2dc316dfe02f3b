#include "result/sand/sand.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"

namespace strandline {
namespace {

using by_hand::Drive;
using by_hand::line_element;
using by_hand::raking_robot;

Element box_element(Point low, Point high) {
    return {"box", "", RegionElement{{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}}, -1};
}
int crossings(const sand::Sand& sand) {
    int sum = 0;
    for (const sand::Blemish& b : sand.blemishes) sum += b.crossings;
    return sum;
}
double driven_over(const sand::Sand& sand) {
    double sum = 0;
    for (const sand::Blemish& b : sand.blemishes) sum += b.area;
    return sum;
}
double raked_area(const sand::Sand& sand) {
    double cells = 0;
    sand.ground.visit([&](int, int, const Cell& cell) { cells += cell.passes > 0 ? 1 : 0; });
    return cells * sand.ground.cell_size() * sand.ground.cell_size();
}

TEST(Sand, AStraightStrokeRakesItsLengthTimesItsPinsWidth) {
    for (double turn : {0.0, 0.4, pi / 2, 2.5}) {
        Drive drive(raking_robot(), {{5, 5}, turn});
        const int line = drive.element(
            line_element("line", path_through({drive.rake(), drive.rake() + 3.0 * unit(turn)}, false), 3));
        const sand::Sand sand = sand::simulate(drive.draw_ahead(line, 3, 3.0).ahead(1).finished());
        EXPECT_NEAR(raked_area(sand), 3.0 * 0.18, 0.02) << turn;
        EXPECT_EQ(sand.spill, 0);
        EXPECT_TRUE(sand.blemishes.empty());
        EXPECT_NEAR(sand.driven, 4.0, 1e-9);
    }
}

TEST(Sand, BarePiecesOfARegionAreListedWithTheirPlaceAndArea) {
    Drive drive(raking_robot(), {{5, 5}, 0});
    // Raked is a strip in the middle of its height: bare above it 0.3 m and below it 0.1 m high.
    const Point rake = drive.rake();
    const double half = drive.plan().robot.rake_width() / 2;
    Plan& plan = drive.plan();
    plan.drawing.elements.push_back(box_element(rake + Point{0, -half - 0.1}, rake + Point{3, half + 0.3}));
    drive.go({{3, 0, 0}}, Motion::draw, 0);
    plan.strokes.push_back({.element = 0, .fill = true});
    Plan finished = drive.finished();
    for (Sample& sample : finished.samples)
        if (sample.motion == Motion::draw) sample.mask = pin_mask(finished.robot, finished.robot.pins);
    const sand::Sand sand = sand::simulate(finished);
    ASSERT_EQ(sand.bare.size(), 2u);
    EXPECT_NEAR(sand.bare[0].area, 0.9, 0.1);
    EXPECT_NEAR(sand.bare[0].at.y, rake.y + half + 0.15, 0.16);
    EXPECT_NEAR(sand.bare[1].area, 0.3, 0.1);
    EXPECT_NEAR(sand.bare[1].at.y, rake.y - half - 0.05, 0.06);
    EXPECT_EQ(sand.bare[1].element, 0);
}

TEST(Sand, OnAnArcTheSkewBarRakesANarrowerSwath) {
    // FINDINGS, robot: R = 0.5 m, offset 0.2 m: swath 0.379 m for a bar of 0.42 m (0.5 is P's radius here).
    Drive drive(raking_robot(), {{5, 5}, 0});
    const Point centre{5, 5.5};
    const double rake_radius = std::sqrt(0.25 + 0.04);
    const int line = drive.element(
        line_element("arc", path_through({drive.rake(), drive.rake() + Point{1, 0}}, false), 7));
    drive.draw(line, 7, straight({drive.rake(), 0}, 1), {{pi / 2 * 0.5, 2, 0}});
    const sand::Sand sand = sand::simulate(drive.finished(), {.cell = 0.005});
    double inner = 9, outer = 0;
    sand.ground.visit([&](int i, int j, const Cell& cell) {
        const Point from_centre = sand.ground.centre(i, j) - centre;
        if (cell.passes == 0 || std::abs(heading(from_centre) + pi / 4) > 0.1) return;
        inner = std::min(inner, length(from_centre));
        outer = std::max(outer, length(from_centre));
    });
    EXPECT_LT(inner, rake_radius);
    EXPECT_NEAR(outer - inner, 0.379, 0.012);
}

TEST(Sand, NeighbouringStrokesCoverTheirRegionOnce) {
    const sand::Sand sand = sand::simulate(by_hand::raked_plan());
    ASSERT_EQ(sand.regions.size(), 1u);
    EXPECT_EQ(sand.regions[0].element, 2);
    EXPECT_NEAR(sand.regions[0].area, 1.6 * 1.26, 0.02);
    EXPECT_NEAR(sand.regions[0].covered / sand.regions[0].area, 1.0, 1e-3);
    EXPECT_NEAR(sand.regions[0].overdraw, 0, 1e-3);
    EXPECT_NEAR(sand.spill, 0, 2e-3);
    EXPECT_TRUE(sand.blemishes.empty());
}

TEST(Sand, AStrokeLongerThanItsRegionSpills) {
    Drive drive(raking_robot(), {{5, 5}, 0});
    const Point q = drive.rake();
    const int box = drive.element(box_element(q + Point{0, -0.21}, q + Point{1, 0.21}));
    const sand::Sand sand = sand::simulate(drive.draw_ahead(box, 7, 1.5, true).finished());
    EXPECT_NEAR(sand.spill, 0.5 * 0.42, 0.015);
    EXPECT_NEAR(sand.regions[0].covered, sand.regions[0].area, 1e-9);
}

TEST(Sand, RakedAgainIsOverdrawAndHolesAreNotTheRegions) {
    Drive drive(raking_robot(), {{5, 5}, 0});
    const Point q = drive.rake();
    Element framed = box_element(q + Point{-1, -2}, q + Point{4, 2});
    std::get<RegionElement>(framed.what).region.holes = {
        {q + Point{1, -0.5}, q + Point{1, 0.5}, q + Point{2, 0.5}, q + Point{2, -0.5}}};
    const int box = drive.element(framed);
    drive.draw_ahead(box, 7, 3.0, true).round_back(1.0, 1).round_back(1.0, 1).ahead(0.2);
    const double back = q.x - drive.rake().x;
    drive.ahead(back + 0.5).draw_ahead(box, 7, 0.4, true);
    const sand::Sand sand = sand::simulate(drive.finished());
    EXPECT_NEAR(sand.regions[0].area, 20 - 1, 0.02);
    EXPECT_NEAR(sand.regions[0].covered, 2 * 0.42, 0.02);
    EXPECT_NEAR(sand.regions[0].overdraw, 0.4 * 0.42, 0.02);
    EXPECT_NEAR(sand.spill, 0.42, 0.02);
}

/// Draws 2 m of a line, then goes round and back across it, or does so before it is drawn.
Plan crossing_plan(bool drawn_first) {
    Drive drive(raking_robot(), {{5, 5}, 0});
    if (!drawn_first)
        drive.turn(pi / 2)
            .ahead(2)
            .turn(-pi / 2)
            .turn(-pi / 2)
            .ahead(3)
            .turn(-pi / 2)
            .ahead(2)
            .turn(-pi / 2)
            .turn(-pi / 2);
    const int line = drive.element(line_element(
        "line", path_through({drive.rake(), drive.rake() + 2.0 * unit(drive.at().heading)}, false), 1));
    drive.draw_ahead(line, 1, 2.0);
    if (drawn_first) drive.turn(pi / 2).turn(pi / 2).ahead(0.5).turn(pi / 2).ahead(3);
    return drive.finished();
}

TEST(Sand, ALineCrossedAfterItIsDrawnIsABlemishOnceWithItsPlace) {
    const sand::Sand after = sand::simulate(crossing_plan(true));
    EXPECT_EQ(crossings(after), 1);
    ASSERT_EQ(after.blemishes.size(), 1u);
    EXPECT_EQ(after.blemishes[0].element, 0);
    EXPECT_NEAR(after.blemishes[0].at.y, 5, 1e-9);
    EXPECT_EQ(driven_over(after), 0);
    EXPECT_EQ(crossings(sand::simulate(crossing_plan(false))), 0);
}

TEST(Sand, WheelsOverARakedRegionAreABlemishOfTheirTracksArea) {
    Drive drive(raking_robot(), {{5, 5}, 0});
    const Point q = drive.rake();
    const int box = drive.element(box_element(q + Point{0, -0.21}, q + Point{2, 0.21}));
    drive.draw_ahead(box, 7, 2.0, true).turn(pi / 2).turn(pi / 2).ahead(0.5).turn(pi / 2).ahead(3);
    Plan plan = drive.finished();
    const sand::Sand sand = sand::simulate(plan);
    ASSERT_EQ(sand.blemishes.size(), 1u);
    EXPECT_NEAR(driven_over(sand), 2 * 0.05 * 0.42, 0.01);
    EXPECT_EQ(crossings(sand), 0);
    plan.robot.wheels.clear();
    EXPECT_TRUE(sand::simulate(plan).blemishes.empty());
}

TEST(Sand, WheelsInTheTracksOfOthersCountOnceAPass) {
    Drive drive(raking_robot(), {{5, 5}, 0});
    drive.plan().robot.wheels = {{{0, 0.1}, 0.05}, {{-0.3, 0.1}, 0.05}};
    const Point q = drive.rake();
    const int box = drive.element(box_element(q + Point{0, -0.21}, q + Point{2, 0.21}));
    drive.draw_ahead(box, 7, 2.0, true).turn(pi / 2).turn(pi / 2).ahead(0.5).turn(pi / 2).ahead(3);
    EXPECT_NEAR(driven_over(sand::simulate(drive.finished())), 0.05 * 0.42, 0.006);
}

TEST(Sand, ABrokenPlanThatJumpsFarAwayIsLaidAsFarAsItIsDriven) {
    Plan plan = by_hand::raked_plan();
    plan.samples[100].pose.at = {1e12, -1e300};
    const sand::Sand sand = sand::simulate(plan);
    EXPECT_LT(sand.ground.tiles(), 200u);
}

TEST(Sand, NoSamplesLeaveBareSand) {
    Plan plan = by_hand::raked_plan();
    plan.samples.clear();
    const sand::Sand sand = sand::simulate(plan);
    EXPECT_EQ(sand.ground.tiles(), 0u);
    ASSERT_EQ(sand.regions.size(), 1u);
    EXPECT_EQ(sand.regions[0].covered, 0);
}

}  // namespace
}  // namespace strandline
