#include <gtest/gtest.h>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

Path line_path(std::vector<Point> points, bool closed = false) { return path_through(points, closed); }

Path only(const std::string& d) {
    const auto data = parse_path_data(d);
    EXPECT_EQ(data.message, "") << d;
    EXPECT_EQ(data.subpaths.size(), 1u) << d;
    return data.subpaths.empty() ? Path{} : data.subpaths.front();
}
std::string message_of(const std::string& d) { return parse_path_data(d).message; }

TEST(PathData, AbsoluteAndRelativeLinesAgree) {
    const Path path = line_path({{1, 2}, {3, 4}, {7, 4}, {7, 9}});
    EXPECT_EQ(only("M1,2 L3,4 H7 V9"), path);
    EXPECT_EQ(only("m1 2 l2 2 h4 v5"), path);
}

TEST(PathData, FurtherPairsAfterAMovetoAreLines) {
    EXPECT_EQ(only("M0 0 1 1 2 0"), line_path({{0, 0}, {1, 1}, {2, 0}}));
    EXPECT_EQ(only("m5 5 1 1 1 -1"), line_path({{5, 5}, {6, 6}, {7, 5}}));
}

TEST(PathData, NumbersNeedNoSeparatorsWhereTheyEndThemselves) {
    EXPECT_EQ(only("M.5-.5L1e1-2E0+3.5.25"), line_path({{0.5, -0.5}, {10, -2}, {3.5, 0.25}}));
    EXPECT_EQ(only("M5.,6.l1.e1 0"), line_path({{5, 6}, {15, 6}}));
    EXPECT_EQ(only("M0 0L1e-999 1"), line_path({{0, 0}, {0, 1}}));
}

TEST(PathData, AClosedSubpathEndsWhereItStarts) {
    EXPECT_EQ(only("M0 0 4 0 4 3z"), line_path({{0, 0}, {4, 0}, {4, 3}}, true));
    const Path already = only("M0 0 4 0 4 3 0 0z");
    EXPECT_TRUE(already.closed);
    EXPECT_EQ(already.segments.size(), 3u);
}

TEST(PathData, RoundingErrorsOfRelativeCommandsLeaveNoClosingLine) {
    const Path path = only("m0.1 0.1 l0.1 0 l0.1 0.2 l-0.1 0.1 l-0.1 -0.3z");
    EXPECT_EQ(path.segments.size(), 4u);
    EXPECT_EQ(std::get<LineSegment>(path.segments.back()).to, path.start);
}

TEST(PathData, AfterACloseTheNextSubpathStartsAtTheSamePoint) {
    const auto data = parse_path_data("M1 1h2v2zl-1-1");
    ASSERT_EQ(data.subpaths.size(), 2u);
    EXPECT_EQ(data.subpaths[1], line_path({{1, 1}, {0, 0}}));
}

TEST(PathData, ALoneMovetoIsDroppedAndALoneCloseIsAPoint) {
    EXPECT_TRUE(parse_path_data("M1 1").subpaths.empty());
    EXPECT_EQ(parse_path_data("M1 1M2 2h1").subpaths.size(), 1u);
    const Path point = only("M1 1z");
    EXPECT_EQ(point, (Path{{1, 1}, {LineSegment{{1, 1}}}, true}));
}

TEST(PathData, SmoothCurvesMirrorTheControlBeforeThem) {
    const Path path = only("M0 0C0 1 2 1 2 0S4-1 4 0");
    EXPECT_EQ(std::get<CubicSegment>(path.segments[1]), (CubicSegment{{2, -1}, {4, -1}, {4, 0}}));
    const Path after_line = only("M0 0L2 0S4-1 4 0");
    EXPECT_EQ(std::get<CubicSegment>(after_line.segments[1]).control1, (Point{2, 0}));
    const Path after_quadratic = only("M0 0Q1 1 2 0S4-1 4 0");  // S looks at cubics alone
    EXPECT_EQ(std::get<CubicSegment>(after_quadratic.segments[1]).control1, (Point{2, 0}));
}

TEST(PathData, QuadraticsBecomeTheSameCurveAsCubics) {
    const Path path = only("M0 0Q3 3 6 0T12 0");
    const auto first = std::get<CubicSegment>(path.segments[0]),
               second = std::get<CubicSegment>(path.segments[1]);
    expect_near(first.control1, {2, 2});
    expect_near(first.control2, {4, 2});
    expect_near(second.control1, {8, -2});
    expect_near(second.control2, {10, -2});
}

