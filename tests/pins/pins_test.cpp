#include "machine/pins/pins.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"

namespace strandline::pins {
namespace {

Robot slow_pins(double delay) {
    Robot robot = by_hand::raking_robot();
    robot.lift_delay = delay;
    return robot;
}
/// The mask at time t.
unsigned mask_at(const std::vector<Sample>& samples, double t) {
    unsigned mask = 0;
    for (const Sample& sample : samples)
        if (sample.t <= t) mask = sample.mask;
    return mask;
}

TEST(Pins, WithoutDelayNothingIsToldEarlier) {
    const Plan plan = by_hand::raked_plan();
    EXPECT_EQ(told(slow_pins(0), plan.samples), plan.samples);
}

TEST(Pins, EachChangeIsToldEarlierByTheDelay) {
    const std::vector<Sample> samples = by_hand::raked_plan().samples;
    const Robot robot = slow_pins(0.37);
    const std::vector<Sample> commands = told(robot, samples);
    EXPECT_GT(commands.size(), samples.size());
    for (double t = 0; t < samples.back().t - 0.4; t += 0.013)
        EXPECT_EQ(mask_at(commands, t), mask_at(samples, t + 0.37)) << t;
}

TEST(Pins, WhatIsToldInTimeIsDoneInTime) {
    const std::vector<Sample> samples = by_hand::raked_plan().samples;
    const Robot robot = slow_pins(0.15);
    const std::vector<Sample> again = done(robot, told(robot, samples));
    // The first stroke begins with the drive: its pins are down a delay later.
    for (double t = 0.16; t < samples.back().t; t += 0.007)
        EXPECT_EQ(mask_at(again, t), mask_at(samples, t)) << t;
}

TEST(Pins, TheInsertedInstantsLieOnTheDrive) {
    const std::vector<Sample> samples = by_hand::raked_plan().samples;
    const Robot robot = slow_pins(0.37);
    for (const Sample& sample : told(robot, samples)) {
        std::size_t i = 0;
        while (i + 2 < samples.size() && samples[i + 1].t <= sample.t) ++i;
        const double way = distance(samples[i].pose.at, samples[i + 1].pose.at);
        EXPECT_LE(distance(samples[i].pose.at, sample.pose.at), way + 1e-6);
        EXPECT_LE(distance(sample.pose.at, samples[i + 1].pose.at), way + 1e-6);
        EXPECT_NEAR(distance(sample.rake, sample.pose.at), robot.rake_offset, 1e-9);
    }
}

}  // namespace
}  // namespace strandline::pins
