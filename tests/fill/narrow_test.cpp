#include <gtest/gtest.h>

#include "fill/areas.hpp"
#include "path/fill/corners.hpp"
#include "path/fill/passes.hpp"

namespace strandline::fill {
namespace {

using areas::with;

/// Wide body, 4 by 4; from its right side an arm of the given width sticks out by 5.
Region key(double arm) {
    const double low = 2 - arm / 2, high = 2 + arm / 2;
    return areas::of({{{0, 0}, {4, 0}, {4, low}, {9, low}, {9, high}, {4, high}, {4, 4}, {0, 4}}});
}
Region dumbbell() {
    return areas::of({{{0, 0},
                       {3, 0},
                       {3, 1.35},
                       {7, 1.35},
                       {7, 0},
                       {9, 0},
                       {9, 3},
                       {7, 3},
                       {7, 1.65},
                       {3, 1.65},
                       {3, 3},
                       {0, 3}}});
}
Region cross() {
    return areas::of({{{-0.15, -3},
                       {0.15, -3},
                       {0.15, -0.15},
                       {3, -0.15},
                       {3, 0.15},
                       {0.15, 0.15},
                       {0.15, 3},
                       {-0.15, 3},
                       {-0.15, 0.15},
                       {-3, 0.15},
                       {-3, -0.15},
                       {-0.15, -0.15}}});
}

TEST(FillNarrow, ALineMovedAsideIsMitredAtItsCorners) {
    const Polyline angle{{0, 0}, {2, 0}, {2, 2}};
    EXPECT_EQ(moved_aside(angle, 0), angle);
    const Polyline inside = moved_aside(angle, 0.1);
    EXPECT_LT(distance(inside[0], {0, 0.1}), 1e-12);
    EXPECT_LT(distance(inside[1], {1.9, 0.1}), 1e-12);
    EXPECT_LT(distance(inside[2], {1.9, 2}), 1e-12);
    const Polyline square = moved_aside({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}, 0.1);
    EXPECT_LT(distance(square.front(), {0.1, 0.1}), 1e-12);
    EXPECT_EQ(square.front(), square.back());
    // Back the way it came: at most twice as far from the corner.
    EXPECT_LE(distance(moved_aside({{0, 0}, {2, 0}, {0, 0.1}}, 0.1)[1], {2, 0}), 0.2 + 1e-12);
}

double length_of(const Stroke& stroke) { return length(stroke.rake_path); }

TEST(FillNarrow, AnArmOfAKeyGetsOnePassToItsEnd) {
    for (const Affine& map : {Affine{}, shapes::turned, shapes::mirrored}) {
        const Region region = shapes::moved({key(0.3)}, map)[0];
        const Fill fill = fill_region(region, 0, "key", with(Style::rings));
        const Polyline first = areas::line_of(fill.strokes.front());
        EXPECT_LT(distance(first.front(), apply(map, {9, 2})), 0.03);  // from the free end
        EXPECT_LT(distance(first.back(), apply(map, {4, 2})), 0.2);    // to the body
        for (Point p : first) EXPECT_TRUE(contains(region, p) || distance_to_outline(region.outer, p) < 1e-6);
        EXPECT_GT(areas::judged(region, fill, 0.4).coverage, 0.975);
    }
}

TEST(FillNarrow, WherePinsLiftAStripOfAnEvenNumberOfThemIsRakedHalfAPitchBesideItsMiddle) {
    const double pitch = 0.06;
    for (int fitting = 2; fitting <= 6; ++fitting)
        for (const int pins : {7, 8}) {
            const double half = fitting * pitch / 2;
            const Region strip = areas::of({{{0, -half}, {5, -half}, {5, half}, {0, half}}});
            const Options options{.width = pins * pitch, .spacing = pins * pitch, .pins = pins};
            Options masked = options;
            masked.masked = true;
            const double beside = (pins - fitting) % 2 == 0 ? 0 : pitch / 2;
            for (const auto& [of, off] : {std::pair{masked, beside}, std::pair{options, 0.0}}) {
                const Fill fill = fill_region(strip, 0, "strip", of);
                ASSERT_EQ(fill.strokes.size(), 1u);
                for (Point p : areas::line_of(fill.strokes.front()))
                    EXPECT_NEAR(std::abs(p.y), off, 0.005) << fitting << " of " << pins;
            }
        }
}

TEST(FillNarrow, AStripHardlyWiderThanTheRakeIsRakedAlongItsMiddle) {
    // A thick line with round caps: its ring still has room, the outline by fewer points none.
    Polyline outer;
    for (int k = 0; k <= 32; ++k)
        outer.push_back(Point{k <= 16 ? 1.5 : 0.0, 0} + 0.2005 * unit((k - 8) * pi / 16));
    outer.insert(outer.begin() + 17, Point{0, 0.2005});
    for (const Affine& map : {Affine{}, shapes::turned, shapes::mirrored}) {
        const Region strip = shapes::moved({areas::of({outer})}, map)[0];
        for (const Style style : {Style::rings, Style::spiral, Style::zigzag}) {
            const Fill fill = fill_region(strip, 0, "strip", with(style));
            EXPECT_GT(areas::judged(strip, fill, 0.4).coverage, 0.94);
        }
    }
}

TEST(FillNarrow, ACornerThatTurnsRightBackIsCutAtAPlace) {
    for (const bool pivots : {false, true}) {
        const Options options{.width = 0.4, .pivots = pivots, .tips = Tips::all, .masked = true};
        for (const double aside : {0.0, 1e-300, 1e-12, 1e-3})
            if (const auto corner = cut_corner({0, 0}, {2, 0}, {0, aside}, true, options)) {
                EXPECT_TRUE(std::isfinite(corner->onward) && corner->onward >= 0) << aside;
                EXPECT_TRUE(std::isfinite(corner->ahead) && corner->ahead >= 0) << aside;
            }
    }
}

TEST(FillNarrow, TheArmIsNamedByPlaceWithWhatItSpills) {
    const Fill fill = fill_region(key(0.3), 0, "key", with(Style::rings));
    ASSERT_EQ(fill.warnings.size(), 1u);
    EXPECT_EQ(fill.warnings[0].place, "key");
    for (const char* part :
         {"0.3 to", "m long", "(9.00, 2.00)", "one pass along its middle", "0.05 m outside"})
        EXPECT_NE(fill.warnings[0].reason.find(part), std::string::npos)
            << part << " in " << fill.warnings[0].reason;
}

TEST(FillNarrow, LeftBareItIsNamedAndNothingSpills) {
    Options options = with(Style::rings);
    options.narrow = Narrow::warn;
    for (const Region& region : {key(0.3), dumbbell(), key(0.12)}) {
        const Fill fill = fill_region(region, 0, "key", options);
        ASSERT_FALSE(fill.warnings.empty());
        EXPECT_NE(fill.warnings[0].reason.find("left bare"), std::string::npos);
        EXPECT_LT(areas::judged(region, fill, 0.4).spill, 1e-3);
    }
    const Region bar = areas::of({{{0, 0}, {5, 0}, {5, 0.3}, {0, 0.3}}});
    const Fill all = fill_region(bar, 0, "bar", options);
    EXPECT_TRUE(all.strokes.empty());
    EXPECT_EQ(all.warnings.size(), 1u);
}

TEST(FillNarrow, ABodyAtTheFarEndOfABridgeIsRakedFirstAndTheBridgeTowardsTheOther) {
    const Region region = dumbbell();
    const Fill fill = fill_region(region, 0, "dumbbell", with(Style::rings));
    int bridge = -1;
    for (std::size_t i = 0; i < fill.strokes.size(); ++i) {
        const auto& nodes = fill.strokes[i].nodes;
        const Point from = nodes.front().at, to = nodes.back().at;
        if (from.x > 6.7 && to.x < 3.3)
            bridge = static_cast<int>(i);
        else
            EXPECT_EQ(from.x > 5, bridge < 0) << i;  // right body before it, left body after it
    }
    EXPECT_GE(bridge, 1);
    EXPECT_LT(bridge + 1, static_cast<int>(fill.strokes.size()));
}

TEST(FillNarrow, ACrossOfNarrowArmsIsTwoThroughPassesCutWhereTheyMeet) {
    for (const Affine& map : {Affine{}, shapes::turned}) {
        const Region region = shapes::moved({cross()}, map)[0];
        const Fill fill = fill_region(region, 0, "cross", with(Style::rings));
        ASSERT_EQ(fill.strokes.size(), 3u);  // one through, two that end on it
        double longest = 0, sum = 0;
        for (const Stroke& stroke : fill.strokes) {
            longest = std::max(longest, length_of(stroke));
            sum += length_of(stroke);
        }
        EXPECT_NEAR(longest, 6, 0.05);
        EXPECT_LT(sum, 12);
        EXPECT_NEAR(length_of(fill.strokes.back()), longest, 1e-9);  // the through pass last
        EXPECT_GT(areas::judged(region, fill, 0.4).coverage, 0.99);
    }
}

TEST(FillNarrow, ANarrowRingIsOneClosedPass) {
    const Region ring = areas::of({shapes::square({0, 0}, 6), shapes::square({0.3, 0.3}, 5.4)});
    const Fill fill = fill_region(ring, 0, "ring", with(Style::rings));
    ASSERT_EQ(fill.strokes.size(), 1u);
    EXPECT_NEAR(length_of(fill.strokes[0]), 4 * 5.7, 0.3);
    EXPECT_GT(areas::judged(ring, fill, 0.4).coverage, 0.98);
}

TEST(FillNarrow, CornersAndWideAreasHaveNoArms) {
    for (Style style : {Style::rings, Style::zigzag})
        for (const Region& region : areas::all()) {
            Options options = with(style);
            const Fill single = fill_region(region, 0, "area", options);
            options.narrow = Narrow::warn;
            EXPECT_EQ(single.strokes, fill_region(region, 0, "area", options).strokes);
        }
    const Region triangle = areas::of({{{0, 0}, {8, 0}, {4, 4}}});
    EXPECT_EQ(fill_region(triangle, 0, "area", with(Style::rings)).warnings.size(), 0u);
}

TEST(FillNarrow, ArmsOnlyAddToWhatIsRaked) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        for (const Region& region : shapes::random_regions(seed)) {
            Options options = with(Style::rings);
            const double with_arms =
                areas::judged(region, fill_region(region, 0, "area", options), 0.4).coverage;
            options.narrow = Narrow::warn;
            const double without =
                areas::judged(region, fill_region(region, 0, "area", options), 0.4).coverage;
            EXPECT_GT(with_arms, without - 0.01) << seed;
        }
}

TEST(FillNarrow, ALongListIsCutShortAndCounted) {
    Polygon comb{{0, 0}};
    for (int k = 0; k < 9; ++k) {
        const double x = 10 - k;
        for (Point p : {Point{x, 3}, Point{x, 5}, Point{x - 0.3, 5}, Point{x - 0.3, 3}}) comb.push_back(p);
    }
    comb.insert(comb.begin() + 1, {10.0, 0});
    comb.push_back({0, 3});
    const Fill fill = fill_region(areas::of({comb}), 0, "comb", with(Style::rings));
    ASSERT_EQ(fill.warnings.size(), 6u);
    EXPECT_NE(fill.warnings.back().reason.find("4 more"), std::string::npos);
}

}  // namespace
}  // namespace strandline::fill