TEST(PathData, ArcFlagsMayBePacked) {
    const Path spaced = only("M0 0a1 1 0 0 1 10 10a2 2 0 1 0 1-1"),
               packed = only("M0 0a1 1 0 0110 10a2 2 0 101-1");
    EXPECT_EQ(spaced, packed);
    EXPECT_EQ(parse_path_data("M0 0a1 1 0 2 1 1 1").message,
              "a flag 0 or 1 expected, '2' found at character 12");
}

TEST(PathData, AllFourArcsOfACircleEndWhereTheyShould) {
    for (const bool large : {false, true})
        for (const bool positive : {false, true}) {
            const std::string flags = std::string(large ? "1" : "0") + (positive ? " 1" : " 0");
            const Path path = only("M3 0A3 3 0 " + flags + " 0 3");
            const auto arc = std::get<ArcSegment>(path.segments.at(0));
            expect_near(at(arc, arc.start), {3, 0});
            expect_near(at(arc, arc.start + arc.sweep), {0, 3});
            expect_near(arc.center, large == positive ? Point{3, 3} : Point{0, 0});
            EXPECT_EQ(arc.sweep > 0, positive);
            EXPECT_EQ(std::abs(arc.sweep) > pi, large);
        }
}

TEST(PathData, ATurnedEllipseKeepsItsAxes) {
    const auto arc = std::get<ArcSegment>(only("M0 0A4 2 30 0 1 5 1").segments.at(0));
    expect_near(arc.u, 4 * unit(pi / 6));
    expect_near(arc.v, 2 * left_normal(unit(pi / 6)));
    expect_near(at(arc, arc.start), {0, 0});
    expect_near(at(arc, arc.start + arc.sweep), {5, 1});
}

TEST(PathData, RadiiThatAreTooSmallGrowToAHalfEllipse) {
    const auto arc = std::get<ArcSegment>(only("M0 0A1 1 0 0 1 10 0").segments.at(0));
    expect_near(arc.center, {5, 0});
    EXPECT_NEAR(length(arc.u), 5, 1e-12);
    EXPECT_NEAR(arc.sweep, pi, 1e-7);
}

TEST(PathData, DegenerateArcsAreLinesOrNothing) {
    EXPECT_EQ(only("M0 0A0 5 0 0 1 4 4"), line_path({{0, 0}, {4, 4}}));
    EXPECT_EQ(only("M0 0A5 0 0 0 1 4 4"), line_path({{0, 0}, {4, 4}}));
    EXPECT_EQ(only("M1 1A5 5 0 0 1 1 1L2 2"), line_path({{1, 1}, {2, 2}}));
    EXPECT_EQ(only("M0 0A1e14 1e14 0 0 1 4 4"), line_path({{0, 0}, {4, 4}}));
    EXPECT_EQ(std::get<ArcSegment>(only("M0 0A-2-2 0 0 1 2 2").segments.at(0)),
              std::get<ArcSegment>(only("M0 0A2 2 0 0 1 2 2").segments.at(0)));
}

TEST(PathData, WhatStandsBeforeAnErrorIsKept) {
    const auto data = parse_path_data("M0 0L1 1L2 x L3 3");
    ASSERT_EQ(data.subpaths.size(), 1u);
    EXPECT_EQ(data.subpaths[0], line_path({{0, 0}, {1, 1}}));
    EXPECT_EQ(data.message, "a number expected, 'x' found at character 12");
}

TEST(PathData, EveryKindOfErrorSaysWhereItIs) {
    EXPECT_EQ(message_of("L1 1"), "a first command M or m expected, 'L' found at character 1");
    EXPECT_EQ(message_of("M1 1 R2 2"), "a command expected, 'R' found at character 6");
    EXPECT_EQ(message_of("M1 1 2"), "a number expected, the end found at character 7");
    EXPECT_EQ(message_of("M1 1,,2 2"), "a number after the comma expected, ',' found at character 6");
    EXPECT_EQ(message_of("M1 1z5"), "a command expected, '5' found at character 6");
    EXPECT_EQ(message_of("M+-1 1"), "a number expected, '+' found at character 2");
    EXPECT_EQ(message_of("M0 0L nan 1"), "a number that is not finite or beyond 1e+15 at character 7");
    EXPECT_EQ(message_of("M0 0L 1e999 1"), "a number that is not finite or beyond 1e+15 at character 7");
    EXPECT_EQ(message_of("M0 0 1e308 1"), "a number that is not finite or beyond 1e+15 at character 6");
}

TEST(PathData, EmptyAndNoneAreNoErrors) {
    for (const char* d : {"", "  \n", "none", " none "}) {
        EXPECT_TRUE(parse_path_data(d).subpaths.empty());
        EXPECT_EQ(message_of(d), "");
    }
}

}  // namespace
}  // namespace strandline::svg
