#include "result/surface/surface.hpp"

#include <gtest/gtest.h>

namespace strandline::surface {
namespace {

Robot robot_with(std::vector<Wheel> wheels) {
    Robot robot;
    robot.wheels = std::move(wheels);
    return robot;
}

/// Straight from `from` along `heading`, samples 2 cm apart.
std::vector<Sample> straight_drive(const Robot& robot, Pose from, double metres, unsigned mask,
                                   double t = 0) {
    std::vector<Sample> samples;
    const int steps = static_cast<int>(std::lround(metres / 0.02));
    for (int i = 0; i <= steps; ++i) {
        Sample sample;
        sample.t = t + 0.1 * i;
        sample.pose = {from.at + metres * i / steps * unit(from.heading), from.heading};
        sample.rake = rake_at(robot, sample.pose);
        sample.mask = i < steps ? mask : 0;
        samples.push_back(sample);
    }
    return samples;
}
double area(const Surface& surface, unsigned bits) { return surface.area_of(bits, bits); }

TEST(Surface, EachPinsGrooveIsItsPitchWideWhateverTheHeading) {
    const Robot robot = robot_with({});
    for (const double turn : {0.0, 0.4, pi / 2, 2.5})
        for (const unsigned mask : {0b0001000U, 0b0101010U, 0b1111111U}) {
            const Drive drive{robot, straight_drive(robot, {{3, 3}, turn}, 2, mask), {}};
            const Surface sand = laid(drive, {.cell = 0.01});
            EXPECT_NEAR(area(sand, raked), 2 * pins_down(mask) * 0.06, 0.015) << turn << " " << mask;
        }
}

TEST(Surface, TheHighestBitIsTheLeftmostPin) {
    const Robot robot = robot_with({});
    const Drive drive{robot, straight_drive(robot, {{3, 3}, 0}, 1, 0b1000000), {}};
    const Surface sand = laid(drive, {.cell = 0.01});
    EXPECT_NE(sand.bits({3.3, 3.18}) & raked, 0u);
    EXPECT_EQ(sand.bits({3.3, 3}), 0u);
    EXPECT_EQ(sand.bits({3.3, 2.82}), 0u);
}

TEST(Surface, TheRakeErasesTracksAndWheelsMarkWhatWasRaked) {
    const Robot robot = robot_with({{{0, 0}, 0.1}});
    // The wheel rolls ahead of the rake: where all pins are down nothing of its track is left but the end,
    // which the rake did not reach.
    const auto there = straight_drive(robot, {{3, 3}, 0}, 2, 0b1111111);
    Drive drive{robot, there, {}};
    const Surface once = laid(drive, {.cell = 0.01});
    EXPECT_NEAR(area(once, rolled), robot.rake_offset * 0.1, 0.003);
    EXPECT_EQ(area(once, rolled | raked), 0);
    // Over it again with the rake up.
    const auto again = straight_drive(robot, {{3, 3}, 0}, 2, 0, 100);
    drive.samples.insert(drive.samples.end(), again.begin(), again.end());
    const Surface twice = laid(drive, {.cell = 0.01});
    EXPECT_NEAR(area(twice, rolled | raked), (2 - robot.rake_offset) * 0.1, 0.003);
    const Tile* tile = twice.find_tile(twice.index(3.5), twice.index(3.001));
    ASSERT_NE(tile, nullptr);
    EXPECT_NEAR(tile->touched[Surface::place_in_tile(twice.index(3.5), twice.index(3.001))], 102.5, 0.2);
}

TEST(Surface, ADriveLaidInPartsIsTheDriveLaidAtOnce) {
    const Robot robot = robot_with({{{0, 0.1}, 0.05}});
    const Drive drive{robot, straight_drive(robot, {{3, 3}, 0.7}, 3, 0b0111110), {}};
    const Options options{.cell = 0.01};
    Layer layer(drive, options);
    for (std::size_t k = 0; k < drive.samples.size(); k += 7) layer.lay_to(k);
    layer.lay_to(drive.samples.size());
    const Surface whole = laid(drive, options);
    EXPECT_EQ(intersection_over_union(layer.surface(), whole), 1);
    EXPECT_EQ(area(layer.surface(), rolled), area(whole, rolled));
}

TEST(Surface, HalfOverlappingBandsAreAThirdAlike) {
    const Robot robot = robot_with({});
    const Drive a{robot, straight_drive(robot, {{3, 3}, 0}, 2, 0b1111111), {}};
    const Drive b{robot, straight_drive(robot, {{3, 3.21}, 0}, 2, 0b1111111), {}};
    const Surface on_a = laid(a, {.cell = 0.01}), on_b = laid(b, {.cell = 0.01});
    EXPECT_NEAR(intersection_over_union(on_a, on_b), 1.0 / 3, 0.02);
    EXPECT_EQ(intersection_over_union(on_a, on_a), 1);
}

TEST(Surface, MemoryFollowsWhatIsTouchedSixBytesACell) {
    EXPECT_LE(sizeof(Tile), 6 * Tile::cells);
    const Robot robot = robot_with({});
    const Drive drive{robot, straight_drive(robot, {{3, 3}, 0}, 0.2, 0b0001000), {}};
    EXPECT_LE(laid(drive, {.cell = 0.01}).tiles(), 4u);
}

TEST(Surface, AJumpIsNotLaid) {
    const Robot robot = robot_with({{{0, 0}, 0.1}});
    Drive drive{robot, straight_drive(robot, {{3, 3}, 0}, 0.2, 0b1111111), {}};
    drive.samples.back().pose.at.x += 50;
    drive.samples.back().rake.x += 50;
    EXPECT_LT(area(laid(drive, {.cell = 0.01}), raked), 0.1);
}

}  // namespace
}  // namespace strandline::surface
