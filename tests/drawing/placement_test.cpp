// Where on the canvas the drawing comes to lie, and how large.
#include <gtest/gtest.h>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

void expect_box(Box box, Point low, Point high, double tolerance = 1e-9) {
    EXPECT_NEAR(box.low.x, low.x, tolerance);
    EXPECT_NEAR(box.low.y, low.y, tolerance);
    EXPECT_NEAR(box.high.x, high.x, tolerance);
    EXPECT_NEAR(box.high.y, high.y, tolerance);
}
const std::vector<svg::Shape> an_l{stroked(line({{10, 20}, {10, 60}, {30, 60}}), 0.3)};  // 20 wide, 40 high

TEST(Placement, FitKeepsProportionsAndMarginAndCentres) {
    const Drawing d = drawn(an_l, {});
    expect_box(bounds(d), {3.75, 0.5}, {10.25, 13.5});
    EXPECT_NEAR(d.scale, 13.0 / 40, 1e-12);
    ASSERT_TRUE(d.scale_denominator);
    EXPECT_NEAR(*d.scale_denominator, 0.001 / (13.0 / 40), 1e-12);
    EXPECT_TRUE(d.warnings.empty());
}

TEST(Placement, UpOnThePageIsUpOnTheGround) {
    const Path path = line_of(drawn(an_l, {}), 0).path;  // an L starts at its top left
    EXPECT_NEAR(path.start.x, 3.75, 1e-9);
    EXPECT_NEAR(path.start.y, 13.5, 1e-9);
    EXPECT_NEAR(end_of(path).x, 10.25, 1e-9);
    EXPECT_NEAR(end_of(path).y, 0.5, 1e-9);
}

TEST(Placement, ALineWithoutWidthOrHeightFitsByTheOther) {
    expect_box(bounds(drawn({stroked(line({{5, 0}, {5, 10}}))}, {})), {7, 0.5}, {7, 13.5});
    expect_box(bounds(drawn({stroked(line({{0, 5}, {10, 5}}))}, {})), {0.5, 7}, {13.5, 7});
}

TEST(Placement, ActualIsTheFilesOwnSize) {
    DrawingOptions options;
    options.place = Place::actual;
    const Drawing d = drawn(an_l, options);
    EXPECT_NEAR(d.scale, 0.001, 1e-15);
    EXPECT_NEAR(*d.scale_denominator, 1, 1e-12);
    expect_box(bounds(d), {6.99, 6.98}, {7.01, 7.02});
}

TEST(Placement, WithoutAPhysicalSizeActualTakes96DpiAndSaysSo) {
    DrawingOptions options;
    options.place = Place::actual;
    svg::Document document_without = document(an_l);
    document_without.size_metres.reset();
    const auto d = make_drawing(document_without, beachbot(), options);
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->scale, 0.0254 / 96, 1e-15);
    EXPECT_FALSE(d->scale_denominator);
    ASSERT_EQ(d->warnings.size(), 1u);
    EXPECT_NE(d->warnings[0].reason.find("96 dpi"), std::string::npos);
}

TEST(Placement, WidthIsTheDrawingsWidthOnTheGround) {
    DrawingOptions options;
    options.place = Place::width;
    options.place_width = 3;
    expect_box(bounds(drawn(an_l, options)), {5.5, 4}, {8.5, 10});
    const auto upright = make_drawing(document({stroked(line({{5, 0}, {5, 10}}))}), beachbot(), options);
    ASSERT_FALSE(upright);
    EXPECT_EQ(upright.error().place, "place.width");
}

TEST(Placement, ScaleIsAgainstThePhysicalSize) {
    DrawingOptions options;
    options.place = Place::scale;
    options.scale_denominator = 0.01;
    const Drawing d = drawn(an_l, options);
    EXPECT_NEAR(d.scale, 0.1, 1e-12);
    EXPECT_NEAR(*d.scale_denominator, 0.01, 1e-12);
}

TEST(Placement, RotatesCounterClockwiseAfterMirroring) {
    DrawingOptions options = metre_a_unit();
    options.position = Point{0, 0};
    options.rotate = pi / 2;
    // The L's foot points right; turned by a quarter it points up, and the stem lies below it.
    Path path = line_of(drawn(an_l, options), 0).path;
    expect_box(bounds(path), {0, 0}, {40, 20});
    EXPECT_NEAR(path.start.x, 0, 1e-9);
    EXPECT_NEAR(path.start.y, 0, 1e-9);
    EXPECT_NEAR(end_of(path).x, 40, 1e-9);
    EXPECT_NEAR(end_of(path).y, 20, 1e-9);
    options.mirror = true;
    path = line_of(drawn(an_l, options), 0).path;
    EXPECT_NEAR(path.start.x, 0, 1e-9);
    EXPECT_NEAR(path.start.y, 20, 1e-9);
    EXPECT_NEAR(end_of(path).y, 0, 1e-9);
}

TEST(Placement, PositionIsTheLowerLeftCorner) {
    DrawingOptions options;
    options.place = Place::width;
    options.place_width = 2;
    options.position = Point{1, 3};
    const Drawing d = drawn(an_l, options);
    expect_box(bounds(d), {1, 3}, {3, 7});
    EXPECT_TRUE(d.warnings.empty());
}

