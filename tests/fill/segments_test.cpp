// Single segments of a zigzag with a direction or a style of their own.
#include <gtest/gtest.h>

#include <algorithm>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

const Region hall = areas::of({{{0, 0}, {10, 0}, {10, 6}, {0, 6}}});

/// Lines along x, a cut across the middle of the hall, a rake that lifts and turns on the spot.
Options halved() {
    Options options = areas::with(Style::zigzag);
    options.rake_turns = false;
    options.pivots = true;
    options.direction = 0;
    options.cuts = {{{5, -1}, {5, 7}}};
    return options;
}

/// Headings, modulo pi, of what is raked in a box, the border left out: radians in [0, pi).
std::vector<double> headings(const Fill& fill, Box box) {
    std::vector<double> found;
    for (const Stroke& stroke : fill.strokes)
        for (const Curve& curve : stroke.rake_path)
            for (const CurvePoint& p : sampled(curve, 0.02))
                if (contains(box, p.pose.at)) {
                    const double turned = std::remainder(p.pose.heading, pi);
                    found.push_back(turned < -1e-6 ? turned + pi : turned);
                }
    return found;
}
bool all_near(const std::vector<double>& values, double value) {
    return !values.empty() &&
           std::ranges::all_of(values, [&](double v) { return std::abs(v - value) < 0.01; });
}

/// The share of a region that stays bare.
double bare(const Region& region, const Fill& fill) { return 1 - areas::judged(region, fill, 0.4).coverage; }

TEST(FillSegments, EachHalfHasLinesInItsOwnDirection) {
    Options options = halved();
    options.segments = {{{2, 3}, 0.5}, {{8, 3}, 1.2}};
    const Fill fill = fill_region(hall, 0, "hall", options);
    EXPECT_TRUE(fill.warnings.empty());
    EXPECT_TRUE(all_near(headings(fill, {{1, 1}, {4, 5}}), 0.5));
    EXPECT_TRUE(all_near(headings(fill, {{6, 1}, {9, 5}}), 1.2));
    options.segments.pop_back();
    EXPECT_TRUE(all_near(headings(fill_region(hall, 0, "hall", options), {{6, 1}, {9, 5}}), 0));
}

TEST(FillSegments, APartOfAPartitionHasItsOwnDirection) {
    const Region arms = areas::letter_l();
    Options options = halved();
    options.cuts.clear();
    options.partition = Partition::optimal_convex;
    options.segments = {{{1, 5}, 0.5}};
    const Fill fill = fill_region(arms, 0, "arms", options);
    EXPECT_TRUE(all_near(headings(fill, {{0.6, 3}, {1.4, 5.4}}), 0.5));
    std::size_t across = 0;
    for (double heading : headings(fill, {{3, 0.6}, {4.4, 1.4}})) {
        EXPECT_GT(std::abs(heading - 0.5), 0.1);
        across += std::abs(heading) < 0.01;
    }
    EXPECT_GT(across, 100u);
}

TEST(FillSegments, ASegmentInRingsOrASpiralIsRakedWholeBeforeTheBorder) {
    for (Style style : {Style::rings, Style::spiral}) {
        Options options = halved();
        options.segments = {{{8, 3}, {}, style}};
        const Fill fill = fill_region(hall, 0, "hall", options);
        EXPECT_TRUE(fill.warnings.empty());
        EXPECT_TRUE(all_near(headings(fill, {{1, 1}, {4, 5}}), 0));
        // Beside the cut rings run along it (a spiral but for its shift), where lines would run across.
        for (double heading : headings(fill, {{5.1, 2.5}, {5.8, 3.5}}))
            EXPECT_NEAR(heading, pi / 2, style == Style::rings ? 0.01 : 0.8);
        EXPECT_GT(areas::judged(hall, fill, 0.4).coverage, 0.99);
        const rake::Account account = account_of(hall, fill.strokes, fill.ways, options);
        EXPECT_LT(account.overdraw, 0.03);
        EXPECT_LE(account.drives_over, style == Style::rings ? 0 : 1);
        // The border comes last, and all of it: cut at corners, so in four goes.
        double border = 0;
        bool begun = false;
        for (const Stroke& stroke : fill.strokes) {
            const Polyline line = areas::line_of(stroke);
            const bool along = distance_to_outline(hall.outer, point_at(line, length(line) / 2)) < 0.21;
            EXPECT_TRUE(along || !begun);
            begun = begun || along;
            if (along) border += length(line);
        }
        EXPECT_GT(border, 0.94 * perimeter(hall.outer));
    }
}

TEST(FillSegments, NoWhiteSeamIsLeftBesideRings) {
    const Region seam = areas::of({{{4.6, 1}, {5.4, 1}, {5.4, 5}, {4.6, 5}}});
    for (double spacing : {0.4, 0.36})
        for (double direction : {0.0, pi / 2}) {
            Options options = halved();
            options.spacing = spacing;
            options.direction = direction;
            options.segments = {{{8, 3}, {}, Style::rings}};
            EXPECT_LT(bare(seam, fill_region(hall, 0, "hall", options)), 0.01) << spacing << " " << direction;
        }
}

