// Drives of any origin, read.
#include <gtest/gtest.h>

#include "check/valid_plan.hpp"
#include "machine/pins/pins.hpp"
#include "result/formats/formats.hpp"

namespace strandline::formats {
namespace {

surface::Surface sand_of(const Robot& robot, std::vector<Sample> samples) {
    return surface::laid({robot, std::move(samples), {}}, {.cell = 0.01});
}

TEST(DriveText, ThePairReadBackLeavesThePlansOwnSand) {
    for (const double delay : {0.0, 0.3}) {
        Plan plan = by_hand::raked_plan();
        plan.robot.lift_delay = delay;
        // A robot whose pins take time waits for the first of them.
        const double wait = delay;
        for (Sample& sample : plan.samples) sample.t += wait;
        if (wait > 0) {
            Sample stands = plan.samples.front();
            stands.t = 0;
            stands.mask = 0;
            plan.samples.insert(plan.samples.begin(), stands);
        }
        const BeachbotPair pair = write_beachbot(plan);
        const auto samples = read_beachbot(pair.robot, pair.rake, plan.robot, "a", "b");
        ASSERT_TRUE(samples.has_value());
        // The text has no time: its robot drives at its speeds, so masks told early are right but for ramps.
        const auto done = delay > 0 ? pins::done(plan.robot, *samples) : *samples;
        EXPECT_GT(
            surface::intersection_over_union(sand_of(plan.robot, done), sand_of(plan.robot, plan.samples)),
            delay > 0 ? 0.97 : 0.999);
    }
}

TEST(DriveText, CsvReadBackIsTheDrive) {
    const Plan plan = by_hand::raked_plan();
    const auto samples = read_drive_csv(write_csv(plan), plan.robot, "drive.csv");
    ASSERT_TRUE(samples.has_value());
    ASSERT_EQ(samples->size(), plan.samples.size());
    for (std::size_t i = 0; i < samples->size(); ++i) {
        EXPECT_LT(distance((*samples)[i].pose.at, plan.samples[i].pose.at), 2e-6);
        EXPECT_LT(distance((*samples)[i].rake, plan.samples[i].rake), 2e-6);
        EXPECT_EQ((*samples)[i].mask, plan.samples[i].mask);
    }
}

TEST(DriveText, ATableOfPlacesAloneIsEnough) {
    const Robot robot;
    const auto samples = read_drive_csv("pins,x,y\n0,0,0\n127,1,0\n0,2,0\n", robot, "drive.csv");
    ASSERT_TRUE(samples.has_value());
    EXPECT_EQ((*samples)[1].pose.heading, 0);
    EXPECT_NEAR((*samples)[1].rake.x, 1 - robot.rake_offset, 1e-12);
    EXPECT_NEAR((*samples)[2].t - (*samples)[1].t, 1 / robot.speed, 1e-12);
}

TEST(DriveText, ATurnOnTheSpotIsATurn) {
    const Robot robot;
    // From looking along x to looking along y; 128 stands where it begins.
    const auto samples = read_beachbot("0 0 8\n1 0 128\n1 0 8\n1 1 129\n",
                                       "-0.2 0 8\n0.8 0 128\n1 -0.2 8\n1 0.8 129\n", robot, "a", "b");
    ASSERT_TRUE(samples.has_value());
    EXPECT_GT(samples->size(), 10u);
    for (std::size_t i = 1; i < samples->size(); ++i)
        EXPECT_LT(std::abs(wrap_angle((*samples)[i].pose.heading - (*samples)[i - 1].pose.heading)), 0.11);
}

TEST(DriveText, WhatIsNoDriveIsRefusedByItsLine) {
    const Robot robot;
    const auto place_of = [](const auto& outcome) { return outcome ? "" : outcome.error().place; };
    EXPECT_EQ(place_of(read_beachbot("0 0 8\n1 x 8\n", "0 0 8\n1 0 8\n", robot, "a", "b")), "a, line 2");
    EXPECT_EQ(place_of(read_beachbot("0 0 8\n1 0 8\n", "0 0 8\n", robot, "a", "b")), "b");
    EXPECT_EQ(place_of(read_beachbot("0 0 8\n1 0 130\n", "0 0 8\n1 0 8\n", robot, "a", "b")), "a, line 2");
    EXPECT_EQ(place_of(read_beachbot("0 0 8\n1 0 8\n2 0 8\n", "0 0 8\n1 0 8\n", robot, "a", "b")), "b");
    EXPECT_EQ(place_of(read_drive_csv("x,y\n1,2\n", robot, "c")), "c, line 1");
    EXPECT_EQ(place_of(read_drive_csv("x,y,pins\n1,2,0\n1,nan,0\n", robot, "c")), "c, line 3");
    EXPECT_EQ(place_of(read_drive_csv("", robot, "c")), "c");
}

}  // namespace
}  // namespace strandline::formats
