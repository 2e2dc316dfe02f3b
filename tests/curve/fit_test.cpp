#include <gtest/gtest.h>

#include <algorithm>

#include "curve/random_poses.hpp"
#include "math/curve/curve.hpp"

namespace strandline {
namespace {

using testing::Dice;

std::vector<Point> points_of(const std::vector<Curve>& curves, double step) {
    std::vector<Point> points;
    for (const Curve& curve : curves)
        for (const CurvePoint& p : sampled(curve, step)) points.push_back(p.pose.at);
    return points;
}

/// The law of every fit: near both ways, end to end, finite.
void expect_fits(const Path& path, const FitOptions& options, const std::string& what) {
    const auto curves = fitted(path, options);
    ASSERT_FALSE(curves.empty()) << what;
    EXPECT_LT(distance(curves.front().start.at, path.start), 1e-9) << what;
    EXPECT_LT(distance(end_pose(curves.back()).at, end_of(path)), options.tolerance / 5) << what;
    for (std::size_t i = 1; i < curves.size(); ++i)
        EXPECT_LT(distance(end_pose(curves[i - 1]).at, curves[i].start.at), options.tolerance / 5) << what;
    const double fine = options.tolerance / 20, step = length(path) / 2000;
    const Polyline fit = points_of(curves, step);
    Polyline exact = flattened(path, fine);
    if (path.closed) exact.push_back(path.start);
    double out = 0, back = 0;
    for (Point p : exact) out = std::max(out, distance_to(fit, p));
    for (Point p : fit) {
        ASSERT_TRUE(is_finite(p)) << what;
        back = std::max(back, distance_to(exact, p));
    }
    EXPECT_LT(out, 1.1 * options.tolerance) << what;
    EXPECT_LT(back, 1.1 * options.tolerance) << what;
}

Path cubic(Point a, Point b, Point c, Point d) { return {a, {CubicSegment{b, c, d}}, false}; }

TEST(Fit, ALineAndACircularArcAreOnePieceEach) {
    const Path path{
        {0, 0}, {LineSegment{{1, 0}}, ArcSegment{{1, 1}, {1, 0}, {0, 1}, -pi / 2, pi, {1, 2}}}, false};
    const auto curves = fitted(path, {});
    ASSERT_EQ(curves.size(), 1u);
    ASSERT_EQ(curves[0].pieces.size(), 2u);
    EXPECT_EQ(curves[0].pieces[0], (Clothoid{1, 0, 0}));
    EXPECT_NEAR(curves[0].pieces[1].curvature, 1, 1e-12);
    EXPECT_NEAR(curves[0].pieces[1].length, pi, 1e-12);
}

TEST(Fit, CornersStayCorners) {
    const auto curves = fitted(path_through({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true), {});
    ASSERT_EQ(curves.size(), 4u);
    for (const Curve& curve : curves) EXPECT_EQ(curve.pieces.size(), 1u);
}

TEST(Fit, ASmoothClosedPathIsOneCurveThatMeetsItself) {
    const Path ellipse{{2, 0}, {ArcSegment{{0, 0}, {2, 0}, {0, 1}, 0, 2 * pi, {2, 0}}}, true};
    const auto curves = fitted(ellipse, {});
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_LT(distance(end_pose(curves[0]).at, {2, 0}), 1e-9);
    EXPECT_NEAR(wrap_angle(end_pose(curves[0]).heading - curves[0].start.heading), 0, 1e-9);
    expect_fits(ellipse, {}, "ellipse");
}

TEST(Fit, RandomBeziersAndArcsStayWithinTheToleranceTurnedAndMirrored) {
    Dice dice(11);
    for (int i = 0; i < 60; ++i) {
        const FitOptions options{.tolerance = dice.uniform(0.0005, 0.01)};
        Path path = cubic(dice.point(1), dice.point(1), dice.point(1), dice.point(1));
        const Point center = dice.point(1), u = dice.point(1), v = dice.point(1);
        const double start = dice.uniform(-pi, pi), sweep = dice.uniform(-2 * pi, 2 * pi);
        const auto on = [&](double t) { return center + std::cos(t) * u + std::sin(t) * v; };
        path.segments.emplace_back(LineSegment{on(start)});
        path.segments.emplace_back(ArcSegment{center, u, v, start, sweep, on(start + sweep)});
        expect_fits(path, options, "path " + std::to_string(i));
        expect_fits(transformed(path, testing::similarity(dice)), options, "image " + std::to_string(i));
    }
}

TEST(Fit, DegenerateBeziersAreFittedAllTheSame) {
    const std::vector<std::pair<std::string, Path>> paths{
        {"start handle of no length", cubic({0, 0}, {0, 0}, {1, 1}, {2, 0})},
        {"end handle of no length", cubic({0, 0}, {1, 1}, {2, 0}, {2, 0})},
        {"both handles of no length", cubic({0, 0}, {0, 0}, {2, 0}, {2, 0})},
        {"loop that ends where it starts", cubic({0, 0}, {2, 1}, {-2, 1}, {0, 0})},
        {"cusp", cubic({0, 0}, {1, 1}, {0, 1}, {1, 0})},
        {"nearly a cusp", cubic({0, 0}, {1, 1}, {1e-6, 1}, {1, 0})},
        {"small loop", cubic({0, 0}, {1.05, 1}, {-0.05, 1}, {1, 0})},
        {"there and back on a line", cubic({0, 0}, {2, 0}, {-1, 0}, {1, 0})},
        {"beyond its end and back", cubic({0, 0}, {1, 0}, {3, 0}, {1, 0})},
        {"tiny handle", cubic({0, 0}, {1e-7, -1e-7}, {1, 1}, {2, 0})},
        {"needle", cubic({0, 0}, {5, 1e-5}, {5, -1e-5}, {0, 0})},
        {"flat ellipse", {{1, 0}, {ArcSegment{{0, 0}, {1, 0}, {0, 0}, 0, 2 * pi, {1, 0}}}, true}},
        {"almost flat ellipse", {{1, 0}, {ArcSegment{{0, 0}, {1, 0}, {0, 1e-3}, 0, 2 * pi, {1, 0}}}, true}},
    };
    for (const auto& [what, path] : paths) expect_fits(path, {}, what);
}

TEST(Fit, ABezierWithACuspHasOneCornerThere) {
    const auto curves = fitted(cubic({0, 0}, {1, 1}, {0, 1}, {1, 0}), {});
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_LT(distance(curves[1].start.at, {0.5, 0.75}), 1e-6);
    EXPECT_NEAR(wrap_angle(end_pose(curves[0]).heading - pi / 2), 0, 1e-6);
    EXPECT_NEAR(wrap_angle(curves[1].start.heading + pi / 2), 0, 1e-6);
    EXPECT_LT(std::max(max_curvature(curves[0]), max_curvature(curves[1])), 100);
}

TEST(Fit, PathsWithoutLengthGiveNothing) {
    EXPECT_TRUE(fitted({{1, 2}, {}, false}, {}).empty());
    EXPECT_TRUE(fitted(path_through({{1, 2}, {1, 2}, {1, 2}}, true), {}).empty());
    EXPECT_TRUE(fitted(cubic({1, 1}, {1, 1}, {1, 1}, {1, 1}), {}).empty());
    EXPECT_TRUE(fitted({{1, 1}, {ArcSegment{{1, 1}, {0, 0}, {0, 0}, 0, 3, {1, 1}}}, false}, {}).empty());
    EXPECT_TRUE(fitted({{1, 1}, {ArcSegment{{0, 1}, {1, 0}, {0, 1}, 0, 0, {1, 1}}}, false}, {}).empty());
}

TEST(Fit, ZeroLengthSegmentsLeaveNoTrace) {
    Path path = path_through({{0, 0}, {1, 0}, {1, 0}, {2, 0}}, false);
    path.segments.emplace_back(CubicSegment{{2, 0}, {2, 0}, {2, 0}});
    const auto curves = fitted(path, {});
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].pieces.size(), 2u);
}

Path chords_of_circle(double radius, int corners) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) points.push_back(radius * unit(2 * pi * i / corners));
    return path_through(points, true);
}

TEST(Fit, SmallTurnsAreSmoothedOver) {
    const auto curves = fitted(chords_of_circle(1, 360), {});
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(max_curvature(curves[0]), 1, 1e-3);
    expect_fits(chords_of_circle(1, 360), {}, "360 chords");
}

TEST(Fit, AFlattenedCircleBecomesRoundWhenAskedFor) {
    const Path path = chords_of_circle(0.5, 60);  // 6 degrees a corner, 5 cm a chord
    EXPECT_EQ(fitted(path, {}).size(), 60u);
    const FitOptions smooth{.smooth_angle = 0.26};
    const auto curves = fitted(path, smooth);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(max_curvature(curves[0]), 2, 0.01);
    expect_fits(path, smooth, "60 chords");
    EXPECT_EQ(fitted(chords_of_circle(5, 60), smooth).size(), 60u) << "the bulge is wider than the tolerance";
}

}  // namespace
}  // namespace strandline
