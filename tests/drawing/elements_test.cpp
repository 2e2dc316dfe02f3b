// What becomes an element, and of which kind.
#include <gtest/gtest.h>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

using Ids = std::vector<std::string>;

TEST(Drawing, AStrokeBecomesALineAndAFillARegion) {
    const Drawing d = drawn({stroked(line({{10, 10}, {30, 10}})), filled({square({50, 50}, 20)})});
    ASSERT_EQ(d.elements.size(), 2u);
    EXPECT_FALSE(is_region(d.elements[0]));
    EXPECT_TRUE(is_region(d.elements[1]));
    EXPECT_NEAR(length(d.elements[0]), 20, 1e-9);
    EXPECT_NEAR(area(region_of(d, 1)), 400, 1e-4);
    EXPECT_NEAR(length(d.elements[1]), 80, 1e-4);
    EXPECT_EQ(d.counts.shapes, 2);
}

TEST(Drawing, WhiteAndTransparentPaintIsBareSandAndCounted) {
    const svg::Paint clear{{0, 0, 0}, 0}, pale{{0, 0, 0}, 0.02};
    const Drawing d =
        drawn({shape({square({0, 0}, 10)}, white, black), shape({square({20, 0}, 10)}, clear, black),
               shape({square({40, 0}, 10)}, black, white), shape({square({60, 0}, 10)}, pale, {}),
               shape({square({80, 0}, 10)}, {}, {})});
    EXPECT_EQ(ids(d), (Ids{"a", "b", "c"}));
    EXPECT_FALSE(is_region(d.elements[0]));
    EXPECT_TRUE(is_region(d.elements[2]));
    EXPECT_EQ(d.counts.bare, 5);
}

TEST(Drawing, TheInkThresholdIsRelativeLuminance) {
    // Yellow has a relative luminance of 0.93, cyan of 0.79.
    const svg::Paint yellow{{255, 255, 0}, 1}, cyan{{0, 255, 255}, 1};
    EXPECT_EQ(ids(drawn({shape({square({0, 0}, 10)}, yellow, {}), shape({square({20, 0}, 10)}, cyan, {})})),
              Ids{"b"});
    DrawingOptions options = metre_a_unit();
    options.ink_threshold = 0.95;
    EXPECT_EQ(
        drawn({shape({square({0, 0}, 10)}, yellow, {}), shape({square({20, 0}, 10)}, cyan, {})}, options)
            .elements.size(),
        2u);
}

TEST(Drawing, GreenStrokeMarksTheStartAndIsNotDrawn) {
    const Drawing d =
        drawn({stroked(line({{0, 0}, {40, 40}})), shape({line({{10, 30}, {20, 30}})}, black, start_green),
               shape({line({{1, 1}, {2, 2}})}, {}, start_green)});
    EXPECT_EQ(d.elements.size(), 1u);
    ASSERT_TRUE(d.start);
    EXPECT_NEAR(distance(*d.start, apply(d.to_canvas, {10, 30})), 0, 1e-12);
    ASSERT_EQ(d.warnings.size(), 1u);
    EXPECT_EQ(d.warnings[0].place, "<path> #c");
}

TEST(Drawing, TheFillRuleMakesTheHole) {
    const std::vector<Path> same_sense{square({0, 0}, 30), square({10, 10}, 10)};
    EXPECT_NEAR(area(region_of(drawn({filled(same_sense, svg::FillRule::even_odd)}), 0)), 800, 1e-4);
    EXPECT_NEAR(area(region_of(drawn({filled(same_sense, svg::FillRule::nonzero)}), 0)), 900, 1e-4);
    const std::vector<Path> other_sense{square({0, 0}, 30), reversed(square({10, 10}, 10))};
    EXPECT_NEAR(area(region_of(drawn({filled(other_sense, svg::FillRule::nonzero)}), 0)), 800, 1e-4);
}

TEST(Drawing, OpenSubpathsAreFilledAsIfClosed) {
    const Drawing d = drawn({filled({line({{0, 0}, {10, 0}, {10, 10}})})});
    EXPECT_NEAR(area(region_of(d, 0)), 50, 1e-5);
}

TEST(Drawing, FillsKeepToTheFlatteningTolerance) {
    DrawingOptions options = metre_a_unit();
    options.tolerance = 0.01;
    const Drawing d = drawn({filled({circle({50, 50}, 20)})}, options);
    EXPECT_NEAR(area(region_of(d, 0)), pi * 400, 0.01 * 2 * pi * 20);
    for (const Point p : region_of(d, 0).outer) EXPECT_NEAR(distance(p, {50, 50}), 20, 1e-5);
}

TEST(Drawing, PiecesOfAShapeAreNumberedAndSubpathsAreLines) {
    EXPECT_EQ(ids(drawn({filled({square({0, 0}, 10), square({20, 0}, 10), square({40, 0}, 10)})})),
              (Ids{"a", "a/2", "a/3"}));
    EXPECT_EQ(ids(drawn({shape({line({{0, 0}, {5, 0}}), line({{0, 9}, {5, 9}})}, {}, black)})),
              (Ids{"a", "a/2"}));
}

