// Masks from the true track of a rake.
#include <gtest/gtest.h>

#include "path/rake/rake.hpp"
#include "region/areas.hpp"

namespace strandline::rake {
namespace {

const Rake four_pins{.width = 1, .pins = 4};
Regions box(double x, double y) { return {areas::of({{{0, 0}, {x, 0}, {x, y}, {0, y}}})}; }

/// Straight from one place to another in steps of 5 cm, the bar turned by `skew` out of the square.
Driven driven(Point from, Point to, double skew = 0, double before = 0) {
    Driven go{{}, before};
    const double along = std::atan2(to.y - from.y, to.x - from.x);
    const int steps = static_cast<int>(std::round(distance(from, to) / 0.05));
    for (int k = 0; k <= steps; ++k)
        go.bar.push_back({between(from, to, static_cast<double>(k) / steps), along + skew});
    return go;
}
/// How many of the steps between two shares of a go have exactly these pins down.
double share_with(const DrivenMasks& masks, unsigned mask, double from = 0, double to = 1) {
    const auto first = static_cast<std::ptrdiff_t>(from * static_cast<double>(masks.size()));
    const auto last = static_cast<std::ptrdiff_t>(to * static_cast<double>(masks.size()));
    return static_cast<double>(std::count(masks.begin() + first, masks.begin() + last, mask)) /
           static_cast<double>(last - first);
}

TEST(RakeDriven, OverFreshSandAllPinsAreDownAndBeyondItNone) {
    const auto masks = driven_masks(box(8, 1), {driven({-1, 0.5}, {9, 0.5})}, four_pins);
    ASSERT_TRUE(masks);
    ASSERT_EQ((*masks)[0].size(), 200u);
    EXPECT_EQ(share_with((*masks)[0], 0, 0, 0.09), 1);
    EXPECT_EQ(share_with((*masks)[0], 0b1111, 0.11, 0.89), 1);
    EXPECT_EQ(share_with((*masks)[0], 0, 0.91, 1), 1);
}

TEST(RakeDriven, SandIsRakedOnceByTheLastThatComesBy) {
    const auto masks = driven_masks(
        box(8, 1.75), {driven({0, 0.5}, {8, 0.5}), driven({0, 1.25}, {8, 1.25}, 0, 8)}, four_pins);
    ASSERT_TRUE(masks);
    EXPECT_GT(share_with((*masks)[0], 0b0111), 0.95);
    EXPECT_GT(share_with((*masks)[1], 0b1111), 0.95);
}

TEST(RakeDriven, ABarAskewRakesNarrowerAndItsPinsEnterOneByOne) {
    // Turned by 60 degrees to the left it is half as wide, and its right end leads by 0.87 m.
    const auto masks = driven_masks(box(8, 2), {driven({-2, 1}, {10, 1}, pi / 3)}, four_pins);
    ASSERT_TRUE(masks);
    const DrivenMasks& mask = (*masks)[0];
    const auto first_of = [&](unsigned pin) {
        return std::find_if(mask.begin(), mask.end(), [&](unsigned m) { return (m & pin) != 0; }) -
               mask.begin();
    };
    // The outer pins' middles lie 0.375 m from the rake's middle: 0.65 m apart along the way.
    EXPECT_NEAR(static_cast<double>(first_of(0b1000) - first_of(0b0001)) * 0.05, 0.65, 0.16);
    EXPECT_EQ(share_with(mask, 0b1111, 0.3, 0.7), 1);
}

TEST(RakeDriven, WhatATurnOnTheSpotSweepsIsRaked) {
    // Half a turn on the spot in a wide area, then on along the same way: the disc is not raked again.
    Driven turn{{}, 0};
    for (int k = 0; k <= 40; ++k) turn.bar.push_back({{4, 4}, pi * k / 40});
    const auto masks = driven_masks(box(8, 8), {turn, driven({3.6, 4}, {4.4, 4}, 0, 5)}, four_pins);
    ASSERT_TRUE(masks);
    const bool turned = share_with((*masks)[0], 0) < 0.5;
    const bool drove = share_with((*masks)[1], 0) < 0.5;
    EXPECT_NE(turned, drove);
}

TEST(RakeDriven, AnAreaTooLargeForSinglePinsIsSaid) {
    EXPECT_FALSE(driven_masks(box(1000, 1000), {driven({0, 0.5}, {8, 0.5})}, {.width = 0.1, .pins = 7}));
}

TEST(RakeVisible, ASliverIsAPinWideAndTheRestStays) {
    const Region sliver = areas::of({{{0, 0}, {4, 0}, {4, 0.02}, {0, 0.02}}});
    EXPECT_NEAR(area(visible(sliver, 0.06)), 4 * 0.08, 0.02);  // half a pin on either side
    const Region square = areas::square();
    EXPECT_NEAR(area(visible(square, 0.06)), area(square), 1e-6);
}

}  // namespace
}  // namespace strandline::rake
