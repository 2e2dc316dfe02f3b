#include <gtest/gtest.h>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

Box box_of(const Shape& shape) {
    Box box;
    for (const auto& path : shape.subpaths) box = united(box, bounds(path));
    return box;
}
void expect_box(const std::string& elements, Point low, Point high, double tolerance = 1e-9) {
    const auto box = box_of(first_shape(elements));
    EXPECT_NEAR(box.low.x, low.x, tolerance) << elements;
    EXPECT_NEAR(box.low.y, low.y, tolerance) << elements;
    EXPECT_NEAR(box.high.x, high.x, tolerance) << elements;
    EXPECT_NEAR(box.high.y, high.y, tolerance) << elements;
}
/// Where (x, y) comes to under a transform list.
Point mapped(const std::string& transform, Point p) {
    const auto shape =
        first_shape("<line stroke='red' transform='" + transform + "' x1='" + std::to_string(p.x) + "' y1='" +
                    std::to_string(p.y) + "' x2='7' y2='7'/>");
    return shape.subpaths.empty() ? Point{} : shape.subpaths[0].start;
}

TEST(Shapes, ARectangleIsFourLines) {
    const auto shape = first_shape("<rect x='1' y='2' width='3' height='4'/>");
    EXPECT_EQ(shape.subpaths[0], path_through({{1, 2}, {4, 2}, {4, 6}, {1, 6}}, true));
}

TEST(Shapes, ARoundedRectangleHasQuarterArcsAndKeepsItsBox) {
    const auto shape = first_shape("<rect x='1' y='2' width='30' height='20' rx='4' ry='3'/>");
    ASSERT_EQ(shape.subpaths[0].segments.size(), 8u);
    EXPECT_EQ(std::get<ArcSegment>(shape.subpaths[0].segments[1]).center, (Point{27, 5}));
    EXPECT_EQ(end_of(shape.subpaths[0]), shape.subpaths[0].start);
    expect_box("<rect x='1' y='2' width='30' height='20' rx='4' ry='3'/>", {1, 2}, {31, 22});
}

TEST(Shapes, OneRadiusStandsForBothAndHalfTheSideIsTheMost) {
    EXPECT_EQ(first_shape("<rect width='30' height='20' rx='4'/>").subpaths,
              first_shape("<rect width='30' height='20' rx='4' ry='4'/>").subpaths);
    EXPECT_EQ(first_shape("<rect width='30' height='20' ry='99'/>").subpaths,
              first_shape("<rect width='30' height='20' rx='15' ry='10'/>").subpaths);
    EXPECT_EQ(first_shape("<rect width='30' height='20' rx='99' ry='99'/>").subpaths[0].segments.size(), 4u);
}

TEST(Shapes, CirclesAndEllipsesAreFourExactQuarters) {
    const auto circle = first_shape("<circle cx='5' cy='6' r='2'/>").subpaths[0];
    ASSERT_EQ(circle.segments.size(), 4u);
    EXPECT_EQ(circle.start, (Point{7, 6}));
    EXPECT_NEAR(length(circle), 4 * pi, 1e-8);
    expect_box("<ellipse cx='5' cy='6' rx='2' ry='3'/>", {3, 3}, {7, 9});
    expect_box("<ellipse cx='5' cy='6' rx='2'/>", {3, 4}, {7, 8});
}

TEST(Shapes, EachArcOfAShapeStartsWhereTheLastSegmentEnded) {
    for (const char* element :
         {"<circle cx='5' cy='6' r='2'/>", "<rect x='1' width='9' height='7' rx='4.5' ry='2'/>"}) {
        const auto path = first_shape(element).subpaths[0];
        Point last = path.start;
        for (const auto& segment : path.segments) {
            if (const auto* arc = std::get_if<ArcSegment>(&segment)) {
                expect_near(at(*arc, arc->start), last);
                expect_near(at(*arc, arc->start + arc->sweep), arc->to);
            }
            last = end_of(segment);
        }
    }
}

