// The spiral: one continuous line over nested rings.
#include <gtest/gtest.h>

#include <algorithm>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

constexpr double w = 0.4;
constexpr double all_round = 1e6;  // rake widths: longer than any turn here

Options spiral(double shift = 3.5) {
    Options options = areas::with(Style::spiral);
    options.shift = shift;
    options.pins = 1;
    return options;
}

Region disc(double radius) {
    Polygon circle;
    for (int i = 0; i < 360; ++i) circle.push_back(radius * unit(2 * pi * i / 360));
    return areas::of({circle});
}
Region dumb_bell() {
    return areas::of({{{0, 0},
                       {5, 0},
                       {5, 2.2},
                       {7, 2.2},
                       {7, 0},
                       {12, 0},
                       {12, 5},
                       {7, 5},
                       {7, 2.8},
                       {5, 2.8},
                       {5, 5},
                       {0, 5}}});
}

double leap(const Stroke& stroke) {
    double most = 0;
    for (std::size_t i = 1; i < stroke.rake_path.size(); ++i)
        most = std::max(most, distance(end_pose(stroke.rake_path[i - 1]).at, stroke.rake_path[i].start.at));
    return most;
}

/// The most that the line turns at one of its points.
double sharpest(const Polyline& line) {
    double most = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Point in = line[i] - line[i - 1], out = line[i + 1] - line[i];
        most = std::max(most, std::abs(std::atan2(cross(in, out), dot(in, out))));
    }
    return most;
}

/// Between neighbouring turns on a ray from the origin. The innermost rings are left out: they are too short
/// for a whole stretch, so theirs differ.
std::vector<double> gaps_on_a_ray(const Polyline& line, double angle) {
    std::vector<double> radii;
    const Point far = 100 * unit(angle);
    for (std::size_t i = 1; i < line.size(); ++i)
        if (const auto hit = crossing(line[i - 1], line[i], {0, 0}, far)) radii.push_back(length(hit->at));
    std::ranges::sort(radii);
    std::vector<double> gaps;
    for (std::size_t i = 1; i < radii.size(); ++i)
        if (radii[i - 1] > 4 * w) gaps.push_back(radii[i] - radii[i - 1]);
    return gaps;
}

TEST(Spiral, ASquareIsOneContinuousLineThatEndsOnTheBorder) {
    const Fill fill = fill_region(areas::square(), 0, "area", spiral());
    ASSERT_EQ(fill.strokes.size(), 1u);
    EXPECT_LT(leap(fill.strokes[0]), 1e-9);
    EXPECT_NEAR(distance_to_outline(areas::square().outer, fill.strokes[0].nodes.back().at), w / 2, 0.1 * w);
    EXPECT_LT(fill.swept / fill.area, 1.03);
}

TEST(Spiral, OnADiscThatShiftsAllRoundItIsASpiralOfArchimedes) {
    const Fill fill = fill_region(disc(5.0), 0, "disc", spiral(all_round));
    ASSERT_EQ(fill.strokes.size(), 1u);
    const Polyline line = areas::line_of(fill.strokes[0]);
    // The radius grows by a spacing a turn, evenly, between the first ring and the border.
    double turned = 0;
    std::vector<std::pair<double, double>> places;  // turns, radius
    for (std::size_t i = 1; i < line.size(); ++i) {
        turned += std::atan2(cross(line[i - 1], line[i]), dot(line[i - 1], line[i])) / (2 * pi);
        places.emplace_back(turned, length(line[i]));
    }
    int tried = 0;
    for (const auto& [turn, radius] : places) {
        if (std::abs(turn) < 2.5 || std::abs(turn) > std::abs(turned) - 2.5) continue;
        const auto later = std::ranges::find_if(
            places, [&](const auto& place) { return std::abs(place.first) >= std::abs(turn) + 0.5; });
        EXPECT_NEAR(later->second - radius, w / 2, 0.05 * w);
        ++tried;
    }
    EXPECT_GT(tried, 100);
}

TEST(Spiral, NeighbouringTurnsAreASpacingApartAlsoWhereTheyShift) {
    for (double shift : {3.5, 6.0, all_round}) {
        const Polyline line = areas::line_of(fill_region(disc(5.0), 0, "disc", spiral(shift)).strokes.at(0));
        for (int k = 0; k < 90; ++k)
            for (double gap : gaps_on_a_ray(line, 0.01 + 2 * pi * k / 90))
                EXPECT_LT(gap, shift < all_round ? 1.1 * w : 1.02 * w) << shift;  // across a slanting pass
    }
}

TEST(Spiral, TheLineNeverTurnsSharplyWhereTheOutlineDoesNot) {
    for (double shift : {3.5, all_round}) {
        const Fill fill = fill_region(disc(5.0), 0, "disc", spiral(shift));
        ASSERT_EQ(fill.strokes.size(), 1u);
        Polyline line = areas::line_of(fill.strokes[0]);
        // Off the innermost ring, which is smaller than the rake.
        std::erase_if(line, [](Point p) { return length(p) < 2 * w; });
        EXPECT_LT(sharpest(line), 0.35) << shift;
    }
    // Rings that step out half a width before they close turn a right angle there.
    const Fill rings = fill_region(disc(5.0), 0, "disc", areas::with(Style::rings));
    EXPECT_GT(sharpest(areas::line_of(rings.strokes.at(0))), 1);
}

