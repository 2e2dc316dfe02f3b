#include "result/picture/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
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

TEST(Paper, IsTheSameBytesEveryTimeAndNamesItsScale) {
    const auto once = picture::pdf(sample_plan()), again = picture::pdf(sample_plan());
    ASSERT_TRUE(once && again);
    EXPECT_EQ(*once, *again);
    EXPECT_TRUE(once->starts_with("%PDF-1."));
    Plan plan = sample_plan();
    plan.drawing.canvas = {0, 0};
    plan.samples.clear();
    EXPECT_FALSE(picture::pdf(plan));
}

TEST(Paper, ReadBackByAnotherReaderAGrooveIsWhereTheRakeWas) {
    if (std::system("command -v pdftocairo >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "pdftocairo (poppler-utils) is not at hand";
    const std::string file = std::string(::testing::TempDir()) + "strandline-paper.pdf";
    std::ofstream(file, std::ios::binary) << picture::pdf(sample_plan()).value();
    std::string text;
    FILE* pipe = popen(("pdftocairo -svg '" + file + "' -").c_str(), "r");
    char buffer[4096];
    while (pipe && std::fgets(buffer, sizeof buffer, pipe)) text += buffer;
    EXPECT_EQ(pipe ? pclose(pipe) : -1, 0);
    std::remove(file.c_str());
    // The canvas is the first rectangle with a line round it, 10 m wide; the first dark line is stroke 0.
    const auto path = [&](const std::string& colour) {
        const auto at = text.find("stroke:rgb(" + colour);
        return at == std::string::npos ? "" : text.substr(text.find(" d=\"M", at) + 5, 4000);
    };
    double left = 0, y = 0, right = 0;
    ASSERT_EQ(std::sscanf(path("69.99").c_str(), " %lf %lf L %lf", &left, &y, &right), 3);
    double low = 0;
    ASSERT_EQ(std::sscanf(path("69.99").substr(path("69.99").find('L', 30)).c_str(), "L %*f %lf", &low), 1);
    const double bottom = std::max(y, low), metre = (right - left) / 10;
    std::string groove = path("12.99");
    groove = groove.substr(0, groove.find('"'));
    double x = 0, depth = 0;
    ASSERT_EQ(std::sscanf(groove.c_str(), " %lf %lf", &x, &depth), 2);
    EXPECT_NEAR((x - left) / metre, 2, 1e-3);
    EXPECT_NEAR((bottom - depth) / metre, 2, 1e-3);
    ASSERT_EQ(std::sscanf(groove.substr(groove.rfind('L')).c_str(), "L %lf %lf", &x, &depth), 2);
    EXPECT_NEAR((x - left) / metre, 6, 1e-3);
    EXPECT_NEAR((bottom - depth) / metre, 2, 1e-3);
}

}  // namespace
}  // namespace strandline