TEST(FillSegments, RingsRoundAHoleAreRakedBeforeTheBorderToo) {
    Options options = halved();
    options.cuts.clear();
    options.segments = {{{1.5, 4}, {}, Style::rings}};
    const Region ring = areas::ring();
    const Fill fill = fill_region(ring, 0, "ring", options);
    EXPECT_GT(areas::judged(ring, fill, 0.4).coverage, 0.98);
    EXPECT_LT(areas::judged(ring, fill, 0.4).spill, 0.001);
    EXPECT_NEAR(distance_to_outline(ring.outer, areas::line_of(fill.strokes.back()).back()), 0.2, 0.21);
    // No way leads through the hole.
    for (const Polyline& way : fill.ways)
        for (Point p : way) EXPECT_TRUE(contains(ring, p));
}

TEST(FillSegments, OneStrokeHoldsForAllStyles) {
    Options options = halved();
    options.one_stroke = true;
    options.segments = {{{8, 3}, {}, Style::rings}};
    EXPECT_EQ(fill_region(hall, 0, "hall", options).strokes.size(), 1u);
}

TEST(FillSegments, TheBordersStripBelongsToTheSegmentBesideIt) {
    Options options = halved();
    options.segments = {{{8, 3}, {}, Style::rings}};
    const Fill inside = fill_region(hall, 0, "hall", options);
    options.segments[0].at = {9.9, 5.9};
    const Fill corner = fill_region(hall, 0, "hall", options);
    EXPECT_TRUE(corner.warnings.empty());
    EXPECT_EQ(corner.swept, inside.swept);
}

TEST(FillSegments, AChoiceForNoSegmentIsNamedAndChangesNothing) {
    Options options = halved();
    const double swept = fill_region(hall, 0, "hall", options).swept;
    options.segments = {{{2, 3}, 0}, {{11, 3}, {}, Style::rings}};
    const Fill fill = fill_region(hall, 0, "hall", options);
    EXPECT_EQ(fill.swept, swept);
    EXPECT_TRUE(fill.warnings.empty());
    EXPECT_EQ(fill.segments_used, (std::vector<bool>{true, false}));
}

TEST(FillSegments, ChoicesForOnePartThatContradictEachOtherAreNamed) {
    Options options = halved();
    options.segments = {{{2, 3}, 0.5}, {{2, 4}, {}, Style::rings}};
    EXPECT_TRUE(fill_region(hall, 0, "hall", options).warnings.empty());
    options.segments = {{{2, 3}, 0.5}, {{8, 3}, 0.5}, {{2, 4}, 1.2}};
    const Fill fill = fill_region(hall, 0, "hall", options);
    ASSERT_EQ(fill.warnings.size(), 1u);
    EXPECT_EQ(fill.warnings[0].place, "hall");
    EXPECT_NE(fill.warnings[0].reason.find("segment choice 3"), std::string::npos);
}

TEST(FillSegments, ASegmentTooNarrowForItsStyleIsNamed) {
    Options options = halved();
    options.cuts = {
        {{0.9, -1}, {0.9, 7}}, {{0.82, -1}, {0.82, 7}}, {{-1, 3}, {5, 3}}, {{-1, 3.05}, {5, 3.05}}};
    options.segments = {{{0.86, 3.02}, {}, Style::rings}};
    const Fill fill = fill_region(hall, 0, "hall", options);
    ASSERT_EQ(fill.warnings.size(), 1u);
    EXPECT_NE(fill.warnings[0].reason.find("(0.86, 3.0"), std::string::npos) << fill.warnings[0].reason;
}

TEST(FillSegments, ChoicesAreReadFromText) {
    const auto choices =
        segment_choices_of("2,3 direction=30deg; 500cm,1m  style=rings direction=0.5rad;", "here");
    ASSERT_TRUE(choices);
    ASSERT_EQ(choices->size(), 2u);
    EXPECT_NEAR(*(*choices)[0].direction, pi / 6, 1e-12);
    EXPECT_FALSE((*choices)[0].style);
    EXPECT_EQ((*choices)[1].at, (Point{5, 1}));
    EXPECT_EQ((*choices)[1].style, Style::rings);
    EXPECT_EQ((*choices)[1].direction, 0.5);
    EXPECT_TRUE(segment_choices_of("", "here")->empty());
    for (const char* bad : {"direction=30", "1 style=rings", "1,2", "1,2 style=swirl", "1,2 direction=up",
                            "1,2 direction", "1,2 colour=red", "a,2 style=rings"}) {
        const auto refused = segment_choices_of(std::string("0,0 style=rings;") + bad, "here");
        ASSERT_FALSE(refused) << bad;
        EXPECT_EQ(refused.error().place, "here");
        EXPECT_NE(refused.error().reason.find("segment 2"), std::string::npos) << refused.error().reason;
    }
}

}  // namespace
}  // namespace strandline::fill
