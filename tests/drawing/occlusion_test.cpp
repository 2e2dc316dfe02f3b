// What is seen when shapes are painted over each other.
#include <gtest/gtest.h>

#include <random>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

using Ids = std::vector<std::string>;

double ink_area(const Drawing& drawing) {
    double sum = 0;
    for (const Element& element : drawing.elements)
        if (const auto* region = std::get_if<RegionElement>(&element.what)) sum += area(region->region);
    return sum;
}

TEST(Occlusion, ALaterWhiteFillErasesAnAreaAndAnEarlierOneDoesNot) {
    const Drawing erased = drawn({filled({square({0, 0}, 30)}), shape({square({10, 10}, 10)}, white, {})});
    ASSERT_EQ(erased.elements.size(), 1u);
    EXPECT_NEAR(ink_area(erased), 800, 1e-3);
    EXPECT_EQ(region_of(erased, 0).holes.size(), 1u);
    const Drawing kept = drawn({shape({square({10, 10}, 10)}, white, {}), filled({square({0, 0}, 30)})});
    EXPECT_NEAR(ink_area(kept), 900, 1e-3);
}

TEST(Occlusion, AreasThatOverlapBecomeOneOfTheEarliestName) {
    const Drawing d = drawn({filled({square({40, 0}, 10)}), filled({square({0, 0}, 20)}),
                             filled({square({10, 10}, 20)}), filled({square({60, 60}, 5)})});
    EXPECT_EQ(ids(d), (Ids{"a", "b", "d"}));
    EXPECT_NEAR(area(region_of(d, 1)), 400 + 400 - 100, 1e-3);
    EXPECT_EQ(d.counts.merged, 1);
}

TEST(Occlusion, ALineUnderAnAreaIsCutAndOneOverItIsNot) {
    const Path across = line({{0, 15}, {40, 15}});
    for (const auto& paint : {black, white}) {
        const Drawing under = drawn({stroked(across), shape({square({10, 10}, 10)}, paint, {})});
        std::vector<double> lengths;
        for (const Element& element : under.elements)
            if (!is_region(element)) lengths.push_back(length(element));
        ASSERT_EQ(lengths.size(), 2u);
        EXPECT_NEAR(lengths[0], 10, 0.02);
        EXPECT_NEAR(lengths[1], 20, 0.02);
        EXPECT_EQ(under.counts.cut, 1);
        const Drawing over = drawn({shape({square({10, 10}, 10)}, paint, {}), stroked(across)});
        EXPECT_NEAR(length(over.elements.back()), 40, 1e-9);
    }
}

TEST(Occlusion, AWhollyCoveredShapeIsCountedHidden) {
    const Drawing d = drawn({stroked(line({{12, 12}, {18, 18}})), filled({square({12, 12}, 4)}),
                             shape({square({10, 10}, 10)}, white, black)});
    EXPECT_EQ(ids(d), Ids{"c"});
    EXPECT_FALSE(is_region(d.elements[0]));
    EXPECT_EQ(d.counts.hidden, 2);
}

TEST(Occlusion, ALineAlongAnOutlineStaysWhole) {
    const Drawing d =
        drawn({shape({circle({20, 20}, 10)}, {}, black), shape({circle({20, 20}, 10)}, white, {})});
    ASSERT_EQ(d.elements.size(), 1u);
    EXPECT_NEAR(length(d.elements[0]), 2 * pi * 10, 1e-6);
    EXPECT_TRUE(std::get<LineElement>(d.elements[0].what).path.closed);
}

TEST(Occlusion, AWhiteStrokeCutsAGapOfItsWidth) {
    svg::Shape eraser = shape({line({{15, -5}, {15, 45}})}, {}, white);
    eraser.stroke_width = 2;
    const Drawing d = drawn({filled({square({0, 0}, 30)}), eraser});
    EXPECT_EQ(ids(d), (Ids{"a", "a/2"}));
    EXPECT_NEAR(ink_area(d), 900 - 60, 1e-2);
}

TEST(Occlusion, AThinAreaBesideAWhiteOneStays) {
    const Path sliver = path_through({{0, 0}, {40, 40}, {40.001, 40}, {0.001, 0}}, true);
    EXPECT_EQ(drawn({filled({sliver}), shape({square({30, 0}, 8)}, white, {})}).elements.size(), 1u);
}

TEST(Occlusion, APauseKeepsWhatIsBeforeItFromWhatIsAfterIt) {
    svg::Shape stop = stroked(line({{0, 40}, {10, 40}}));
    stop.hints = {{"pause", "coffee"}};
    const Drawing areas = drawn({filled({square({0, 0}, 20)}), stop, filled({square({10, 0}, 20)})});
    ASSERT_EQ(areas.elements.size(), 3u);
    EXPECT_NEAR(ink_area(areas), 600, 1e-3);
    EXPECT_LT(areas.elements[0].section, areas.elements[1].section);
    EXPECT_LT(areas.elements[1].section, areas.elements[2].section);
    const Drawing lines = drawn({stroked(line({{0, 0}, {10, 0}})), stop, stroked(line({{10, 0}, {20, 0}}))});
    EXPECT_EQ(lines.elements.size(), 3u) << "lines that meet are not joined across the stop";
}

