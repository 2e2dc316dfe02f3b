#include <gtest/gtest.h>

#include "curve/random_poses.hpp"
#include "math/curve/curve.hpp"

namespace strandline {
namespace {

using testing::Dice;

Curve random_curve(Dice& dice) {
    Curve curve{dice.pose(2), {}};
    for (int i = 0; i < 4; ++i)
        curve.pieces.push_back({dice.uniform(0, 2), dice.uniform(-3, 3), dice.uniform(-4, 4)});
    return curve;
}

void expect_same_place(Pose a, Pose b, double tolerance) {
    EXPECT_NEAR(distance(a.at, b.at), 0, tolerance);
    EXPECT_NEAR(wrap_angle(a.heading - b.heading), 0, tolerance);
}

TEST(Clothoid, AQuarterCircleEndsBesideItsCentre) {
    expect_same_place(end_pose({{{0, 0}, 0}, {{pi / 2, 1, 0}}}), {{1, 1}, pi / 2}, 1e-14);
}

TEST(Clothoid, TheUnitClothoidEndsAtTheFresnelIntegrals) {
    // C(1) and S(1) of integral cos, sin (pi t^2 / 2): Abramowitz and Stegun, table 7.7.
    expect_same_place(end_pose({{{0, 0}, 0}, {{1, 0, pi}}}),
                      {{0.7798934003768228, 0.4382591473903548}, pi / 2}, 1e-13);
}

TEST(Clothoid, AVerySmallSharpnessIsNearlyAnArc) {
    expect_same_place(end_pose({{{0, 0}, 0}, {{40, 1, 1e-14}}}), end_pose({{{0, 0}, 0}, {{40, 1, 0}}}), 1e-9);
}

TEST(Clothoid, ReversedRunsThroughTheSamePointsBackwards) {
    Dice dice(4);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random_curve(dice), back = reversed(curve);
        const double whole = length(curve), s = dice.uniform(0, whole);
        const CurvePoint there = point_at(curve, s), here = point_at(back, whole - s);
        expect_same_place({there.pose.at, there.pose.heading + pi}, here.pose, 1e-11);
        EXPECT_NEAR(there.curvature, -here.curvature, 1e-9);
    }
}

TEST(Clothoid, SlicesJoinToTheWhole) {
    Dice dice(5);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random_curve(dice);
        const double whole = length(curve), s = dice.uniform(0, whole);
        const Curve first = slice(curve, 0, s), second = slice(curve, s, whole);
        EXPECT_NEAR(length(first), s, 1e-12);
        expect_same_place(end_pose(first), second.start, 1e-11);
        expect_same_place(end_pose(joined(first, second)), end_pose(curve), 1e-11);
    }
    EXPECT_TRUE(slice(random_curve(dice), 0, 0).pieces.empty());
}

TEST(Clothoid, SamplesAreEvenAndHoldBothEnds) {
    Dice dice(6);
    for (int i = 0; i < 50; ++i) {
        const Curve curve = random_curve(dice);
        const auto points = sampled(curve, 0.05, 9);
        ASSERT_GE(points.size(), 9u);
        const double step = length(curve) / static_cast<double>(points.size() - 1);
        EXPECT_LE(step, 0.05 + 1e-9);
        for (std::size_t k = 0; k < points.size(); ++k) {
            EXPECT_NEAR(points[k].s, step * static_cast<double>(k), 1e-9);
            expect_same_place(points[k].pose, point_at(curve, points[k].s).pose, 1e-10);
        }
        expect_same_place(points.back().pose, end_pose(curve), 0);
    }
}

TEST(HermiteClothoid, MeetsBothPosesWhateverTheyAre) {
    Dice dice(7);
    for (int i = 0; i < 20000; ++i) {
        const Pose from = dice.pose(1), to = dice.pose(1);
        const Curve curve = hermite_clothoid(from, to);
        const double chord = distance(from.at, to.at);
        ASSERT_LT(distance(end_pose(curve).at, to.at), 1e-10 * chord + 1e-14) << i;
        ASSERT_NEAR(wrap_angle(end_pose(curve).heading - to.heading), 0, 1e-9) << i;
    }
}

TEST(HermiteClothoid, FindsStraightsAndArcs) {
    const Clothoid line = hermite_clothoid({{0, 0}, 0}, {{3, 0}, 0}).pieces.front();
    EXPECT_NEAR(line.length, 3, 1e-12);
    EXPECT_NEAR(line.curvature, 0, 1e-12);
    const Clothoid arc = hermite_clothoid({{1, 0}, pi / 2}, {{0, 1}, pi}).pieces.front();
    EXPECT_NEAR(arc.length, pi / 2, 1e-10);
    EXPECT_NEAR(arc.curvature, 1, 1e-10);
    EXPECT_NEAR(arc.sharpness, 0, 1e-9);
}

TEST(Dubins, MeetsBothPosesAndIsNeverShorterThanTheChord) {
    Dice dice(8);
    for (int i = 0; i < 5000; ++i) {
        const double radius = dice.uniform(0.1, 2);
        const Pose from = dice.pose(3), to = dice.pose_near(from, radius);
        const Curve curve = dubins(from, to, radius);
        expect_same_place(end_pose(curve), to, 1e-8);
        EXPECT_LE(max_curvature(curve), 1 / radius);
        EXPECT_NEAR(length(curve), dubins_length(from, to, radius), 1e-9);
        EXPECT_GE(length(curve), distance(from.at, to.at) - 1e-9);
        EXPECT_NEAR(length(curve),
                    dubins_length({to.at, to.heading + pi}, {from.at, from.heading + pi}, radius), 1e-7);
    }
}

TEST(Dubins, KnownLengths) {
    EXPECT_NEAR(dubins_length({{0, 0}, 0}, {{10, 0}, 0}, 1), 10, 1e-12);
    EXPECT_NEAR(dubins_length({{0, 0}, 0}, {{0, 2}, pi}, 1), pi, 1e-9);
    EXPECT_NEAR(dubins_length({{0, 0}, 0}, {{0, 0}, 0}, 1), 0, 1e-12);
    // About turn on the spot: three circles that touch, 60 + 300 + 60 degrees.
    EXPECT_NEAR(dubins_length({{0, 0}, 0}, {{0, 0}, pi}, 1), 7 * pi / 3, 1e-9);
}

}  // namespace
}  // namespace strandline
