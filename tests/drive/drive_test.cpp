#include <gtest/gtest.h>

#include "drive/drives.hpp"

namespace strandline {
namespace {

using namespace drive_tests;
using drive::Above;
using drive::Below;

const Stroke right_angle = polyline({{0, 0}, {3, 0}, {3, 3}});
const Stroke blunt = polyline({{0, 0}, {3, 0}, {5, 2}});

TEST(Drive, AStraightLineIsOneLegWithoutLeads) {
    const drive::Drive result = drive::drive(polyline({{1, 1}, {4, 1}}), 5, 0, false, beachbot(), {});
    ASSERT_EQ(result.legs.size(), 1u);
    EXPECT_EQ(result.legs[0].motion, Motion::draw);
    EXPECT_EQ(result.legs[0].stroke, 5);
    EXPECT_NEAR(distance(result.start.pose.at, {1.2, 1}), 0, 1e-12);
    EXPECT_NEAR(distance(result.end.pose.at, {4.2, 1}), 0, 1e-12);
}

TEST(Drive, TwoPinsOfSevenLieEvenlyAboutTheLineWhicheverWayItIsDriven) {
    Stroke line = polyline({{1, 1}, {4, 1}});
    line.pins = 2;  // the middle one and the one right of it
    EXPECT_NEAR(drive::drive(line, 0, 0, false, beachbot(), {}).start.pose.at.y, 1.03, 1e-12);
    EXPECT_NEAR(drive::drive(line, 0, 1, true, beachbot(), {}).start.pose.at.y, 0.97, 1e-12);
    Robot axle = beachbot();
    axle.rake_offset = 0;
    EXPECT_NEAR(drive::drive(line, 0, 0, false, axle, {}).start.pose.at.y, 1, 1e-12) << "it cannot";
}

TEST(Drive, ReversedItRunsTheOtherWay) {
    const drive::Drive result = drive::drive(polyline({{1, 1}, {4, 1}}), 0, 1, true, beachbot(), {});
    EXPECT_NEAR(distance(result.start.pose.at, {3.8, 1}), 0, 1e-12);
    EXPECT_NEAR(distance(result.end.pose.at, {0.8, 1}), 0, 1e-12);
}

TEST(Drive, ACornerBelowTheThresholdIsDrawnExactlyInTwoLegs) {
    const drive::Drive result = drive::drive(blunt, 0, 0, false, beachbot(), {});
    EXPECT_EQ(result.exact, 1);
    EXPECT_EQ(count(result, Motion::draw), 2);
    EXPECT_EQ(count(result, Motion::loop), 0);
    EXPECT_NEAR(expect_drivable(result, beachbot()), length(blunt.rake_path), 1e-4);
    EXPECT_LT(worst_rake_error(result, beachbot(), blunt), 1e-6);
}

TEST(Drive, ALoopOutsideLeavesTheCornerSharpAndDrawsBothEdgesWhole) {
    const drive::Drive result = drive::drive(right_angle, 0, 0, false, beachbot(), {});
    EXPECT_EQ(result.loops, 1);
    EXPECT_EQ(count(result, Motion::loop), 1);
    EXPECT_NEAR(expect_drivable(result, beachbot()), 6, 1e-4);
    EXPECT_LT(worst_rake_error(result, beachbot(), right_angle), 1e-6);
    for (const Leg& leg : result.legs) {
        if (leg.motion != Motion::loop) continue;
        EXPECT_LE(max_curvature(leg.curve), 2 + 1e-9);
        EXPECT_LE(max_sharpness(leg.curve), 10 + 1e-6);
    }
}

TEST(Drive, ALoopWithItsLeadIsNoLongerThanTheBoundForCornerPoses) {
    // FINDINGS: corner pose back to corner pose costs at most 7.7 R
    const drive::Options always{.corner_threshold = 0};
    for (double turn = pi / 36; turn < pi; turn += pi / 36)
        for (const double side : {1.0, -1.0}) {
            const Stroke corner = polyline({{0, 0}, {3, 0}, Point{3, 0} + 3 * unit(side * turn)});
            const drive::Drive result = drive::drive(corner, 0, 0, false, beachbot(), always);
            double rake_up = 0;
            for (const Leg& leg : result.legs)
                if (leg.motion != Motion::draw) rake_up += length(leg.path);
            EXPECT_EQ(result.loops, 1);
            EXPECT_LT(rake_up, 7.7 * beachbot().min_radius) << turn;
            EXPECT_NEAR(expect_drivable(result, beachbot()), 6, 1e-4);
        }
}

TEST(Drive, ARobotWithAWiderTurnToOneSideLoopsAndLeadsWithinIt) {
    Robot robot = beachbot();
    robot.right_radius = 0.9;
    for (const double side : {1.0, -1.0}) {
        const Stroke corner = polyline({{0, 0}, {3, 0}, Point{3, 0} + 3 * unit(side * 2)});
        const drive::Drive result = drive::drive(corner, 0, 0, false, robot, {});
        EXPECT_EQ(result.loops, 1);
        for (const Leg& leg : result.legs)
            for (const Clothoid& piece : leg.curve.pieces)
                for (const double k : {piece.curvature, piece.end_curvature()}) {
                    EXPECT_LE(k, 2 + 1e-9);
                    EXPECT_GE(k, -1 / 0.9 - 1e-9);
                }
        const Stroke bend = along({{{1, 2}, 0.7}, {{0.8, side * 4, 0}}});
        const drive::Drive tight = drive::drive(bend, 0, 0, false, robot, {});
        EXPECT_NEAR(tight.start.curvature, side > 0 ? 2 : -1 / 0.9, 1e-3);
        EXPECT_NEAR(tight.end.curvature, side > 0 ? 2 : -1 / 0.9, 1e-3);
    }
}

TEST(Drive, ATightStartIsLedInToRakeUp) {
    const Robot robot = beachbot();
    const Stroke stroke =
        along({{{1, 2}, 0.7}, {{0.8, 4, 0}}});  // radius 0.25 m: the robot turns by far tighter than R
    const drive::Drive result = drive::drive(stroke, 0, 0, false, robot, {});
    ASSERT_EQ(result.legs.size(), 2u);
    EXPECT_EQ(result.legs[0].motion, Motion::lead);
    EXPECT_NEAR(std::abs(result.start.curvature), 1 / robot.min_radius, 1e-3);
    EXPECT_NEAR(expect_drivable(result, robot), length(stroke.rake_path), 1e-4);
    EXPECT_LT(worst_rake_error(result, robot, stroke), 1e-4);
    EXPECT_TRUE(result.undrivable.empty());
}

TEST(Drive, ARoundedCornerStaysWithinItsBoundOfTheDrawnOne) {
    const Robot robot = beachbot();
    const double radius = 0.4;
    const drive::Drive result =
        drive::drive(right_angle, 0, 0, false, robot, {.corner_radius = radius, .above = Above::round});
    EXPECT_EQ(result.rounded, 1);
    EXPECT_EQ(count(result, Motion::draw), 1);
    expect_drivable(result, robot);
    const double bound =
        radius *
        (1 - std::cos(pi / 4));  // from the edges; the corner itself is missed by radius (sqrt 2 - 1)
    const double worst = worst_rake_error(result, robot, right_angle);
    EXPECT_LT(worst, bound + 1e-6);
    EXPECT_GT(worst, 0.9 * bound);
}

TEST(Drive, ShortEdgesLimitTheRounding) {
    const Stroke stairs = polyline({{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {2, 1}, {3, 1}});
    const drive::Drive result =
        drive::drive(stairs, 0, 0, false, beachbot(), {.corner_radius = 0.5, .above = Above::round});
    EXPECT_EQ(result.rounded, 4);
    expect_drivable(result, beachbot());
    EXPECT_LT(worst_rake_error(result, beachbot(), stairs), 0.25 * (1 - std::cos(pi / 4)) + 1e-6);
}

TEST(Drive, AFillIsAlwaysRoundedInside) {
    // a zigzag whose edges between the passes are no longer than the rake is wide
    Stroke zigzag = polyline({{0, 0}, {3, 0}, {3, 0.4}, {0, 0.4}, {0, 0.8}, {3, 0.8}});
    zigzag.fill = true;
    const drive::Drive result = drive::drive(zigzag, 0, 0, false, beachbot(), {});
    EXPECT_EQ(result.rounded, 4);
    EXPECT_EQ(count(result, Motion::draw), 1);
    EXPECT_TRUE(result.undrivable.empty());
    expect_drivable(result, beachbot());
}

TEST(Drive, APivotWhereTheRobotCannotIsALoopAndCountedSo) {
    const drive::Drive result = drive::drive(right_angle, 0, 0, false, beachbot(), {.above = Above::pivot});
    EXPECT_EQ(result.pivots, 0);
    EXPECT_EQ(result.loops, 1);
}

TEST(Drive, APivotBringsTheTrailingRakeBackToTheCorner) {
    Robot robot = beachbot();
    robot.can_pivot = true;
    for (const Stroke& stroke : {right_angle, polyline({{0, 0}, {2, 0}, {0.2, -0.3}, {2, -1}})}) {
        const drive::Drive result = drive::drive(stroke, 0, 0, false, robot, {.above = Above::pivot});
        EXPECT_EQ(result.loops, 0);
        EXPECT_EQ(count(result, Motion::pivot), 2 * result.pivots);
        EXPECT_NEAR(expect_drivable(result, robot), length(stroke.rake_path), 1e-4);
        EXPECT_LT(worst_rake_error(result, robot, stroke), 1e-6);
    }
}

TEST(Drive, APlotterTurnsOnTheSpotAtEveryCornerAndNeverLoops) {
    const Robot plotter = *builtin_robot("plotter");
    const Stroke star = polyline({{0, 0}, {1, 0}, {0, 0.3}, {0.5, -0.5}, {0.9, 0.8}}, true);
    for (const auto below : {Below::exact, Below::round})
        for (const auto above : {Above::loop, Above::pivot, Above::round}) {
            const drive::Drive result =
                drive::drive(star, 0, 2, true, plotter, {.below = below, .above = above});
            EXPECT_EQ(result.pivots, 4);
            EXPECT_EQ(count(result, Motion::draw), 5);
            EXPECT_EQ(count(result, Motion::pivot), 4);
            EXPECT_EQ(result.legs.size(), 9u);
            EXPECT_NEAR(expect_drivable(result, plotter), length(star.rake_path), 1e-9);
            EXPECT_LT(worst_rake_error(result, plotter, star), 1e-9);
        }
}

TEST(Drive, AnOffsetOfZeroThatCannotPivotLoopsAndLeadsInAndOut) {
    Robot robot = beachbot();
    robot.rake_offset = 0;
    const drive::Drive cornered = drive::drive(blunt, 0, 0, false, robot, {});
    EXPECT_EQ(cornered.loops, 1);
    expect_drivable(cornered, robot);
    const drive::Drive tight = drive::drive(along({{}, {{0.8, 4, 0}}}), 0, 0, false, robot, {});
    EXPECT_EQ(count(tight, Motion::lead), 2);
    expect_drivable(tight, robot);
}

TEST(Drive, ACircleIsDrawnInOneLeg) {
    const Stroke circle = along({{{1, 0}, pi / 2}, {{2 * pi, 1, 0}}}, true);
    const drive::Drive result = drive::drive(circle, 0, 0, false, beachbot(), {});
    EXPECT_EQ(result.legs.size(), 1u);
    EXPECT_NEAR(expect_drivable(result, beachbot()), 2 * pi, 1e-4);
    EXPECT_EQ(result.exact + result.loops + result.rounded, 0);
}

TEST(Drive, AFillIsLiftedWhereTheRakeIsLostAndALineIsDrawnOn) {
    Stroke tight = along({{{2, 3}, 0}, {{2, 0, 0}, {0.1, 20, 0}, {2, 0, 0}}});
    const drive::Drive line = drive::drive(tight, 0, 0, false, beachbot(), {});
    EXPECT_EQ(count(line, Motion::draw), 1);
    EXPECT_GT(worst_rake_error(line, beachbot(), tight), 1e-3);

    tight.fill = true;
    const drive::Drive fill = drive::drive(tight, 0, 0, false, beachbot(), {});
    EXPECT_EQ(count(fill, Motion::draw), 2);
    EXPECT_EQ(count(fill, Motion::lead), 1);
    EXPECT_LT(worst_rake_error(fill, beachbot(), tight), 1.01e-3)
        << "lowered within a millimetre of its path";
    ASSERT_EQ(fill.undrivable.size(), 1u);
    EXPECT_NEAR(expect_drivable(fill, beachbot()), length(tight.rake_path) - fill.undrivable.front().length,
                0.02);
}

TEST(Drive, WhatTheRakeCannotFollowIsListedByPlace) {
    const Stroke tight = along({{{2, 3}, 0}, {{2, 0, 0}, {0.1, 20, 0}, {2, 0, 0}}});
    const drive::Drive result = drive::drive(tight, 0, 0, false, beachbot(), {});
    ASSERT_FALSE(result.undrivable.empty());
    for (const drive::Span& span : result.undrivable) EXPECT_NEAR(distance(span.at, {4, 3}), 0, 0.3);
    expect_drivable(result, beachbot());
}

TEST(Drive, NothingGivesNothing) { EXPECT_TRUE(drive::drive({}, 0, 0, false, beachbot(), {}).legs.empty()); }

}  // namespace
}  // namespace strandline
