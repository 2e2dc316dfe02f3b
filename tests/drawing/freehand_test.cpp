// Lines that a hand drew.
#include <gtest/gtest.h>

#include <random>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

/// Points every 5 cm along a wave, shaken by up to 1 cm.
std::vector<Point> shaken_wave() {
    std::mt19937_64 random(3);
    const auto shake = [&] { return 0.01 * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1); };
    std::vector<Point> points;
    for (double x = 0; x < 20; x += 0.05)
        points.push_back({10 + x + shake(), 50 + 2 * std::sin(x) + shake()});
    return points;
}
LineElement line_with(const std::vector<Point>& points, bool closed, double DrawingOptions::*tolerance,
                      double value) {
    DrawingOptions options = metre_a_unit();
    options.*tolerance = value;
    return line_of(drawn({stroked(path_through(points, closed))}, options), 0);
}
double worst_turn(const Path& path) {
    double worst = 0;
    const auto points = flattened(path, 1e-4);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        worst = std::max(worst, std::abs(wrap_angle(heading(points[i + 1] - points[i]) -
                                                    heading(points[i] - points[i - 1]))));
    return worst;
}
double worst_distance(const Path& path, const LineElement& plain) {
    double worst = 0;
    const auto chords = flattened(path, 1e-4);
    for (const Point p : flattened(plain.path, 1e-4)) worst = std::max(worst, distance_to(chords, p));
    return worst;
}

TEST(Freehand, SmoothingTakesTheJitterAndStaysWithinTheTolerance) {
    const LineElement plain = line_with(shaken_wave(), false, &DrawingOptions::smooth, 0);
    const LineElement smooth = line_with(shaken_wave(), false, &DrawingOptions::smooth, 0.03);
    EXPECT_GT(worst_turn(plain.path), 0.3);
    EXPECT_LT(worst_turn(smooth.path), 0.1);
    EXPECT_LT(worst_distance(smooth.path, plain), 0.031);
    EXPECT_LT(smooth.path.segments.size(), 30u);
}

TEST(Freehand, ASmoothLineNeverRunsAwayBetweenItsPoints) {
    std::mt19937_64 random(8);
    const auto shake = [&](double by) {
        return by * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
    };
    for (const double jitter : {0.01, 0.024, 0.05}) {
        std::vector<Point> spiral;
        for (int k = 0; k < 300; ++k)
            spiral.push_back(Point{50, 50} + (1 + 0.02 * k) * unit(0.06 * k) +
                             Point{shake(jitter), shake(jitter)});
        const LineElement plain = line_with(spiral, false, &DrawingOptions::smooth, 0);
        for (const double tolerance : {0.01, 0.02, 0.03, 0.05}) {
            const LineElement smooth = line_with(spiral, false, &DrawingOptions::smooth, tolerance);
            EXPECT_LT(worst_distance(smooth.path, plain), 1.01 * tolerance);
            EXPECT_LT(worst_distance(plain.path, smooth), 1.3 * tolerance)
                << "between the samples that are looked at";
            EXPECT_LT(length(smooth.path), 1.02 * length(plain.path));
        }
    }
}

TEST(Freehand, SimplifyingKeepsFewPointsAndEnds) {
    const LineElement plain = line_with(shaken_wave(), false, &DrawingOptions::simplify, 0);
    const LineElement few = line_with(shaken_wave(), false, &DrawingOptions::simplify, 0.05);
    EXPECT_LT(few.path.segments.size(), 60u);
    EXPECT_LT(worst_distance(few.path, plain), 0.05 + 0.05 / 4);
    EXPECT_EQ(few.path.start, plain.path.start);
    EXPECT_EQ(end_of(few.path), end_of(plain.path));
}

TEST(Freehand, MeantCornersStay) {
    std::vector<Point> square;
    for (int side = 0; side < 4; ++side)
        for (int k = 0; k < 20; ++k) {
            const double s = k / 2.0;
            square.push_back(Point{40, 40} + (side == 0   ? Point{s, 0}
                                              : side == 1 ? Point{10, s}
                                              : side == 2 ? Point{10 - s, 10}
                                                          : Point{0, 10 - s}));
        }
    const LineElement smooth = line_with(square, true, &DrawingOptions::smooth, 0.02);
    EXPECT_TRUE(smooth.path.closed);
    EXPECT_NEAR(length(smooth.path), 40, 0.01);
    EXPECT_GT(worst_turn(smooth.path), 1.5);
}

TEST(Freehand, ARoundClosedLineHasNoCornerAtItsSeam) {
    std::vector<Point> ring;
    for (int k = 0; k < 90; ++k) ring.push_back(Point{50, 50} + 10 * unit(k * pi / 45));
    const LineElement smooth = line_with(ring, true, &DrawingOptions::smooth, 0.02);
    const auto points = flattened(smooth.path, 1e-5);
    const std::size_t n = points.size();
    EXPECT_LT(std::abs(wrap_angle(heading(points[1] - points[0]) - heading(points[0] - points[n - 1]))),
              0.05);
    EXPECT_NEAR(length(smooth.path), 2 * pi * 10, 0.1);
}

}  // namespace
}  // namespace strandline
