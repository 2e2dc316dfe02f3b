#include "result/shade/shade.hpp"

#include <gtest/gtest.h>

namespace strandline::shade {
namespace {

TEST(Shade, AViewPutsTheUpperLeftCornerFirst) {
    const View view{{{0, 0}, {4, 2}}, 400};
    EXPECT_EQ(view.columns(), 400);
    EXPECT_EQ(view.rows(), 200);
    EXPECT_EQ(view.in_pixels({0, 2}), (Point{0, 0}));
    EXPECT_EQ(view.in_pixels({4, 0}), (Point{400, 200}));
}

TEST(Shade, EveryFlawHasItsColourAndItsKey) {
    surface::Surface sand(0.01);
    const auto square = [&](double x, unsigned bits) {
        const std::vector<Point> corners{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
        sand.mark(corners, bits);
    };
    using namespace surface;
    const unsigned cases[] = {
        wanted_fill | raked,         wanted_line, raked, rolled, wanted_line | raked | rolled,
        wanted_fill | raked | rolled};
    for (int k = 0; k < 6; ++k) square(k, cases[k]);
    const View view{{{0, 0}, {6, 1}}, 60};
    const Image image = flaws(sand, view);
    const std::vector<Key> keys = flaw_keys();
    ASSERT_EQ(keys.size(), 6u);
    for (std::size_t k = 0; k < keys.size(); ++k)
        EXPECT_EQ(image.at(static_cast<int>(k) * 10 + 5, 5), keys[k].colour) << keys[k].meaning;
}

TEST(Shade, RepaintingAllIsPaintingAnew) {
    Robot robot;
    surface::Drive drive{robot, {}, {}};
    for (int i = 0; i < 50; ++i) {
        Sample sample;
        sample.pose = {{0.5 + 0.02 * i, 1}, 0};
        sample.rake = rake_at(robot, sample.pose);
        sample.mask = 0b1111111;
        drive.samples.push_back(sample);
    }
    const surface::Surface sand = surface::laid(drive, {.cell = 0.01});
    const View view{{{0, 0}, {2, 2}}, 100};
    Image image = shade::sand(surface::Surface(0.01), view);
    EXPECT_NE(image.pixels, shade::sand(sand, view).pixels);
    repaint(image, sand, view, view.box);
    EXPECT_EQ(image.pixels, shade::sand(sand, view).pixels);
}

TEST(Shade, AConvexShapeIsPaintedAndClippedToTheImage) {
    const View view{{{0, 0}, {1, 1}}, 10};
    Image image = shade::sand(surface::Surface(0.01), view);
    const Rgb red{255, 0, 0};
    paint(image, view, {{-1, -1}, {0.5, -1}, {0.5, 0.5}, {-1, 0.5}}, red);
    EXPECT_EQ(image.at(2, 8), red);
    EXPECT_NE(image.at(7, 8), red);
    EXPECT_NE(image.at(2, 2), red);
}

}  // namespace
}  // namespace strandline::shade
