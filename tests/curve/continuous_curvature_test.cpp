#include <gtest/gtest.h>

#include "curve/random_poses.hpp"
#include "math/curve/curve.hpp"

namespace strandline {
namespace {

using testing::Dice;

/// The law: ends met in position, heading and curvature, limits kept, no jump of curvature. Gives the length.
double expect_curve_joins(const Curve& curve, const CurvatureState& from, const CurvatureState& to,
                          const CurveLimits& limits, const std::string& what) {
    const double right = limits.right_radius > 0 ? limits.right_radius : limits.radius;
    const double radius = std::min(limits.radius, right), k = 1 / radius;
    const double d = distance(from.pose.at, to.pose.at);
    const Pose end = end_pose(curve);
    EXPECT_EQ(curve.start, from.pose) << what;
    EXPECT_LT(distance(end.at, to.pose.at), 1e-9 * (radius + d)) << what;
    EXPECT_NEAR(wrap_angle(end.heading - to.pose.heading), 0, 1e-9) << what;
    EXPECT_LE(max_sharpness(curve), limits.sharpness * (1 + 1e-12)) << what;
    EXPECT_LT(max_curvature_jump(curve), 1e-12 * k) << what;
    const double k0 = curve.pieces.empty() ? from.curvature : curve.pieces.front().curvature;
    const double k1 = curve.pieces.empty() ? from.curvature : curve.pieces.back().end_curvature();
    EXPECT_NEAR(k0, from.curvature, 1e-12 * k) << what;
    EXPECT_NEAR(k1, to.curvature, 1e-12 * k) << what;
    EXPECT_GE(length(curve), dubins_length(from.pose, to.pose, radius) - 1e-7 * radius) << what;
    for (const Clothoid& piece : curve.pieces) {
        EXPECT_GT(piece.length, 0) << what;
        for (const double curvature : {piece.curvature, piece.end_curvature()}) {
            EXPECT_LE(curvature, (1 + 1e-12) / limits.radius) << what;
            EXPECT_GE(curvature, -(1 + 1e-12) / right) << what;
        }
    }
    return length(curve);
}

void expect_joins(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits,
                  const std::string& what) {
    const double plain = expect_curve_joins(continuous_curvature(from, to, limits), from, to, limits, what);
    const Curve refined = refined_continuous_curvature(from, to, limits);
    EXPECT_LE(expect_curve_joins(refined, from, to, limits, what + ", refined"), plain * (1 + 1e-9) + 1e-12)
        << what;
}

TEST(ContinuousCurvature, JoinsAnyStatesWithinAnyLimits) {
    Dice dice(20);
    for (int i = 0; i < 3000; ++i) {
        const CurveLimits limits{dice.uniform(0.05, 3), std::pow(10, dice.uniform(-0.5, 3))};
        const double k = 1 / limits.radius;
        const Pose from = dice.pose(10);
        expect_joins({from, dice.uniform(-k, k)}, {dice.pose_near(from, limits.radius), dice.uniform(-k, k)},
                     limits, "pair " + std::to_string(i));
    }
}

TEST(ContinuousCurvature, KeepsAnotherLeastRadiusOnEachSide) {
    Dice dice(24);
    for (int i = 0; i < 1000; ++i) {
        const CurveLimits limits{dice.uniform(0.3, 2), std::pow(10, dice.uniform(-0.5, 2)),
                                 dice.uniform(0.3, 2)};
        const auto curvature = [&] { return dice.uniform(-1 / limits.right_radius, 1 / limits.radius); };
        const Pose from = dice.pose(10);
        expect_joins({from, curvature()}, {dice.pose_near(from, 1), curvature()}, limits,
                     "pair " + std::to_string(i));
    }
}

TEST(ContinuousCurvature, AWiderTurnToTheRightMakesRightTurnsLongerAndLeftTurnsNot) {
    const CurveLimits both{1, 10}, lame{1, 10, 3};
    const CurvatureState from{}, left{{{-1, 3}, pi}, 0}, right{{{-1, -3}, pi}, 0};
    EXPECT_NEAR(length(refined_continuous_curvature(from, left, lame)),
                length(refined_continuous_curvature(from, left, both)), 1e-9);
    EXPECT_GT(length(refined_continuous_curvature(from, right, lame)),
              length(refined_continuous_curvature(from, right, both)) + 0.5);
}

TEST(ContinuousCurvature, JoinsAwkwardStates) {
    const double nudges[] = {0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3};
    const double headings[] = {0, pi, -pi, pi / 2, -pi / 2, 1e-9, pi - 1e-9};
    const double curvatures[] = {-1, 0, 1, 1e-9, 0.5};
    for (double sharpness : {0.02, 0.3, 2.5, 10.0, 1e4})
        for (double d : nudges)
            for (double sight : {0.0, pi / 2, pi, 2.5})
                for (double h : headings)
                    for (double k0 : curvatures)
                        for (double k1 : {1.0, 0.0, -1.0})
                            expect_joins({{{0, 0}, 0}, k0}, {{d * unit(sight), h}, k1}, {1, sharpness},
                                         "sharpness " + std::to_string(sharpness) + " d " +
                                             std::to_string(d) + " h " + std::to_string(h));
}

TEST(ContinuousCurvature, StraightAheadIsAStraight) {
    const Curve curve =
        continuous_curvature({{{1, 2}, 0.3}, 0}, {{Point{1, 2} + 5 * unit(0.3), 0.3}, 0}, {0.5, 10});
    EXPECT_NEAR(length(curve), 5, 1e-6);
}

TEST(ContinuousCurvature, TheReversedTaskHasTheSameLength) {
    Dice dice(21);
    int differ = 0;
    for (int i = 0; i < 300; ++i) {
        const CurvatureState from{dice.pose(3), dice.uniform(-1, 1)}, to{dice.pose(3), dice.uniform(-1, 1)};
        const CurvatureState back_from{{to.pose.at, to.pose.heading + pi}, -to.curvature};
        const CurvatureState back_to{{from.pose.at, from.pose.heading + pi}, -from.curvature};
        const double there = length(refined_continuous_curvature(from, to, {1, 2.5}));
        const double back = length(refined_continuous_curvature(back_from, back_to, {1, 2.5}));
        if (std::abs(there - back) > 1e-6) ++differ;
    }
    EXPECT_LE(differ, 3) << "a root may be seen from one end only, but rarely";
}

TEST(ContinuousCurvature, MirroredAndScaledTasksGiveMirroredAndScaledLengths) {
    Dice dice(22);
    for (int i = 0; i < 300; ++i) {
        const CurvatureState from{dice.pose(3), dice.uniform(-1, 1)}, to{dice.pose(3), dice.uniform(-1, 1)};
        const double scale = dice.uniform(0.1, 10);
        const auto image = [&](const CurvatureState& s) {
            return CurvatureState{{scale * Point{s.pose.at.x, -s.pose.at.y}, -s.pose.heading},
                                  -s.curvature / scale};
        };
        const double plain = length(continuous_curvature(from, to, {1, 2.5}));
        const double other =
            length(continuous_curvature(image(from), image(to), {scale, 2.5 / (scale * scale)}));
        EXPECT_NEAR(other / scale, plain, 1e-6) << i;
    }
}

TEST(ContinuousCurvature, IsNearlyDubinsWhenCurvatureMayJumpAlmost) {
    Dice dice(23);
    for (int i = 0; i < 200; ++i) {
        const Pose from = dice.pose(3), to = dice.pose(3);
        if (distance(from.at, to.at) < 0.5) continue;
        EXPECT_LT(length(continuous_curvature({from, 0}, {to, 0}, {1, 1e5})),
                  1.05 * dubins_length(from, to, 1))
            << i;
    }
}

}  // namespace
}  // namespace strandline
