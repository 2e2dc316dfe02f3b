#include "result/picture/picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "formats/sample_plan.hpp"

/// Asked by the leak sanitizer: fontconfig keeps about 1 KB of patterns to the end, whatever is painted.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }

namespace strandline {
namespace {

using testing::sample_plan;

unsigned big_endian(const std::string& bytes, std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

TEST(Picture, IsAPngWhoseLongerSideIsWhatWasAskedFor) {
    const auto bytes = picture::png(sample_plan(), {.pixels = 640});
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(std::max(big_endian(*bytes, 16), big_endian(*bytes, 20)), 640U);
    if (const char* folder = std::getenv("STRANDLINE_SHOW"))  // to look at it
        std::ofstream(std::string(folder) + "/sample.png", std::ios::binary)
            << picture::png(sample_plan()).value();
}

TEST(Picture, IsTheSameBytesEveryTime) {
    EXPECT_EQ(picture::png(sample_plan(), {.pixels = 300}).value(),
              picture::png(sample_plan(), {.pixels = 300}).value());
}

TEST(Picture, ArrowsAndLegendCanBeLeftOut) {
    const auto all = picture::png(sample_plan(), {.pixels = 300});
    const auto bare = picture::png(sample_plan(), {.pixels = 300, .arrows = false, .legend = false});
    ASSERT_TRUE(all && bare);
    EXPECT_NE(*all, *bare);
    EXPECT_EQ(big_endian(*bare, 16), big_endian(*bare, 20))
        << "a square canvas without legend is a square picture";
}

TEST(Picture, SizesThatMakeNoSenseAreErrors) {
    EXPECT_FALSE(picture::png(sample_plan(), {.pixels = 0}));
    EXPECT_FALSE(picture::png(sample_plan(), {.pixels = -5}));
    EXPECT_FALSE(picture::png(sample_plan(), {.pixels = 1'000'000}));
    Plan plan = sample_plan();
    plan.drawing.canvas = {0, 0};
    plan.samples.clear();
    EXPECT_FALSE(picture::png(plan));
    plan.drawing.canvas = {1e308, 1e308};
    picture::png(plan, {.pixels = 100});  // any answer but a crash
}

TEST(Picture, APlanWithoutSamplesOrWithNumbersThatAreNotFiniteIsStillPainted) {
    Plan plan = sample_plan();
    plan.samples[7].rake.x = std::nan("");
    EXPECT_TRUE(picture::png(plan, {.pixels = 100}));
    plan.samples.clear();
    EXPECT_TRUE(picture::png(plan, {.pixels = 100}));
}

}  // namespace
}  // namespace strandline
