// Passes, and ways between them, keep off sand that earlier ones have raked.
#include <gtest/gtest.h>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

/// A field of six round holes whose rings meet in ridges of every width.
Region field_of_holes(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<Polygon> outlines{{{0, 0}, {14, 0}, {14, 9}, {0, 9}}};
    for (int i = 0; i < 6; ++i) {
        const Point middle{2.5 + 4.5 * (i % 3) + shapes::uniform(random, -0.6, 0.6),
                           2.5 + 4.0 * (i / 3) + shapes::uniform(random, -0.6, 0.6)};
        const double radius = shapes::uniform(random, 0.3, 0.8);
        Polygon hole;
        for (int k = 0; k < 12; ++k) hole.push_back(middle + radius * unit(2 * pi * k / 12));
        outlines.push_back(hole);
    }
    return areas::of(outlines);
}

rake::Account accounted(const Region& region, Style style) {
    Options options = areas::with(style);
    options.pivots = true;
    const Fill fill = fill_region(region, 0, "area", options);
    return account_of(region, fill.strokes, fill.ways, options);
}

/// Of ten fields.
struct Sum {
    double drives_over = 0, coverage = 0, overdraw = 0;
};
Sum over_fields(Style style) {
    Sum sum;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const rake::Account account = accounted(field_of_holes(seed), style);
        sum.drives_over += account.drives_over;
        sum.coverage += account.coverage / 10;
        sum.overdraw += account.overdraw / 10;
    }
    return sum;
}

// Rings that ran where their insets lie drove over raked sand 13 times a field, spirals 28 times.
TEST(FillKeepOff, RingsAmongHolesSeldomRunOverRakedSandAndLeaveNoMoreBare) {
    const Sum sum = over_fields(Style::rings);
    EXPECT_LE(sum.drives_over, 7 * 10);
    EXPECT_GT(sum.coverage, 0.995);
    EXPECT_LT(sum.overdraw, 0.07);
}

TEST(FillKeepOff, SpiralsAmongHolesRunOverRakedSandLessOften) {
    const Sum sum = over_fields(Style::spiral);
    EXPECT_LE(sum.drives_over, 18 * 10);
    EXPECT_GT(sum.coverage, 0.994);
    EXPECT_LT(sum.overdraw, 0.085);
}

TEST(FillKeepOff, RandomAreasWithoutArmsHaveLessThanOneDriveOver) {
    int areas_filled = 0, drives_over = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        for (const Region& region : inset(inset(shapes::random_regions(seed), 0.5), -0.4)) {
            drives_over += accounted(region, Style::rings).drives_over;
            ++areas_filled;
        }
    EXPECT_GT(areas_filled, 20);
    EXPECT_LE(drives_over, 20);
}

}  // namespace
}  // namespace strandline::fill