TEST(Drawing, AnIdThatTheFileUsesTwiceIsMadeUnique) {
    svg::Shape one = stroked(line({{0, 0}, {9, 0}})), two = stroked(line({{0, 9}, {9, 9}})),
               three = stroked(line({{0, 20}, {9, 20}}));
    one.id = two.id = "twin";
    three.id = "twin/2";
    EXPECT_EQ(ids(drawn({one, two, three})), (Ids{"twin", "twin/2", "twin/2/2"}));
}

TEST(Drawing, PinsFollowTheStrokeWidthInUserUnits) {
    const auto pins = [](double width, DrawingOptions options) {
        return line_of(drawn({stroked(line({{0, 0}, {90, 90}}), width)}, options), 0).pins;
    };
    for (const double place_width : {1.0, 7.0}) {
        DrawingOptions options;
        options.place = Place::width;
        options.place_width = place_width;
        EXPECT_EQ(pins(1, options), 1);
        EXPECT_EQ(pins(3, options), 3);
        EXPECT_EQ(pins(3.5, options), 5);
    }
}

TEST(Drawing, RakeSizesOfTheFileReplaceTheRobotsRules) {
    svg::Document d =
        document({stroked(line({{0, 0}, {90, 0}}), 10), stroked(line({{0, 20}, {90, 20}}), 20),
                  stroked(line({{0, 40}, {90, 40}}), 30), stroked(line({{0, 60}, {90, 60}}), 99),
                  stroked(line({{0, 80}, {90, 80}}), 5)});
    d.rake_sizes = {5, 10, 20, 30, 40};
    Robot robot = beachbot();
    robot.fill_wide_strokes = false;
    const auto pins = [&] {
        std::vector<int> all;
        const auto drawing = make_drawing(d, robot, {});
        for (std::size_t i = 0; i < drawing->elements.size(); ++i) all.push_back(line_of(*drawing, i).pins);
        EXPECT_EQ(drawing->warnings.size(), 1u);  // the stroke of width 5: no pin
        EXPECT_EQ(drawing->counts.bare, 1);
        return all;
    };
    EXPECT_EQ(pins(), (std::vector{1, 3, 5, 7}));
    robot.pins = 1;
    EXPECT_EQ(pins(), (std::vector{1, 1, 1, 1}));
    robot.pins = 14;
    EXPECT_EQ(pins(), (std::vector{2, 6, 10, 14}));
}

TEST(Drawing, FillAndStrokeOfOneShapeAreOneRegionGrownByHalfTheStroke) {
    const Drawing d = drawn({shape({square({20, 20}, 40)}, black, black, 2)});
    ASSERT_EQ(d.elements.size(), 1u);
    EXPECT_NEAR(area(region_of(d, 0)), 40 * 40 + 4 * 40 + pi, 0.01);
    EXPECT_EQ(d.counts.merged, 1);
    // Sand knows no colours: the stroke's inner half lies on the fill, whatever its ink.
    EXPECT_NEAR(area(region_of(drawn({shape({square({20, 20}, 40)}, black, red, 2)}), 0)),
                40 * 40 + 4 * 40 + pi, 0.01);
}

TEST(Drawing, TheStrokesInnerHalfClosesAHoleThatIsNarrowerThanIt) {
    const Drawing d = drawn({shape({square({20, 20}, 40), reversed(square({39, 39}, 2))}, black, black, 3)});
    EXPECT_TRUE(region_of(d, 0).holes.empty());
}

TEST(Drawing, AnOpenSubpathsClosingLineIsFilledToButNotStroked) {
    // Three sides of the square are stroked, with flat ends; the corners between them are round.
    const Drawing d = drawn({shape({line({{20, 20}, {60, 20}, {60, 60}, {20, 60}})}, black, black, 2)});
    EXPECT_NEAR(area(region_of(d, 0)), 40 * 40 + 3 * 40 + pi / 2, 0.01);
}

TEST(Drawing, AWhiskerOfAFillIsStroked) {
    const Path whisker = path_through({{20, 20}, {60, 20}, {90, 20}, {60, 20}, {60, 60}, {20, 60}}, true);
    EXPECT_NEAR(bounds(drawn({shape({whisker}, black, black, 2)})).width(), 72, 0.01);
}

TEST(Drawing, AHairlineOnAFillAddsNothing) {
    const Drawing d = drawn({shape({square({20, 20}, 40)}, black, black, 0.05)});
    ASSERT_EQ(d.elements.size(), 1u);
    EXPECT_NEAR(area(region_of(d, 0)), 1600, 1e-3);
    EXPECT_EQ(d.counts.merged, 1);
}

