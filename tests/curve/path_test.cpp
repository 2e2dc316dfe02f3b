#include <gtest/gtest.h>

#include "curve/random_poses.hpp"
#include "math/curve/curve.hpp"

namespace strandline {
namespace {

using testing::Dice;

Path mixed_path(Dice& dice) {
    Path path{dice.point(2), {}, false};
    path.segments.emplace_back(LineSegment{dice.point(2)});
    path.segments.emplace_back(CubicSegment{dice.point(2), dice.point(2), dice.point(2)});
    const Point center = dice.point(2), u = dice.point(1), v = dice.point(1);
    const double start = dice.uniform(-pi, pi), sweep = dice.uniform(-2 * pi, 2 * pi);
    const auto on = [&](double t) { return center + std::cos(t) * u + std::sin(t) * v; };
    path.segments.emplace_back(LineSegment{on(start)});
    path.segments.emplace_back(ArcSegment{center, u, v, start, sweep, on(start + sweep)});
    return path;
}

const ArcSegment half_circle{{0, 0}, {1, 0}, {0, 1}, 0, pi, {-1, 0}};

TEST(Path, AHalfCircleIsPiLongAndOneHigh) {
    const Path path{{1, 0}, {half_circle}, false};
    EXPECT_NEAR(length(path), pi, 1e-9);
    const Box box = bounds(path);
    EXPECT_NEAR(box.high.y, 1, 1e-12);
    EXPECT_NEAR(box.low.y, 0, 1e-12);
    EXPECT_NEAR(box.low.x, -1, 1e-12);
}

TEST(Path, ABezierWithACuspHasTheLengthOfItsTwoBranches) {
    // x = 3t - 9t^2 + 6t^3 ... with crossed handles the curve turns back on itself along one line.
    const Path path{{0, 0}, {CubicSegment{{1, 0}, {-1, 0}, {0, 0}}}, false};
    // x(t) = 3t(1-t)(1-2t), extremes +-sqrt(3)/6: four monotone runs.
    EXPECT_NEAR(length(path), 4 * std::sqrt(3) / 6, 1e-9);
}

TEST(Path, ReversedKeepsLengthAndBoxAndSwapsEnds) {
    Dice dice(1);
    for (int i = 0; i < 50; ++i) {
        const Path path = mixed_path(dice), back = reversed(path);
        EXPECT_NEAR(length(back), length(path), 1e-8);
        EXPECT_EQ(back.start, end_of(path));
        EXPECT_EQ(end_of(back), path.start);
        EXPECT_NEAR(distance(bounds(back).high, bounds(path).high), 0, 1e-9);
    }
}

TEST(Path, FlattenedThenMappedIsMappedThenFlattened) {
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
        const Path path = mixed_path(dice);
        const Affine map{
            dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(-2, 2), 1, -1};
        const Polyline mapped_chords = flattened(transformed(path, map), 1e-4);
        Polyline chords = flattened(path, 1e-6);
        for (Point& p : chords) EXPECT_LT(distance_to(mapped_chords, apply(map, p)), 1.1e-4);
    }
}

TEST(Path, ChordsStayWithinTheTolerance) {
    Dice dice(3);
    for (int i = 0; i < 50; ++i) {
        const Path path = mixed_path(dice);
        const Polyline coarse = flattened(path, 0.01);
        for (Point p : flattened(path, 1e-6)) EXPECT_LT(distance_to(coarse, p), 0.010001);
        const Box box = bounds(path);
        for (Point p : coarse) EXPECT_TRUE(contains(grown(box, 1e-12), p));
    }
}

TEST(Path, AClosedPathDoesNotRepeatItsStartInTheChords) {
    const Path square = path_through({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
    EXPECT_EQ(square.segments.size(), 4u);
    EXPECT_EQ(flattened(square, 0.01).size(), 4u);
    EXPECT_DOUBLE_EQ(length(square), 4);
}

TEST(Split, PiecesAddUpMeetAndLieOnThePath) {
    Dice dice(11);
    for (int round = 0; round < 100; ++round) {
        const Path path = mixed_path(dice);
        const double whole = length(path);
        std::vector<double> arcs{-1, 0.1 * whole, 0.35 * whole, 0.35 * whole, 0.9 * whole, 2 * whole};
        const auto places = places_at(path, arcs);
        ASSERT_EQ(places.size(), arcs.size());
        const auto pieces = split(path, places);
        ASSERT_EQ(pieces.size(), arcs.size() + 1);
        double run = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (i > 0) {
                EXPECT_EQ(pieces[i].start, end_of(pieces[i - 1]));
            }
            run += length(pieces[i]);
            if (i < arcs.size()) {
                EXPECT_NEAR(run, std::clamp(arcs[i], 0.0, whole), 1e-8 * whole);
            }
        }
        EXPECT_NEAR(run, whole, 1e-8 * whole);
        EXPECT_LT(distance(pieces[1].start, path.start), 1e-12);
        EXPECT_TRUE(pieces[3].segments.empty());
    }
}

TEST(Split, AHalfCircleCutInTheMiddleIsTwoQuarterArcs) {
    const Path path{{1, 0}, {half_circle}, false};
    const auto pieces = split(path, places_at(path, {pi / 2}));
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_NEAR(end_of(pieces[0]).y, 1, 1e-9);
    EXPECT_NEAR(std::get<ArcSegment>(pieces[1].segments.at(0)).sweep, pi / 2, 1e-9);
}

TEST(Split, AtAJointNothingIsLeftOver) {
    const Path path = path_through({{0, 0}, {1, 0}, {1, 1}}, false);
    const auto pieces = split(path, {1.0});
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0], path_through({{0, 0}, {1, 0}}, false));
    EXPECT_EQ(pieces[1], path_through({{1, 0}, {1, 1}}, false));
    EXPECT_EQ(split(path, {}).at(0), path);
}

}  // namespace
}  // namespace strandline