TEST(Occlusion, WhatIsCutDoesNotRenameItsSiblings) {
    const svg::Shape two = shape({line({{0, 10}, {90, 10}}), line({{0, 30}, {90, 30}})}, {}, black);
    const Drawing d = drawn({two, shape({square({20, 5}, 10)}, white, {})});
    EXPECT_EQ(ids(d), (Ids{"a", "a/3", "a/2"}));
    EXPECT_NEAR(length(d.elements[2]), 90, 1e-9);
}

TEST(Occlusion, PaintThatLetsInkShowThroughHidesNothing) {
    const svg::Paint veil{{255, 255, 255}, 0.5};
    EXPECT_NEAR(ink_area(drawn({filled({square({0, 0}, 30)}), shape({square({10, 10}, 10)}, veil, {})})), 900,
                1e-3);
}

TEST(Occlusion, OffDrawsEveryElement) {
    DrawingOptions options = metre_a_unit();
    options.occlusion = false;
    const Drawing d = drawn({filled({square({0, 0}, 20)}), filled({square({10, 10}, 20)}),
                             shape({square({0, 0}, 60)}, white, {})},
                            options);
    EXPECT_EQ(d.elements.size(), 2u);
    EXPECT_NEAR(ink_area(d), 800, 1e-3);
}

TEST(Occlusion, InvertedInkIsWhatIsBright) {
    DrawingOptions options = metre_a_unit();
    options.invert = true;
    const Drawing d =
        drawn({shape({square({0, 0}, 40)}, white, {}), filled({square({10, 10}, 10)})}, options);
    EXPECT_EQ(ids(d), Ids{"a"});
    EXPECT_NEAR(ink_area(d), 1600 - 100, 1e-3);
}

/// Ink at a point: that of the last shape over it.
bool inked_at(const std::vector<svg::Shape>& shapes, Point p) {
    bool ink = false;
    for (const svg::Shape& shape : shapes) {
        const Point low = shape.subpaths[0].start;
        const double side = length(shape.subpaths[0]) / 4;
        if (contains(Box{low, low + Point{side, side}}, p)) ink = shape.fill == black;
    }
    return ink;
}

TEST(Occlusion, RandomSquaresShowWhatThePainterLeaves) {
    std::mt19937_64 random(5);
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int round = 0; round < 40; ++round) {
        std::vector<svg::Shape> shapes;
        for (int k = 0; k < 25; ++k) {
            const Point low{80 * share(), 80 * share()};
            shapes.push_back(shape({square(low, 5 + 25 * share())}, share() < 0.6 ? black : white, {}));
        }
        shapes.push_back(filled({square({200, 200}, 1)}));  // something is always left
        const Drawing d = drawn(shapes);
        Regions all;
        for (const Element& element : d.elements) all.push_back(std::get<RegionElement>(element.what).region);
        EXPECT_NEAR(area(united(all, {})), area(all), 1e-3) << "nothing is raked twice";
        for (int k = 0; k < 400; ++k) {
            const Point user{110 * share(), 110 * share()}, p = apply(d.to_canvas, user);
            bool on_edge = false;
            for (const svg::Shape& s : shapes)
                on_edge |= distance_to(flattened(s.subpaths[0], 0.001), user) < 0.02;
            if (on_edge) continue;
            EXPECT_EQ(contains(all, p), inked_at(shapes, user)) << "drawing " << round;
        }
    }
}

TEST(Occlusion, TurnedAndMirroredTheSameIsSeen) {
    std::mt19937_64 random(6);
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int round = 0; round < 20; ++round) {
        std::vector<svg::Shape> shapes;
        for (int k = 0; k < 12; ++k) {
            const Point at{80 * share(), 80 * share()};
            if (k % 3 == 0)
                shapes.push_back(stroked(line({at, {80 * share(), 80 * share()}})));
            else
                shapes.push_back(shape({circle(at, 5 + 15 * share())}, k % 3 == 1 ? black : white, {}));
        }
        DrawingOptions options = metre_a_unit();
        const Drawing plain = drawn(shapes, options);
        options.rotate = 2 * pi * share();
        options.mirror = round % 2 == 0;
        const Drawing turned = drawn(shapes, options);
        const auto line_length = [](const Drawing& drawing) {
            double sum = 0;
            for (const Element& element : drawing.elements) sum += is_region(element) ? 0 : length(element);
            return sum;
        };
        EXPECT_NEAR(ink_area(plain), ink_area(turned), 1e-3 * (1 + ink_area(plain)));
        EXPECT_NEAR(line_length(plain), line_length(turned), 0.3) << "drawing " << round;
    }
}

}  // namespace
}  // namespace strandline
