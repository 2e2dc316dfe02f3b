// Lines with corners, by a machine whose pen is at its turning point, so that a path is easily driven by
// hand.
#include <gtest/gtest.h>

#include "check/valid_plan.hpp"
#include "result/check/check.hpp"

namespace strandline {
namespace {

using by_hand::Drive;
using by_hand::line_element;
using check::Law;
using check::Report;

Robot pen(bool can_pivot) {
    Robot robot;
    robot.name = "pen";
    robot.rake_offset = 0;
    robot.pins = 1;
    robot.can_pivot = can_pivot;
    robot.turn_rate = 0.5;
    robot.turn_acceleration = 1.0;
    return robot;
}
std::size_t count(const Report& report, Law law) {
    return static_cast<std::size_t>(std::ranges::count(report.faults, law, &check::Fault::law));
}
std::string told(const Report& report) {
    std::string text;
    for (const check::Fault& f : report.faults)
        text += std::string(check::name_of(f.law)) + ": " + f.what + "\n";
    return text;
}
const Point start{5, 5};

/// A corner to the left of two edges of 2 m, drawn sharp by a turn on the spot.
Plan pivoted(bool can_pivot, double turn) {
    Drive drive(pen(can_pivot), {start, 0});
    const Point corner = start + Point{2, 0};
    const int line = drive.element(
        line_element("corner", path_through({start, corner, corner + 2.0 * unit(turn)}, false), 1));
    drive.draw_ahead(line, 1, 2.0).turn_on_the_spot(turn);
    drive.plan().strokes.back().rake_path.push_back(straight(drive.at(), 2));
    return drive.go({{2, 0, 0}}, Motion::draw, 0).finished();
}
/// The same corner, rounded inside by an arc of `radius` that the machine's speed allows.
Plan rounded(double turn, double radius, double edge = 2) {
    Drive drive(pen(true), {start, 0});
    const Point corner = start + Point{edge, 0};
    const int line = drive.element(
        line_element("corner", path_through({start, corner, corner + edge * unit(turn)}, false), 1));
    const double before = edge - radius * std::tan(turn / 2);
    const std::vector<Clothoid> pieces{{before, 0, 0}, {radius * turn, 1 / radius, 0}, {before, 0, 0}};
    drive.plan().robot.turn_acceleration = 100;  // an arc has no ramps of curvature
    return drive.draw(line, 1, {{start, 0}, pieces}, pieces).finished();
}

TEST(Drawn, ACornerTurnedOnTheSpotIsSoundOnlyForARobotThatCan) {
    for (double turn : {0.5, pi / 2, 2.5, -1.0}) {
        const Report can = check::prove(pivoted(true, turn));
        EXPECT_TRUE(can.sound()) << told(can);
        EXPECT_EQ(count(check::prove(pivoted(false, turn)), Law::curvature), 1u);
    }
}

TEST(Drawn, ARoundedCornerIsExplainedByRadiusAndTurnWhereTheOptionsAskForIt) {
    Plan plan = rounded(pi / 2, 0.5);
    EXPECT_EQ(count(check::prove(plan), Law::drawn_right), 1u)
        << "the corner is 0.2 m off, and nothing asked for it";
    plan.options.corner.above = "round";
    plan.options.corner.below = "round";
    Report report = check::prove(plan);
    EXPECT_TRUE(report.sound()) << told(report);
    plan.options.corner.radius = 0.3;
    report = check::prove(plan);
    ASSERT_GE(count(report, Law::drawn_right), 1u);
    EXPECT_NEAR(report.worst_offset, (0.5 - 0.3) * (1 - std::sqrt(0.5)), 1e-3);
}

TEST(Drawn, AroundASharpTurnTheEdgesBoundTheRounding) {
    // 1/cos(turn/2) - 1 is 5.3 at 2.82 rad: edges of 0.4 m leave less room than that.
    Plan plan = rounded(2.82, 0.05, 0.4);
    plan.options.corner.above = "round";
    const Report report = check::prove(plan);
    EXPECT_EQ(count(report, Law::drawn_right), 0u) << told(report);
    for (Sample& s : plan.samples) {
        s.pose.at = s.pose.at + Point{0, 0.45};
        s.rake = s.pose.at;
    }
    EXPECT_GE(count(check::prove(plan), Law::drawn_right), 1u);
}

TEST(Drawn, APieceLeftOutIsNamedWithItsLengthAndPlace) {
    Plan plan = pivoted(true, 1.0);
    int lifted = 0;
    for (Sample& s : plan.samples)
        if (distance(s.rake, start + Point{1, 0}) < 0.1) {
            s.mask = 0;
            s.motion = Motion::lead;
            s.stroke = -1;
            ++lifted;
        }
    ASSERT_GT(lifted, 5);
    const Report report = check::prove(plan);
    ASSERT_EQ(report.faults.size(), 1u) << told(report);
    EXPECT_EQ(report.faults[0].law, Law::drawn_once);
    EXPECT_NEAR(report.faults[0].at.x, 5.9, 0.03);
    EXPECT_NE(report.faults[0].what.find("left out"), std::string::npos);
}

TEST(Drawn, APieceDrawnAgainLaterIsNamed) {
    Drive drive(pen(true), {start, 0});
    const int line =
        drive.element(line_element("line", path_through({start, start + Point{2, 0}}, false), 1));
    drive.draw_ahead(line, 1, 2.0).turn_on_the_spot(pi).draw_ahead(line, 1, 0.5);
    const Report report = check::prove(drive.finished());
    ASSERT_EQ(report.faults.size(), 1u) << told(report);
    EXPECT_EQ(report.faults[0].law, Law::drawn_once);
    EXPECT_NE(report.faults[0].what.find("2.500 m drawn of 2.000 m"), std::string::npos) << told(report);
}

TEST(Drawn, AClosedLineMayBeEnteredAnywhere) {
    for (double first : {0.0, 0.7}) {
        Drive drive(pen(true), {start + Point{first, 0}, 0});
        const int square = drive.element(line_element(
            "square",
            path_through({start, start + Point{2, 0}, start + Point{2, 2}, start + Point{0, 2}}, true), 1));
        drive.draw_ahead(square, 1, 2 - first);
        for (int side = 1; side < 4; ++side) drive.turn_on_the_spot(pi / 2).go({{2, 0, 0}}, Motion::draw, 0);
        if (first > 0) drive.turn_on_the_spot(pi / 2).go({{first, 0, 0}}, Motion::draw, 0);
        const Report report = check::prove(drive.finished());
        EXPECT_TRUE(report.sound()) << told(report);
    }
}

TEST(Drawn, AnElementWithoutAStrokeAndAStrokeWithoutAnElementAreNamed) {
    Plan plan = pivoted(true, 1.0);
    plan.drawing.elements.push_back(line_element("forgotten", path_through({{1, 1}, {2, 1}}, false), 1));
    plan.drawing.elements.push_back({"hole", "", RegionElement{{{{1, 2}, {2, 2}, {2, 3}, {1, 3}}, {}}}, -1});
    Report report = check::prove(plan);
    ASSERT_EQ(report.faults.size(), 2u) << told(report);
    EXPECT_EQ(report.faults[0].element, 1);
    EXPECT_EQ(report.faults[1].element, 2);
    plan.options.fill.min_area = 2;  // smaller areas are left out on purpose
    EXPECT_EQ(check::prove(plan).faults.size(), 1u);
    plan = pivoted(true, 1.0);
    plan.strokes[0].element = 7;
    EXPECT_GE(count(check::prove(plan), Law::drawn_right), 1u);
}

TEST(Drawn, HugeCoordinatesAreNamedWithoutBeingWalked) {
    Plan plan = pivoted(true, 1.0);
    plan.drawing.elements.push_back(line_element("far", path_through({{0, 0}, {1e300, 1e300}}, false), 1));
    plan.samples[50].pose.at = {1e300, 1e300};
    plan.samples[50].rake = plan.samples[50].pose.at;
    const Report report = check::prove(plan);
    EXPECT_GE(count(report, Law::field), 1u);
    EXPECT_GE(count(report, Law::position), 1u);
}

TEST(Drawn, AnEmptyPlanOfAnEmptyDrawingIsSound) {
    Plan plan;
    EXPECT_TRUE(check::prove(plan).sound());
    plan.drawing.elements.push_back(line_element("line", path_through({{1, 1}, {2, 1}}, false), 1));
    EXPECT_EQ(check::prove(plan).faults.size(), 1u);
}

}  // namespace
}  // namespace strandline
