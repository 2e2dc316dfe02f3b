// Dashes, clips, markers: what is drawn in the end.
#include <gtest/gtest.h>

#include "math/region/region.hpp"
#include "svg_case.hpp"

namespace strandline::svg {
namespace {

Box box_of(const std::vector<Path>& paths) {
    Box box;
    for (const auto& path : paths) box = united(box, bounds(path));
    return box;
}
double total(const std::vector<Path>& paths) {
    double sum = 0;
    for (const auto& path : paths) sum += length(path);
    return sum;
}
double area_of(const Shape& shape) {
    std::vector<Polygon> polygons;
    for (const auto& path : shape.subpaths) polygons.push_back(flattened(path, 1e-4));
    return area(resolved(polygons, shape.fill_rule == FillRule::even_odd ? strandline::FillRule::even_odd
                                                                         : strandline::FillRule::nonzero));
}
void expect_box(const std::vector<Path>& paths, Box box, double tolerance = 1e-9) {
    expect_near(box_of(paths).low, box.low, tolerance);
    expect_near(box_of(paths).high, box.high, tolerance);
}
/// The shape of one stroked element with those attributes.
Shape stroked(const std::string& attributes) {
    return first_shape("<path stroke='red' fill='none' " + attributes + "/>");
}

TEST(Dashes, AreLinesOfTheirLengths) {
    const auto shape = stroked("d='M0 0H10' stroke-dasharray='3 1'");
    ASSERT_EQ(shape.subpaths.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(shape.subpaths[i].start.x, 4.0 * static_cast<double>(i), 1e-9);
        EXPECT_NEAR(length(shape.subpaths[i]), i < 2 ? 3 : 2, 1e-9);
        EXPECT_FALSE(shape.subpaths[i].closed);
    }
}

TEST(Dashes, AnOddPatternIsGoneThroughTwiceAndTheOffsetShiftsIt) {
    const auto odd =
        stroked("d='M0 0H12' stroke-dasharray='1,2,3'");  // 1 on, 2 off, 3 on, 1 off, 2 on, 3 off
    ASSERT_EQ(odd.subpaths.size(), 3u);
    EXPECT_NEAR(odd.subpaths[1].start.x, 3, 1e-9);
    EXPECT_NEAR(odd.subpaths[2].start.x, 7, 1e-9);
    const auto shifted = stroked("d='M0 0H8' stroke-dasharray='3 1' stroke-dashoffset='2'");
    EXPECT_NEAR(length(shifted.subpaths.at(0)), 1, 1e-9);
    EXPECT_NEAR(shifted.subpaths.at(1).start.x, 2, 1e-9);
    const auto back = stroked("d='M0 0H8' stroke-dasharray='3 1' stroke-dashoffset='-2'");
    EXPECT_NEAR(back.subpaths.at(0).start.x, 0, 1e-9);
    EXPECT_NEAR(length(back.subpaths.at(0)), 1, 1e-9);
}

TEST(Dashes, OnACircleArePiecesOfArcsAndGoOnOverItsStart) {
    // circumference 20 pi; dash and gap 5 pi each, shifted by half a dash: one lies over the start
    const auto shape = first_shape(
        "<circle cx='50' cy='50' r='10' fill='none' stroke='red' pathLength='4' "
        "stroke-dasharray='1' stroke-dashoffset='.5'/>");
    ASSERT_EQ(shape.subpaths.size(), 2u);
    for (const auto& dash : shape.subpaths) {
        EXPECT_NEAR(length(dash), 5 * pi, 1e-6);
        for (const auto& segment : dash.segments) EXPECT_TRUE(std::holds_alternative<ArcSegment>(segment));
    }
    expect_near(shape.subpaths[1].start, {50 + 10 / std::sqrt(2), 50 - 10 / std::sqrt(2)}, 1e-6);
}

TEST(Dashes, AreMeasuredInTheElementsUnitsOrOnThePage) {
    EXPECT_EQ(stroked("d='M0 0H4' transform='scale(10 1)' stroke-dasharray='1'").subpaths.size(), 2u);
    EXPECT_NEAR(length(stroked("d='M0 0H4' transform='scale(10 1)' stroke-dasharray='1'").subpaths[0]), 10,
                1e-9);
    EXPECT_EQ(
        stroked("d='M0 0H4' transform='scale(10 1)' stroke-dasharray='1' vector-effect='non-scaling-stroke'")
            .subpaths.size(),
        20u);
}

TEST(Dashes, WithAFillTheOutlineStaysAndTheLinesStandBeside) {
    const auto shape = first_shape("<rect width='10' height='10' stroke='red' stroke-dasharray='5'/>");
    EXPECT_EQ(shape.subpaths.size(), 1u);
    EXPECT_TRUE(shape.subpaths[0].closed);
    ASSERT_TRUE(shape.lines);
    EXPECT_EQ(shape.lines->size(), 4u);
    EXPECT_NEAR(total(stroked_paths(shape)), 20, 1e-9);
}

TEST(Dashes, DotsShowUnderRoundCapsOnly) {
    EXPECT_EQ(stroked("d='M0 0H10' stroke-dasharray='0 4' stroke-linecap='round'").subpaths.size(), 3u);
    EXPECT_TRUE(drawn("<path stroke='red' fill='none' d='M0 0H10' stroke-dasharray='0 4'/>").shapes.empty());
}

TEST(Dashes, WhatIsNoPatternIsSolid) {
    for (const char* dashes : {"0", "none", "0 0", "3 -1", "x"})
        EXPECT_EQ(stroked("d='M0 0H10' stroke-dasharray='" + std::string(dashes) + "'").subpaths.size(), 1u)
            << dashes;
    const auto document = drawn("<path stroke='red' fill='none' d='M0 0H10' stroke-dasharray='1e-9'/>");
    EXPECT_EQ(document.shapes.at(0).subpaths.size(), 1u);
    EXPECT_TRUE(warns_of(document, "dashes too fine"));
}

const std::string window = "<clipPath id='w'><rect x='10' y='10' width='20' height='20'/></clipPath>";

TEST(Clip, CutsAreasAndLinesWhereTheyCross) {
    const auto area = first_shape(window + "<rect width='20' height='50' clip-path='url(#w)'/>");
    expect_box(area.subpaths, {{10, 10}, {20, 30}}, 1e-6);
    EXPECT_NEAR(area_of(area), 200, 1e-4);
    const auto line =
        first_shape(window + "<path d='M0 20H50' fill='none' stroke='red' clip-path='url(#w)'/>");
    expect_box(line.subpaths, {{10, 20}, {30, 20}}, 2e-3);
    const auto arc =
        first_shape(window + "<circle cx='20' cy='20' r='12' fill='none' stroke='red' clip-path='url(#w)'/>");
    EXPECT_EQ(arc.subpaths.size(), 4u);
    for (const auto& piece : arc.subpaths)
        for (const auto& segment : piece.segments) EXPECT_TRUE(std::holds_alternative<ArcSegment>(segment));
    // each corner arc spans 90 degrees less twice acos(10 / 12)
    EXPECT_NEAR(total(arc.subpaths), 4 * 12 * (pi / 2 - 2 * std::acos(10.0 / 12)), 0.02);
}

TEST(Clip, WhatItDoesNotTouchIsNotChanged) {
    const auto shape =
        first_shape(window + "<circle cx='20' cy='20' r='5' stroke='red' clip-path='url(#w)'/>");
    EXPECT_EQ(shape.subpaths[0].segments.size(), 4u);
    EXPECT_TRUE(std::holds_alternative<ArcSegment>(shape.subpaths[0].segments[0]));
    EXPECT_FALSE(shape.lines);
    const auto document = drawn(window + "<rect id='r' width='5' height='5' clip-path='url(#w)'/>");
    EXPECT_TRUE(document.shapes.empty());
    EXPECT_TRUE(warns_of(document, "<rect> #r: wholly outside its clip"));
}

TEST(Clip, FillAndStrokeAreCutApart) {
    const auto shape =
        first_shape(window + "<rect x='15' y='15' width='40' height='10' stroke='red' clip-path='url(#w)'/>");
    EXPECT_NEAR(area_of(shape), 150, 1e-4);
    ASSERT_TRUE(shape.lines);
    ASSERT_EQ(shape.lines->size(), 1u);  // one open line round three sides
    EXPECT_NEAR(length(shape.lines->at(0)), 15 + 10 + 15, 0.01);
}

TEST(Clip, OfGroupsNestAndIntersect) {
    const std::string other = "<clipPath id='v'><rect x='20' y='0' width='50' height='50'/></clipPath>";
    const auto both = first_shape(
        window + other + "<g clip-path='url(#w)'><rect width='99' height='99' clip-path='url(#v)'/></g>");
    expect_box(both.subpaths, {{20, 10}, {30, 30}}, 1e-6);
    const auto own =
        first_shape(window +
                    "<clipPath id='v' clip-path='url(#w)'><rect x='20' width='50' height='50'/></clipPath>"
                    "<rect width='99' height='99' clip-path='url(#v)'/>");
    expect_box(own.subpaths, {{20, 10}, {30, 30}}, 1e-6);
    const auto child =
        first_shape(window +
                    "<clipPath id='v'><rect x='20' width='50' height='50' clip-path='url(#w)'/></clipPath>"
                    "<rect width='99' height='99' clip-path='url(#v)'/>");
    expect_box(child.subpaths, {{20, 10}, {30, 30}}, 1e-6);
}

TEST(Clip, UnitsTransformsAndUseAreFollowed) {
    const auto boxed = first_shape(
        "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath>"
        "<g clip-path='url(#c)'><rect x='10' y='10' width='30' height='10'/><rect x='10' y='20' width='40' "
        "height='10'/></g>");
    expect_box(boxed.subpaths, {{10, 10}, {30, 20}}, 1e-6);
    const auto moved = first_shape(
        "<clipPath id='c' transform='translate(5 0)'><rect width='10' height='10' "
        "transform='scale(2)'/></clipPath>"
        "<rect width='90' height='90' transform='translate(0 50)' clip-path='url(#c)'/>");
    expect_box(moved.subpaths, {{5, 50}, {25, 70}}, 1e-6);
    const auto used = first_shape(
        "<defs><rect id='r' x='1' y='2' width='30' height='40'/></defs><clipPath id='c'><use xlink:href='#r' "
        "style='overflow:visible;' x='4'/></clipPath><rect width='99' height='99' clip-path='url(#c)'/>");
    expect_box(used.subpaths, {{5, 2}, {35, 42}}, 1e-6);
}

TEST(Clip, ClipRuleAndHolesCount) {
    const std::string ring = "d='M0 0H30V30H0zM10 10H20V20H10z'";
    EXPECT_NEAR(area_of(first_shape("<clipPath id='c'><path clip-rule='evenodd' " + ring +
                                    "/></clipPath><rect width='99' height='99' clip-path='url(#c)'/>")),
                800, 1e-3);
    EXPECT_NEAR(area_of(first_shape("<clipPath id='c'><path " + ring +
                                    "/></clipPath><rect width='99' height='99' clip-path='url(#c)'/>")),
                900, 1e-3);
    EXPECT_NEAR(area_of(first_shape("<g clip-rule='evenodd'><clipPath id='c'><path " + ring +
                                    "/></clipPath></g><rect width='99' height='99' clip-path='url(#c)'/>")),
                800, 1e-3);
}

TEST(Clip, AStrokeAlongItsEdgeStays) {
    const auto shape = first_shape(window +
                                   "<rect x='10' y='10' width='20' height='20' fill='none' stroke='red' "
                                   "stroke-width='4' clip-path='url(#w)'/>");
    EXPECT_NEAR(total(shape.subpaths), 80, 1e-9);
    EXPECT_TRUE(shape.subpaths.at(0).closed);
}

TEST(Clip, AnEmptyOneLeavesNothingAndCirclesAreSaid) {
    const auto empty = drawn("<clipPath id='c'/><rect width='9' height='9' clip-path='url(#c)'/>");
    EXPECT_TRUE(empty.shapes.empty());
    EXPECT_TRUE(warns_of(empty, "wholly outside its clip"));
    EXPECT_TRUE(drawn("<clipPath id='c'><rect width='9' height='9' visibility='hidden'/></clipPath>"
                      "<rect width='9' height='9' clip-path='url(#c)'/>")
                    .shapes.empty());
    const auto circle = drawn(
        "<clipPath id='c' clip-path='url(#c)'><rect width='5' height='5'/></clipPath>"
        "<rect width='9' height='9' clip-path='url(#c)'/>");
    EXPECT_EQ(circle.shapes.size(), 1u);
    EXPECT_TRUE(warns_of(circle, "a reference in a circle"));
    EXPECT_TRUE(warns_of(
        drawn("<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='1' height='1'/></clipPath>"
              "<path d='M0 0H9' stroke='red' clip-path='url(#c)'/>"),
        "the box of what has no area"));
}

TEST(Mask, AnAreaOfWhiteCutsAndBlackTakesAway) {
    const auto shown = [](const std::string& attributes, const std::string& content) {
        return drawn("<mask id='m' " + attributes + ">" + content +
                     "</mask><rect width='50' height='50' mask='url(#m)'/>");
    };
    const std::string white = "<rect width='20' height='10' fill='white'/>",
                      black = "<rect width='5' height='5'/>",
                      grey = "<rect width='9' height='9' fill='gray'/>";
    EXPECT_NEAR(area_of(shown("", white).shapes.at(0)), 200, 1e-3);
    EXPECT_NEAR(area_of(shown("", white + black).shapes.at(0)), 175, 1e-3);
    EXPECT_NEAR(area_of(shown("", black + "<g>" + white + "</g>").shapes.at(0)), 200, 1e-3);
    EXPECT_NEAR(area_of(shown("style='mask-type:alpha'", black + grey).shapes.at(0)), 81, 1e-3);
    EXPECT_NEAR(
        area_of(shown("maskUnits='userSpaceOnUse' x='10' y='0' width='50' height='5'", white).shapes.at(0)),
        50, 1e-3);
    EXPECT_TRUE(shown("", white).warnings.empty());
    EXPECT_TRUE(shown("", black).shapes.empty());
}

TEST(Mask, WhatIsMoreThanAnAreaIsSaidAndNotApplied) {
    for (const char* content :
         {"<rect width='9' height='9' fill='gray'/>",
          "<rect width='9' height='9' fill='white' opacity='.5'/>", "<path d='M0 0h9' stroke='white'/>",
          "<image width='9' height='9'/>",
          "<linearGradient id='g'><stop/><stop stop-color='white'/></linearGradient><rect width='9' "
          "height='9' fill='url(#g)'/>"}) {
        const auto document = drawn("<mask id='m'>" + std::string(content) +
                                    "</mask><rect width='50' height='50' mask='url(#m)'/>");
        ASSERT_EQ(document.shapes.size(), 1u) << content;
        EXPECT_NEAR(area_of(document.shapes[0]), 2500, 1e-9) << content;
        EXPECT_TRUE(warns_of(document, "a mask with shades or strokes is not supported")) << content;
    }
}

const std::string arrow =
    "<marker id='m' markerWidth='4' markerHeight='4' refX='1' refY='2' orient='auto' overflow='visible'>"
    "<path d='M0 0L4 2L0 4z' fill='context-stroke'/></marker>";

TEST(Markers, StandAtTheEndsTurnedAndScaledByTheStroke) {
    const auto document =
        drawn(arrow +
              "<path id='p' d='M10 10V50' stroke='red' stroke-width='2' fill='none' marker-end='url(#m)'/>");
    ASSERT_EQ(document.shapes.size(), 2u) << all_warnings(document);
    EXPECT_EQ(document.shapes[1].id, "p/marker-end-1/path@1:162");
    EXPECT_EQ(document.shapes[1].fill->colour, (Colour{255, 0, 0}));
    // pointing down: its tip (4, 2), 3 units beyond the reference point, is 6 further on
    expect_box(document.shapes[1].subpaths, {{6, 48}, {14, 56}});
}

TEST(Markers, AreAtEveryVertexBetweenAndFollowTheBisector) {
    const std::string dot =
        "<marker id='m' markerWidth='2' markerHeight='2' refX='1' refY='1' orient='auto' "
        "markerUnits='userSpaceOnUse'>"
        "<path d='M1 1H2' stroke='red'/></marker>";
    const auto document = drawn(dot + "<polyline points='10,10 20,10 20,20' fill='none' marker='url(#m)'/>");
    ASSERT_EQ(document.shapes.size(), 3u) << all_warnings(document);
    const double half = std::sqrt(0.5);
    std::vector<Point> ends;
    for (const auto& shape : document.shapes) ends.push_back(end_of(shape.subpaths.at(0)));
    expect_near(ends[0], {11, 10}, 1e-4);
    expect_near(ends[1], {20 + half, 10 + half}, 1e-4);
    expect_near(ends[2], {20, 21}, 1e-4);
}

TEST(Markers, TheStartMayBeTurnedRoundAndAnglesAreFixed) {
    std::string reverse = arrow;
    reverse.replace(reverse.find("'auto'"), 6, "'auto-start-reverse'");
    const auto turned =
        drawn(reverse + "<path d='M10 10H50' stroke='red' fill='none' marker-start='url(#m)'/>");
    expect_box(turned.shapes.at(1).subpaths, {{7, 8}, {11, 12}});
    std::string fixed = arrow;
    fixed.replace(fixed.find("'auto'"), 6, "'90'");
    const auto upright =
        drawn(fixed + "<path d='M10 10H50' stroke='red' fill='none' marker-start='url(#m)'/>");
    expect_box(upright.shapes.at(1).subpaths, {{8, 9}, {12, 13}});
}

TEST(Markers, CutAtTheirEdgesAndInheritWhereTheyAreDefined) {
    const auto document = drawn(
        "<g fill='lime'><marker id='m' viewBox='0 0 10 10' refX='5' refY='5' markerWidth='4' "
        "markerHeight='4' "
        "markerUnits='userSpaceOnUse'><rect width='20' height='5'/></marker></g>"
        "<path d='M50 50h9' stroke='red' fill='blue' marker-start='url(#m)'/>");
    const auto& shape = document.shapes.at(1);
    EXPECT_EQ(shape.fill->colour, (Colour{0, 255, 0}));
    expect_box(shape.subpaths, {{48, 48}, {52, 50}}, 1e-6);
}

TEST(Markers, DrawWhereTheShapeItselfHasNoPaint) {
    EXPECT_EQ(drawn(arrow + "<path d='M0 0h9' fill='none' marker-end='url(#m)'/>").shapes.size(), 0u);
    std::string black = arrow;
    black.replace(black.find("context-stroke"), 14, "black");
    EXPECT_EQ(drawn(black + "<path d='M0 0h9' fill='none' marker-end='url(#m)'/>").shapes.size(), 1u);
    EXPECT_EQ(drawn(black + "<rect width='9' height='9' marker-end='url(#m)'/>").shapes.size(), 1u);
}

TEST(Texts, GoThroughTheOutlinerInOrderWithTheirFonts) {
    std::vector<Text> seen;
    const auto boxes = [&](const Text& text) -> Outcome<std::vector<std::vector<Path>>> {
        seen.push_back(text);
        std::vector<std::vector<Path>> outlines;
        for (std::size_t i = 0; i < text.spans.size(); ++i)
            outlines.push_back({path_through({{0, 0}, {text.spans[i].size, 0}, {0, 1}}, true)});
        return outlines;
    };
    const auto document = read(
        "<svg viewBox='0 0 100 100'><rect width='9' height='9'/><text id='t' x='5 6' y='7' "
        "transform='scale(2)' "
        "style=\"font:italic bold 20px/1.2 'Open Sans', serif\" fill='red'> Hello\n  <tspan fill='blue' "
        "font-size='50%' dx='1'>big </tspan> beach </text><rect id='last' width='9' height='9'/></svg>",
        {.text_outlines = boxes});
    ASSERT_TRUE(document);
    ASSERT_EQ(seen.size(), 1u);
    ASSERT_EQ(seen[0].spans.size(), 3u);
    EXPECT_EQ(seen[0].spans[0].text, "Hello ");
    EXPECT_EQ(seen[0].spans[1].text, "big ");
    EXPECT_EQ(seen[0].spans[2].text, "beach");
    EXPECT_EQ(seen[0].spans[0].x, (std::vector<double>{5, 6}));
    EXPECT_EQ(seen[0].spans[1].dx, (std::vector<double>{1}));
    EXPECT_TRUE(seen[0].spans[2].x.empty());
    EXPECT_EQ(seen[0].spans[0].family, "'Open Sans', serif");
    EXPECT_EQ(seen[0].spans[0].weight, 700);
    EXPECT_TRUE(seen[0].spans[1].italic);
    EXPECT_EQ(seen[0].spans[1].size, 10);
    ASSERT_EQ(document->shapes.size(), 5u);
    EXPECT_EQ(document->shapes[1].id, "t");
    EXPECT_EQ(document->shapes[2].id, "t/2");
    EXPECT_EQ(document->shapes[2].fill->colour, (Colour{0, 0, 255}));
    expect_box(document->shapes[2].subpaths, {{0, 0}, {20, 2}});
    EXPECT_EQ(document->shapes[4].id, "last");
}

TEST(Texts, EveryFontThatIsMissingIsNamed) {
    const auto document = drawn(
        "<text font-family='Foo'>a</text><text font-family='Bar'>b</text>"
        "<text font-family='Foo'>c</text><text> </text>");
    EXPECT_EQ(document.warnings.size(), 3u) << all_warnings(document);
    EXPECT_TRUE(warns_of(document, "text is left out (turn it into paths): font Foo (2 times, first here)"));
    EXPECT_TRUE(warns_of(document, "font Bar"));
    const auto refused = read("<svg><text>a</text></svg>",
                              {.text_outlines = [](const Text&) -> Outcome<std::vector<std::vector<Path>>> {
                                  return fail("", "no font here", "install one");
                              }});
    EXPECT_TRUE(warns_of(*refused, "text is left out: no font here; install one"));
}

}  // namespace
}  // namespace strandline::svg