TEST(Drawing, AFillWithoutAreaLeavesItsStrokeALine) {
    const Drawing d = drawn({shape({line({{10, 10}, {30, 30}, {20, 20}})}, black, black)});
    ASSERT_EQ(d.elements.size(), 1u);
    EXPECT_FALSE(is_region(d.elements[0]));
    EXPECT_EQ(d.counts.bare, 0);
}

TEST(Drawing, AStrokeWiderThanTheRakeBecomesARegionWhereTheRobotSaysSo) {
    const auto wide = stroked(line({{20, 20}, {60, 20}}), 0.5);
    const Drawing d = drawn({wide});
    ASSERT_TRUE(is_region(d.elements.at(0)));
    EXPECT_NEAR(area(region_of(d, 0)), 40 * 0.5, 1e-3);
    EXPECT_EQ(d.counts.wide_strokes, 1);
    EXPECT_FALSE(is_region(drawn({stroked(line({{20, 20}, {60, 20}}), 0.41)}).elements.at(0)));
    Robot plotter = beachbot();
    plotter.fill_wide_strokes = false;
    EXPECT_FALSE(is_region(drawn({wide}, metre_a_unit(), plotter).elements.at(0)));
}

TEST(Drawing, WideStrokesKeepTheirCaps) {
    svg::Shape wide = stroked(line({{20, 20}, {60, 20}}), 2);
    wide.cap = svg::LineCap::square;
    EXPECT_NEAR(area(region_of(drawn({wide}), 0)), 42 * 2, 1e-3);
    wide.cap = svg::LineCap::round;
    EXPECT_NEAR(area(region_of(drawn({wide}), 0)), 40 * 2 + pi, 0.02);
}

TEST(Drawing, AWideClosedStrokeIsARing) {
    const Drawing d = drawn({stroked(circle({50, 50}, 20), 2)});
    ASSERT_EQ(region_of(d, 0).holes.size(), 1u);
    EXPECT_NEAR(area(region_of(d, 0)), pi * (21 * 21 - 19 * 19), 0.3);
}

TEST(Drawing, RegionsBelowTheLeastAreaAreDroppedAndCounted) {
    DrawingOptions options = metre_a_unit();
    options.min_area = 5;
    const Drawing d = drawn({filled({square({0, 0}, 2)}), filled({square({20, 20}, 3)})}, options);
    EXPECT_EQ(ids(d), Ids{"b"});
    EXPECT_EQ(d.counts.too_small, 1);
}

TEST(Drawing, LinesBelowTheLeastLengthAreDroppedAndCounted) {
    const Drawing d = drawn({stroked(line({{0, 0}, {20, 0}})), stroked(line({{5, 5}, {5, 5}})),
                             stroked(line({{9, 9}, {9, 9.009}}))});
    EXPECT_EQ(ids(d), Ids{"a"});
    EXPECT_EQ(d.counts.too_short, 2);
}

TEST(Drawing, LayersAreKept) {
    svg::Shape one = stroked(line({{0, 0}, {20, 0}}));
    one.layer = "Sky/Clouds";
    EXPECT_EQ(drawn({one}).elements[0].layer, "Sky/Clouds");
}

TEST(Drawing, NothingToDrawSaysWhy) {
    const auto error = [](std::vector<svg::Shape> shapes) {
        const auto drawing = make_drawing(document(std::move(shapes)), beachbot(), metre_a_unit());
        return drawing ? std::string("drawn") : sentence(drawing.error());
    };
    EXPECT_NE(error({}).find("no shapes"), std::string::npos);
    EXPECT_NE(error({shape({square({0, 0}, 9)}, white, {})}).find("of 1 shapes 1 paints are bare sand"),
              std::string::npos);
    EXPECT_NE(error({stroked(line({{0, 0}, {0.001, 0}}))}).find("1 lines too short"), std::string::npos);
    EXPECT_NE(error({stroked(line({{3, 3}, {3, 3}}))}).find("single points"), std::string::npos);
}

TEST(Drawing, AWideStrokeIsCutAtItsSidesToo) {
    svg::Shape wide = stroked(line({{20, 50}, {60, 50}}));
    wide.stroke_width = 10;
    const Polygon lower{{0, 50}, {100, 50}, {100, 100}, {0, 100}};
    wide.stroke_clip = std::make_shared<const Regions>(Regions{{lower, {}}});
    const Drawing d = drawn({wide});
    ASSERT_EQ(d.elements.size(), 1u);
    EXPECT_NEAR(area(region_of(d, 0)), 200, 1e-3);
}

TEST(Drawing, AStrokeFollowsItsOwnLinesWhereItHasThem) {
    svg::Shape dashed = stroked(square({0, 0}, 40));
    dashed.lines = std::vector<Path>{line({{0, 0}, {10, 0}}), line({{20, 0}, {30, 0}})};
    const Drawing d = drawn({dashed});
    ASSERT_EQ(d.elements.size(), 2u);
    EXPECT_NEAR(length(d.elements[0]) + length(d.elements[1]), 20, 1e-9);
}

}  // namespace
}  // namespace strandline