TEST(Shapes, PointListsMakePolylinesAndPolygons) {
    EXPECT_EQ(first_shape("<polyline points='0,0 4,0 4-3'/>").subpaths[0],
              path_through({{0, 0}, {4, 0}, {4, -3}}, false));
    EXPECT_EQ(first_shape("<polygon points='0 0 4 0,4,3'/>").subpaths[0],
              path_through({{0, 0}, {4, 0}, {4, 3}}, true));
    const auto odd = drawn("<polyline points='0 0 4 0 9'/>");
    EXPECT_EQ(odd.shapes.at(0).subpaths[0], path_through({{0, 0}, {4, 0}}, false));
    EXPECT_TRUE(warns_of(odd, "a faulty outline"));
}

TEST(Shapes, ALineIsNeverFilled) {
    EXPECT_FALSE(first_shape("<line x2='5' fill='red' stroke='blue'/>").fill);
    EXPECT_TRUE(drawn("<line x2='5' fill='red'/>").shapes.empty());
}

TEST(Shapes, WhatHasNoExtentIsSaid) {
    const auto document = drawn("<rect width='0' height='5'/><circle r='0'/><path d=''/>");
    EXPECT_TRUE(document.shapes.empty());
    EXPECT_TRUE(warns_of(document, "a shape without extent: draws nothing (3 times, first here)"));
}

TEST(Transforms, EveryFunctionMapsAsWritten) {
    expect_near(mapped("matrix(1 2 3 4 5 6)", {1, 1}), {9, 12});
    expect_near(mapped("translate(3)", {1, 1}), {4, 1});
    expect_near(mapped("translate(3-4)", {1, 1}), {4, -3});
    expect_near(mapped("scale(3)", {1, 2}), {3, 6});
    expect_near(mapped("scale(3,.5)", {1, 2}), {3, 1});
    expect_near(mapped("rotate(90)", {1, 2}), {-2, 1});
    expect_near(mapped("rotate(30)", {1, 0}), unit(pi / 6));
    expect_near(mapped("rotate(180, 5, 5)", {1, 2}), {9, 8});
    expect_near(mapped("skewX(45)", {1, 2}), {3, 2});
    expect_near(mapped("skewY(45)", {1, 2}), {1, 3});
}

TEST(Transforms, ListsApplyTheLastFirstWithAnySeparators) {
    for (const char* list :
         {"translate(10 0) scale(2)", "translate(10,0),scale(2)", " translate ( 10 , 0 )scale( 2 ) "})
        expect_near(mapped(list, {1, 1}), {12, 2});
}

TEST(Transforms, GroupsNestAndStrokesScaleWithThem) {
    const auto shape = first_shape(
        "<g transform='translate(5 0)'><g transform='scale(4 1)'><path stroke='red' stroke-width='3' d='M1 "
        "1h1'/></g></g>");
    EXPECT_EQ(shape.subpaths[0], path_through({{9, 1}, {13, 1}}, false));
    EXPECT_DOUBLE_EQ(shape.stroke_width, 6);
}

TEST(Transforms, ArcsStayExactWhenSkewed) {
    const auto arc =
        std::get<ArcSegment>(first_shape("<circle r='2' transform='skewX(45)'/>").subpaths[0].segments[0]);
    expect_near(arc.u, {2, 0});
    expect_near(arc.v, {2, 2});
}

TEST(Transforms, AWrongOneIsPassedOverWithAWarning) {
    for (const char* list : {"scale(1 2 3)", "turn(5)", "scale(2", "scale(2,)", "rotate(1 2)"}) {
        const auto document = drawn(std::string("<path d='M1 1h1' transform='") + list + "'/>");
        EXPECT_TRUE(warns_of(document, "a transform that is not understood")) << list;
        EXPECT_EQ(document.shapes.at(0).subpaths[0].start, (Point{1, 1}));
    }
    EXPECT_TRUE(warns_of(drawn("<path d='M1 1h1' transform='scale(0)'/>"), "leaves no area"));
}

TEST(Transforms, AViewBoxOfANestedSvgIsFitted) {
    const std::string inner = "<rect width='10' height='10'/></svg>";
    expect_box("<svg x='10' y='20' width='40' height='20' viewBox='0 0 10 10'>" + inner, {20, 20}, {40, 40});
    expect_box("<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='none'>" + inner, {0, 0},
               {40, 20});
    expect_box(
        "<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMin slice' "
        "overflow='visible'>" +
            inner,
        {0, 0}, {40, 40});
    expect_box("<svg x='50%' width='40' height='20'>" + inner, {50, 0}, {60, 10});
}

}  // namespace
}  // namespace strandline::svg
