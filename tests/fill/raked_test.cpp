// Fills as the rake leaves them.
#include <gtest/gtest.h>

#include "fill/areas.hpp"
#include "path/rake/rake.hpp"

namespace strandline::fill {
namespace {

TEST(FillRaked, SpansAreInOrderWithinTheirStrokes) {
    Options options = areas::with(Style::zigzag);
    options.spacing = options.width * 6 / 7;
    for (const Region& region : areas::all()) {
        const Fill fill = fill_region(region, 0, "area", options);
        const auto masks = rake::pin_masks({region}, fill.strokes, fill.ways, {.width = options.width});
        ASSERT_EQ(masks.size(), fill.strokes.size());
        for (std::size_t i = 0; i < masks.size(); ++i) {
            double before = 0;
            for (const rake::PinSpan& span : masks[i]) {
                EXPECT_GE(span.from, before - 1e-9);
                EXPECT_LT(span.from, span.to);
                EXPECT_NE(span.mask, 0u);
                EXPECT_LE(span.mask, rake::all_pins(7));
                before = span.to;
            }
            EXPECT_LE(before, length(fill.strokes[i].rake_path) + 1e-9);
        }
    }
}

TEST(FillRaked, TurnedAndMirroredFillsHaveTheSameAccount) {
    const Options options = areas::with(Style::zigzag);
    for (const Region& region : areas::all()) {
        const Fill fill = fill_region(region, 0, "area", options);
        const std::vector<rake::Move> moves = rake::moves_of(fill.strokes, fill.ways, {}, 7, 0.002);
        const rake::Account here = rake::account_of({region}, moves, {.width = 0.4});
        for (const Affine& map : {shapes::turned, shapes::mirrored}) {
            std::vector<rake::Move> there = moves;
            for (rake::Move& move : there)
                for (Point& p : move.line) p = apply(map, p);
            const rake::Account other = rake::account_of(shapes::moved({region}, map), there, {.width = 0.4});
            EXPECT_NEAR(other.coverage, here.coverage, 0.003);
            EXPECT_NEAR(other.overdraw, here.overdraw, 0.005);
            EXPECT_EQ(other.hops, here.hops);
        }
    }
}

TEST(FillRaked, AgreesWithBooleansOnTheSweptSand) {
    const Options options = areas::with(Style::rings);
    for (const Region& region : areas::all()) {
        const Fill fill = fill_region(region, 0, "area", options);
        const auto judged = areas::judged(region, fill, 0.4);
        const rake::Account account = account_of(region, fill.strokes, fill.ways, options);
        EXPECT_NEAR(account.coverage, judged.coverage, 0.003);
        EXPECT_NEAR(account.spill, judged.spill, 0.001);
    }
}

}  // namespace
}  // namespace strandline::fill
