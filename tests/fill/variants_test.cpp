// Other starts and exits that a fill offers.
#include <gtest/gtest.h>

#include <algorithm>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

using areas::with;

Point start_of(const std::vector<Stroke>& strokes) { return strokes.front().nodes.front().at; }
Point exit_of(const std::vector<Stroke>& strokes) { return strokes.back().nodes.back().at; }

double driven(const std::vector<Stroke>& strokes, const std::vector<Polyline>& ways) {
    double sum = 0;
    for (const rake::Move& move : rake::moves_of(strokes, ways, {}, 7, 0.0005)) sum += length(move.line);
    return sum;
}

TEST(FillVariants, NoneAreOfferedUnlessAskedFor) {
    EXPECT_TRUE(fill_region(areas::letter_l(), 0, "area", with(Style::rings)).variants.empty());
}

TEST(FillVariants, EachFillsTheAreaAsWellAndIsApartFromTheOthers) {
    for (const Style style : {Style::rings, Style::spiral, Style::zigzag})
        for (const Region& region : areas::all()) {
            Options options = with(style);
            options.variants = 6;
            const Fill fill = fill_region(region, 0, "area", options);
            const double coverage = areas::judged(region, fill, options.width).coverage;
            EXPECT_LE(fill.variants.size(), 6u);
            std::vector<std::pair<Point, Point>> ends{{start_of(fill.strokes), exit_of(fill.strokes)}};
            for (const Variant& variant : fill.variants) {
                Fill other;
                other.strokes = variant.strokes;
                const auto judged = areas::judged(region, other, options.width);
                EXPECT_GT(judged.coverage, coverage - 0.02);  // a seam in a bend leaves more
                EXPECT_LT(judged.spill, 0.005);
                EXPECT_NEAR(variant.longer,
                            driven(variant.strokes, variant.ways) - driven(fill.strokes, fill.ways),
                            0.02 * driven(fill.strokes, fill.ways));
                const std::pair mine{start_of(variant.strokes), exit_of(variant.strokes)};
                for (const auto& [start, exit] : ends)
                    EXPECT_GT(std::max(distance(mine.first, start), distance(mine.second, exit)),
                              options.width);
                ends.push_back(mine);
            }
        }
}

TEST(FillVariants, ASquareCanBeLeftOnAllFourSides) {
    Options options = with(Style::rings);
    options.variants = 20;
    const Fill fill = fill_region(areas::square(), 0, "area", options);
    const Box box = bounds(areas::square());
    std::vector<Point> exits{exit_of(fill.strokes)};
    for (const Variant& variant : fill.variants) exits.push_back(exit_of(variant.strokes));
    const auto leaves = [&](auto off) {
        return std::ranges::any_of(exits, [&](Point p) { return off(p) < 1.01 * options.width; });
    };
    EXPECT_TRUE(leaves([&](Point p) { return p.x - box.low.x; }));
    EXPECT_TRUE(leaves([&](Point p) { return box.high.x - p.x; }));
    EXPECT_TRUE(leaves([&](Point p) { return p.y - box.low.y; }));
    EXPECT_TRUE(leaves([&](Point p) { return box.high.y - p.y; }));
}

}  // namespace
}  // namespace strandline::fill