TEST(Placement, ADrawingThatLeavesTheCanvasIsAWarningWithFigures) {
    DrawingOptions options;
    options.place = Place::width;
    options.place_width = 20;  // a stroke of 0.3 m
    const Drawing d = drawn(an_l, options);
    ASSERT_EQ(d.warnings.size(), 1u);
    EXPECT_NE(d.warnings[0].reason.find("20.000 x 40.000 m"), std::string::npos);
    EXPECT_NE(d.warnings[0].reason.find("14 x 14 m"), std::string::npos);
}

TEST(Placement, GrownRegionsStayInsideTheMarginToo) {
    // Stroke and fill; and a stroke wider than the rake.
    expect_box(bounds(drawn({shape({square({0, 0}, 100)}, black, black, 10)}, {})), {0.5, 0.5}, {13.5, 13.5},
               1e-6);
    expect_box(bounds(drawn({stroked(square({0, 0}, 100), 10)}, {})), {0.5, 0.5}, {13.5, 13.5}, 1e-6);
}

TEST(Placement, WhatIsNotDrawnDoesNotCount) {
    const Drawing d = drawn({shape({square({-500, -500}, 2000)}, white, {}), an_l[0],
                             shape({line({{900, 900}, {901, 900}})}, {}, start_green),
                             stroked(line({{700, 700}, {700, 700}})), filled({line({{0, 0}, {3000, 3000}})})},
                            {});
    expect_box(bounds(d), {3.75, 0.5}, {10.25, 13.5});
}

TEST(Placement, WrongOptionsAreRefusedByName) {
    const auto place = [](DrawingOptions options) {
        const auto drawing = make_drawing(document(an_l), beachbot(), options);
        return drawing ? std::string("drawn") : drawing.error().place;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(place({.canvas = {0, 14}}), "canvas");
    EXPECT_EQ(place({.canvas = {nan, 14}}), "canvas");
    EXPECT_EQ(place({.margin = 7}), "canvas.margin");
    EXPECT_EQ(place({.margin = -1}), "canvas.margin");
    EXPECT_EQ(place({.margin = 7, .place = Place::actual}), "drawn");  // the margin belongs to fit
    EXPECT_EQ(place({.place = Place::width, .place_width = 0}), "place.width");
    EXPECT_EQ(place({.place = Place::scale, .scale_denominator = nan}), "place.scale");
    EXPECT_EQ(place({.rotate = nan}), "drawing.rotate");
    EXPECT_EQ(place({.tolerance = 0}), "drawing.tolerance");
    EXPECT_EQ(place({.position = Point{nan, 0}}), "drawing.position");
}

TEST(Placement, CoordinatesBeyondReasonAreAnErrorNotACrash) {
    EXPECT_FALSE(make_drawing(document({stroked(line({{0, 0}, {1e-310, 0}}))}), beachbot(), {}));
    EXPECT_FALSE(make_drawing(document({stroked(line({{-1e308, 0}, {1e308, 0}}))}), beachbot(), {}));
}

TEST(Canvas, SizesByName) {
    EXPECT_EQ(canvas_named("A4"), (Canvas{0.210, 0.297}));
    EXPECT_EQ(canvas_named("a3-landscape"), (Canvas{0.420, 0.297}));
    EXPECT_EQ(canvas_named("A0"), (Canvas{0.841, 1.189}));
    EXPECT_EQ(canvas_named("letter"), (Canvas{0.2159, 0.2794}));
    EXPECT_EQ(canvas_named("legal-portrait"), (Canvas{0.2159, 0.3556}));
    EXPECT_EQ(canvas_named("14x10"), (Canvas{14, 10}));
    EXPECT_EQ(canvas_named("210x297mm"), canvas_named("A4"));
    EXPECT_EQ(canvas_named("2m x 50cm"), (Canvas{2, 0.5}));
    EXPECT_EQ(canvas_named("10x14-landscape"), (Canvas{14, 10}));
}

TEST(Canvas, WrongSizesAreRefused) {
    for (const char* name :
         {"", "A7", "A4-sideways", "x", "14x", "x14", "0x14", "14x-3", "nanx3", "10x20yards"}) {
        const auto canvas = canvas_named(name);
        ASSERT_FALSE(canvas) << name;
        EXPECT_EQ(canvas.error().place, "canvas");
        EXPECT_FALSE(canvas.error().remedy.empty()) << name;
    }
}

TEST(Canvas, DefaultsShrinkToASheetAndNeverGrow) {
    const DrawingOptions sheet = options_for({0.210, 0.297}), beach = options_for({14, 14}),
                         field = options_for({90, 60}), plain;
    EXPECT_NEAR(sheet.margin, 0.0075, 1e-12);
    EXPECT_NEAR(sheet.min_length, 0.00015, 1e-12);
    EXPECT_EQ(beach.margin, plain.margin);
    EXPECT_EQ(field.join_tolerance, plain.join_tolerance);
    EXPECT_EQ(field.canvas, (Canvas{90, 60}));
    EXPECT_TRUE(make_drawing(document(an_l), beachbot(), sheet));
}

}  // namespace
}  // namespace strandline
