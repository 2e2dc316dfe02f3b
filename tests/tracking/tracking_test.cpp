#include "result/tracking/tracking.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"

namespace strandline::tracking {
namespace {

const Localisation perfect{.noise = 0, .heading_noise = 0, .wander = 0, .slip = 0, .delay = 0};

TEST(Tracking, ARobotThatKnowsItsPlaceDrawsThePlan) {
    const Plan plan = by_hand::raked_plan();
    const Driven driven = tracking::driven(plan.robot, plan.samples, {.localisation = perfect});
    EXPECT_FALSE(driven.lost);
    EXPECT_LT(driven.most, 0.002);
    EXPECT_NEAR(driven.time, plan.samples.back().t, 0.02 * plan.samples.back().t);
}

TEST(Tracking, DelayAloneIsForeseen) {
    const Plan plan = by_hand::raked_plan();
    Localisation late = perfect;
    late.delay = 0.12;
    EXPECT_LT(tracking::driven(plan.robot, plan.samples, {.localisation = late}).most, 0.003);
}

TEST(Tracking, NoiseAndDriftStayWithinCentimetresForEverySeed) {
    const Plan plan = by_hand::raked_plan();
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Driven driven = tracking::driven(plan.robot, plan.samples, {.localisation = {}, .seed = seed});
        EXPECT_FALSE(driven.lost) << seed;
        EXPECT_LT(driven.most, 0.06) << seed;
        EXPECT_GT(driven.most, 0.002) << seed;  // there is noise
    }
}

TEST(Tracking, OneSeedOneDriveAndAnotherSeedAnother) {
    const Plan plan = by_hand::raked_plan();
    const auto once = [&](std::uint64_t seed) {
        return tracking::driven(plan.robot, plan.samples, {.localisation = {}, .seed = seed}).samples;
    };
    EXPECT_EQ(once(5), once(5));
    EXPECT_NE(once(5), once(6));
}

TEST(Tracking, TheMachineKeepsItsLimits) {
    const Plan plan = by_hand::raked_plan();
    const Driven driven = tracking::driven(plan.robot, plan.samples, {.localisation = {}, .seed = 3});
    const Robot& robot = plan.robot;
    constexpr double rounding = 1e-9;
    for (std::size_t i = 1; i < driven.log.size(); ++i) {
        const LogLine &a = driven.log[i - 1], &b = driven.log[i];
        const double dt = b.t - a.t;
        EXPECT_LE(b.speed, std::max(robot.speed, robot.travel_speed) + rounding);
        EXPECT_LE(std::abs(b.turn_rate), robot.turn_rate + rounding);
        EXPECT_LE(std::abs(b.speed - a.speed), robot.acceleration * dt + rounding);
        EXPECT_LE(std::abs(b.turn_rate - a.turn_rate), robot.turn_acceleration * dt + rounding);
    }
}

TEST(Tracking, PinsThatTakeTimeAreToldEarlier) {
    Plan plan = by_hand::raked_plan();
    plan.robot.lift_delay = 0.4;
    const auto lifted_at = [&](bool lead) {
        // Where the rake is when the first stroke's pins leave the sand.
        const Driven driven =
            tracking::driven(plan.robot, plan.samples, {.localisation = perfect, .lead_pins = lead});
        bool down = false;
        for (const Sample& sample : driven.samples) {
            if (down && sample.mask == 0) return sample.rake;
            down |= sample.mask != 0;
        }
        return Point{};
    };
    const Point wished = plan.samples[100].rake;  // the first stroke is 2 m long, 2 cm a sample
    EXPECT_EQ(plan.samples[99].stroke, 0);
    EXPECT_NE(plan.samples[100].stroke, 0);
    EXPECT_LT(distance(lifted_at(true), wished), 0.01);
    EXPECT_NEAR(distance(lifted_at(false), wished), 0.4 * plan.robot.speed, 0.012);
}

TEST(Tracking, NothingToDriveIsNothingDriven) { EXPECT_TRUE(tracking::driven({}, {}, {}).samples.empty()); }

}  // namespace
}  // namespace strandline::tracking