TEST(Spiral, AShortShiftLeavesLessTwiceRakedThanOneAllRound) {
    const double close = fill_region(areas::square(), 0, "area", spiral()).swept;
    const double thesis = fill_region(areas::square(), 0, "area", spiral(all_round)).swept;
    EXPECT_NEAR(thesis - close, 0.5 * w * perimeter(areas::square().outer), 0.25 * thesis);
    EXPECT_GT(thesis, 1.05 * close);
}

TEST(Spiral, SideBranchesAreSpiralsOfTheirOwnRakedFirst) {
    const Fill fill = fill_region(dumb_bell(), 0, "area", spiral());
    ASSERT_EQ(fill.strokes.size(), 2u);
    const Polyline first = areas::line_of(fill.strokes[0]);
    const bool left = first.front().x < 6;
    for (Point p : first) EXPECT_EQ(p.x < 5.2, left);  // stays in its room
    const Box last = bounds(areas::line_of(fill.strokes[1]));
    EXPECT_NEAR(last.width(), 12 - w, 0.02);  // the last turn follows the whole outline
}

TEST(Spiral, RoundAHoleItRunsOutwards) {
    const Region ring = areas::of({disc(6.1).outer, disc(2.1).outer});  // ten rakes wide
    const Fill fill = fill_region(ring, 0, "ring", spiral());
    ASSERT_EQ(fill.strokes.size(), 1u);
    EXPECT_NEAR(length(fill.strokes[0].nodes.front().at), 2.1 + w / 2, 0.3 * w);
    EXPECT_NEAR(length(fill.strokes[0].nodes.back().at), 6.1 - w / 2, 0.1 * w);
    EXPECT_LT(fill.swept / fill.area, 1.06);
}

TEST(Spiral, NearlyAllIsRakedAndNothingOutsideForEveryShiftAndInset) {
    for (double shift : {3.5, 6.0, all_round})
        for (Insets insets : {Insets::offset, Insets::skeleton})
            for (const Region& region : areas::all())
                for (const Affine& map : {Affine{}, shapes::turned, shapes::mirrored}) {
                    const Region other = shapes::moved({region}, map)[0];
                    Options options = spiral(shift);
                    options.insets = insets;
                    const auto account = areas::judged(other, fill_region(other, 0, "area", options), w);
                    EXPECT_GT(account.coverage, shift < all_round ? 0.97 : 0.93) << shift;
                    EXPECT_LT(account.spill, 0.001) << shift;
                }
}

TEST(Spiral, RandomAreasAreFilledWithoutSpillByContinuousStrokes) {
    for (std::uint64_t seed = 101; seed <= 112; ++seed)
        for (const Region& region : shapes::random_regions(seed)) {
            const Fill fill = fill_region(region, 0, "area", spiral());
            EXPECT_TRUE(!fill.strokes.empty() || !fill.warnings.empty()) << seed;
            if (inset({region}, w / 2).empty()) continue;
            for (const Stroke& stroke : fill.strokes) EXPECT_LT(leap(stroke), 1e-6) << seed;
            // Both styles serve narrow places alike; the line itself adds nothing to that.
            const auto account = areas::judged(region, fill, w);
            const auto rings =
                areas::judged(region, fill_region(region, 0, "area", areas::with(Style::rings)), w);
            EXPECT_LT(account.spill, rings.spill + 0.001) << seed;
            if (area(inset(inset({region}, w / 2), -w / 2)) > 0.9 * area(region)) {
                EXPECT_GT(account.coverage, rings.coverage - 0.05) << seed;
            }
        }
}

TEST(Spiral, TheSameAreaGivesTheSameStrokes) {
    for (const Region& region : areas::all())
        EXPECT_EQ(fill_region(region, 0, "area", spiral()).strokes,
                  fill_region(region, 0, "area", spiral()).strokes);
}

TEST(Spiral, WithoutASkeletonEuclideanInsetsAreUsedWithAWarningAndCounted) {
    Polygon circle;
    for (int i = 0; i < 1500; ++i) circle.push_back(3 * unit(2 * pi * i / 1500));
    Options options = spiral();
    options.insets = Insets::skeleton;
    const Fill fill = fill_region(areas::of({circle}), 0, "wheel", options);
    EXPECT_EQ(fill.skeletons_replaced, 1);
    ASSERT_EQ(fill.warnings.size(), 1u);
    EXPECT_EQ(fill.warnings[0].place, "wheel");
    EXPECT_NE(fill.warnings[0].reason.find("1500 corners"), std::string::npos);
    EXPECT_EQ(fill_region(areas::square(), 0, "area", options).skeletons_replaced, 0);
}

}  // namespace
}  // namespace strandline::fill
