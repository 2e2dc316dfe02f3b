#include "path/trajectory/trajectory.hpp"

#include <gtest/gtest.h>

namespace strandline::trajectory {
namespace {

/// A straight leg of the robot.
Leg straight_leg(Motion motion, double from, double to) {
    const Curve curve = straight({{from, 0}, 0}, to - from);
    return {motion, motion == Motion::draw ? 0 : -1, states_along(curve, 0.01), {}};
}
const std::vector<Stroke> one_stroke(1);

TEST(Trajectory, SamplesAreEvenTimedAndMasked) {
    const Robot robot = *builtin_robot("beachbot");
    const auto samples = timed({straight_leg(Motion::connect, 0, 2), straight_leg(Motion::draw, 2, 5),
                                straight_leg(Motion::lead, 5, 5.5)},
                               one_stroke, robot, {.step = 0.02});
    ASSERT_GE(samples.size(), 276u);
    double drawn = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        EXPECT_GT(samples[i].t, samples[i - 1].t) << i;
        EXPECT_NEAR(distance(samples[i].pose.at, samples[i - 1].pose.at), 0.02, 1e-9) << i;
        EXPECT_EQ(samples[i - 1].mask, samples[i - 1].motion == Motion::draw ? 8u : 0u) << i;
        if (samples[i - 1].motion == Motion::draw) drawn += distance(samples[i].rake, samples[i - 1].rake);
    }
    EXPECT_NEAR(drawn, 3, 1e-9);
    EXPECT_EQ(samples.front().speed, 0);
    EXPECT_EQ(samples.back().speed, 0);
    EXPECT_EQ(samples.back().mask, 0u);
    EXPECT_NEAR(samples.back().t, 5.5 / 0.2 + 2, 0.2);
}

TEST(Trajectory, ATightTurnGetsFinerSamples) {
    const Robot robot = *builtin_robot("beachbot");
    const Curve turn{{{0, 0}, 0}, {{0.3, 10, 0}}};
    const Leg leg{Motion::draw, 0, states_along(turn, 0.01), {}};
    const auto samples = timed({leg}, one_stroke, robot, {.step = 0.02});
    for (std::size_t i = 1; i < samples.size(); ++i)
        EXPECT_LE(std::abs(wrap_angle(samples[i].pose.heading - samples[i - 1].pose.heading)), 0.1 + 1e-9)
            << i;
}

TEST(Trajectory, ATightConnectionIsNotDrivenFasterThanTheRobotTurns) {
    const Robot robot = *builtin_robot("diffdrive");
    // curvature rises to 20 and falls again within 13 cm
    const Curve peak{{{0, 0}, 0}, {{0.0667, 0, 300}, {0.0667, 20.01, -300}}};
    const Leg leg{Motion::connect, -1, states_along(peak, 0.01), peak};
    for (const double before : {0.0, 0.003, 0.006, 0.009, 0.012, 0.015, 0.018}) {
        const Curve line = straight({{-before - 0.5, 0}, 0}, before + 0.5);
        const auto samples = timed({{Motion::connect, -1, states_along(line, 0.01), line}, leg}, {}, robot);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const double turn = std::abs(wrap_angle(samples[i].pose.heading - samples[i - 1].pose.heading));
            EXPECT_LE(turn, robot.turn_rate * (samples[i].t - samples[i - 1].t) * 1.01)
                << before << ", " << i;
        }
    }
}

TEST(Trajectory, TheRobotStandsWhereItsCurvatureJumps) {
    const Robot robot = *builtin_robot("beachbot");
    const Curve line = straight({{0, 0}, 0}, 1), bend{{{1, 0}, 0}, {{0.5, 2, 0}}};
    const auto samples = timed(
        {{Motion::draw, 0, states_along(line, 0.01), {}}, {Motion::draw, 0, states_along(bend, 0.01), {}}},
        one_stroke, robot, {.step = 0.02, .dwell = 0.25});
    int stands = 0;
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        if (samples[i].speed > 0 || samples[i - 1].speed > 0) continue;
        ++stands;
        EXPECT_NEAR(samples[i].t - samples[i - 1].t, 0.25, 1e-12);
        EXPECT_EQ(samples[i - 1].curvature, 0);
        EXPECT_EQ(samples[i].curvature, 2);
    }
    EXPECT_EQ(stands, 1);
}

/// Forward 1 m, back 1 m on a bend, forward 1 m.
Leg three_parts() {
    const Curve curve{{{0, 0}, 0}, {{1, 0, 0}, {-1, 1, 0}, {1, 0, 0}}};
    return {Motion::connect, -1, states_along(curve, 0.01), curve};
}

TEST(Trajectory, TheRobotStandsWhereItTurnsBackAndItsSpeedSaysWhichWay) {
    const Robot robot = *builtin_robot("beachbot");
    const auto samples = timed({three_parts()}, {}, robot, {.step = 0.02, .dwell = 0.25});
    double forward = 0, back = 0;
    int dwells = 0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const Sample &a = samples[i], &b = samples[i + 1];
        const double moved = distance(a.pose.at, b.pose.at),
                     ahead = dot(b.pose.at - a.pose.at, unit(a.pose.heading));
        (backs(a, b) ? back : forward) += moved;
        if (moved == 0) {
            ++dwells;
            EXPECT_NEAR(b.t - a.t, 0.25, 1e-12);
        } else {
            EXPECT_EQ(ahead < 0, backs(a, b)) << i;
        }
        EXPECT_LE(std::abs(b.speed - a.speed), robot.acceleration * (b.t - a.t) * 1.001 + 1e-9) << i;
        EXPECT_NEAR(a.turn_rate, a.speed * a.curvature, 1e-12) << i;
    }
    EXPECT_EQ(dwells, 2);
    EXPECT_NEAR(forward, 2, 1e-9);
    EXPECT_NEAR(back, 1, 1e-3);
}

TEST(Trajectory, TimedAnewItBacksUpWhereItDid) {
    const Robot robot = *builtin_robot("beachbot");
    const auto samples = timed({three_parts()}, {}, robot), again = retimed(samples, robot);
    ASSERT_EQ(again.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_NEAR(again[i].t, samples[i].t, 1e-3) << i;
        EXPECT_NEAR(again[i].speed, samples[i].speed, 1e-4) << i;
    }
}

TEST(Trajectory, ATurnOnTheSpotTakesItsTime) {
    const Robot robot = *builtin_robot("beachbot");
    const Leg turn{Motion::pivot, -1, {{0, {{1, 1}, 0}, 0}, {0, {{1, 1}, pi}, 0}}, {}};
    const auto samples = timed({turn}, {}, robot);
    ASSERT_GT(samples.size(), 10u);
    EXPECT_NEAR(samples.back().t, pi / 0.4 + 1, 0.05);  // a trapezoid: pi / 0.4 + 0.4 / 0.4 seconds
    for (const Sample& sample : samples) EXPECT_EQ(sample.pose.at, (Point{1, 1}));
    EXPECT_NEAR(std::abs(samples.back().pose.heading), pi, 1e-9);
}

}  // namespace
}  // namespace strandline::trajectory
