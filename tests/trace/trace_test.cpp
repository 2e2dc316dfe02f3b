// Grey pixels -> regions.
#include <cmath>

#include "pictures.hpp"

namespace strandline::trace {
namespace {

Traced traced_well(const Picture& picture, const Options& options = {}) {
    auto result = traced(picture, options);
    if (!result) {
        ADD_FAILURE() << sentence(result.error());
        return {};
    }
    return *result;
}
std::string refusal(const Picture& picture, const Options& options = {}) {
    const auto result = traced(picture, options);
    return result ? "was traced" : sentence(result.error());
}
double area_of(const svg::Shape& shape) {
    double sum = 0;
    for (std::size_t i = 0; i < shape.subpaths.size(); ++i)
        sum += (i == 0 ? 1 : -1) * area(flattened(shape.subpaths[i], 0.001));
    return sum;
}
bool in_disc(int x, int y, double cx, double cy, double r) {
    return std::hypot(x + 0.5 - cx, y + 0.5 - cy) < r;
}

const Picture square = drawn(100, 80, [](int x, int y) { return x >= 10 && x < 30 && y >= 20 && y < 60; });

TEST(Otsu, PartsTwoGreysInTheirMiddle) {
    const Picture picture = drawn(
        10, 10, [](int x, int) { return x < 2; }, 50, 150);
    EXPECT_NEAR(*otsu(picture), 100.0 / 255, 1e-12);
}
TEST(Otsu, PartsTwoHeaps) {
    Picture picture{256, 2, {}, {}, {}};
    for (int i = 0; i < 256; ++i) picture.grey.push_back(static_cast<unsigned char>(40 + i % 20));
    for (int i = 0; i < 256; ++i) picture.grey.push_back(static_cast<unsigned char>(200 + i % 30));
    const double threshold = *otsu(picture) * 255;
    EXPECT_GT(threshold, 59);
    EXPECT_LT(threshold, 200);
}
TEST(Otsu, OneColourHasNoThreshold) {
    EXPECT_NE(refusal(drawn(
                          9, 9, [](int, int) { return true; }, 120))
                  .find("all one colour"),
              std::string::npos);
}

TEST(Trace, ASquareIsItsFourCorners) {
    const svg::Document document = traced_well(square, {.alphamax = 0}).document;
    ASSERT_EQ(document.shapes.size(), 1U);
    const svg::Shape& shape = document.shapes[0];
    EXPECT_EQ(shape.id, "region.1");
    EXPECT_TRUE(shape.fill);
    EXPECT_FALSE(shape.stroke);
    ASSERT_EQ(shape.subpaths.size(), 1U);
    EXPECT_EQ(bounds(shape.subpaths[0]), (Box{{10, 20}, {30, 60}}));
    EXPECT_EQ(area_of(shape), 20 * 40);
    EXPECT_EQ(document.view, (Box{{0, 0}, {100, 80}}));
}
TEST(Trace, ADiscIsRound) {
    const svg::Document document =
        traced_well(drawn(100, 100, [](int x, int y) { return in_disc(x, y, 40, 60, 25); })).document;
    ASSERT_EQ(document.shapes.size(), 1U);
    for (const Point p : flattened(document.shapes[0].subpaths[0], 0.01))
        EXPECT_NEAR(distance(p, {40, 60}), 25, 0.5);
    for (const Segment& segment : document.shapes[0].subpaths[0].segments)
        EXPECT_TRUE(std::holds_alternative<CubicSegment>(segment));
}
TEST(Trace, HolesAreHolesAndWhatStandsInThemIsItsOwnRegion) {
    const Traced result = traced_well(drawn(200, 200, [](int x, int y) {
        return (in_disc(x, y, 100, 100, 80) && !in_disc(x, y, 100, 100, 60)) || in_disc(x, y, 100, 100, 20);
    }));
    ASSERT_EQ(result.document.shapes.size(), 2U);
    EXPECT_EQ(result.holes, 1U);
    EXPECT_EQ(result.document.shapes[0].subpaths.size(), 2U);
    EXPECT_NEAR(area_of(result.document.shapes[0]), pi * (80 * 80 - 60 * 60), 60);
    EXPECT_NEAR(area_of(result.document.shapes[1]), pi * 20 * 20, 25);
}
TEST(Trace, InvertedItIsTheRest) {
    const Traced result = traced_well(square, {.invert = true, .alphamax = 0});
    ASSERT_EQ(result.document.shapes.size(), 1U);
    EXPECT_EQ(result.holes, 1U);
    EXPECT_EQ(area_of(result.document.shapes[0]), 100 * 80 - 20 * 40);
}
TEST(Trace, SpecksAreLeftOut) {
    const Picture picture =
        drawn(50, 50, [](int x, int y) { return (x < 2 && y < 2) || (x > 20 && y > 20); });
    EXPECT_EQ(traced_well(picture, {.despeckle = 3}).document.shapes.size(), 2U);
    EXPECT_EQ(traced_well(picture, {.despeckle = 4}).document.shapes.size(), 1U);
}
TEST(Trace, TheThresholdIsHeard) {
    Picture picture = drawn(
        40, 40, [](int x, int) { return x < 10; }, 20, 220);
    for (std::size_t i = 0; i < picture.grey.size(); ++i)
        if (i % 40 >= 10 && i % 40 < 20) picture.grey[i] = 120;
    EXPECT_NEAR(area_of(traced_well(picture, {.threshold = 0.2, .alphamax = 0}).document.shapes[0]), 400,
                1e-9);
    EXPECT_NEAR(area_of(traced_well(picture, {.threshold = 0.7, .alphamax = 0}).document.shapes[0]), 800,
                1e-9);
}
TEST(Trace, NothingOrAllInkIsRefused) {
    EXPECT_NE(refusal(drawn(
                          9, 9, [](int x, int) { return x < 4; }, 100, 200),
                      {.threshold = 0.2})
                  .find("darker"),
              std::string::npos);
    EXPECT_NE(refusal(drawn(
                          9, 9, [](int x, int) { return x < 4; }, 100, 200),
                      {.threshold = 0.9})
                  .find("brighter"),
              std::string::npos);
    const Picture speck = drawn(9, 9, [](int x, int y) { return x == 4 && y == 4; });
    EXPECT_NE(refusal(speck, {.despeckle = 2}).find("specks"), std::string::npos);
    EXPECT_EQ(refusal(speck, {.despeckle = 0}), "was traced");
}
TEST(Trace, WritesAndReadsBackTheSame) {
    const svg::Document document = traced_well(drawn(64, 64, [](int x, int y) {
                                       return in_disc(x, y, 30, 30, 22) && !in_disc(x, y, 26, 30, 9);
                                   })).document;
    const auto again = svg::read(svg::write(document));
    ASSERT_TRUE(again);
    ASSERT_EQ(again->shapes.size(), 1U);
    EXPECT_EQ(again->shapes[0].subpaths, document.shapes[0].subpaths);
}

}  // namespace
}  // namespace strandline::trace
