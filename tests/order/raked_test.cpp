// What is being raked, as cells: each element's own, until it is finished.
#include "path/order/raked.hpp"

#include <gtest/gtest.h>

namespace strandline::order {
namespace {

Stroke stroke_along(int element, Point from, Point to, bool fill, int pins) {
    Stroke stroke;
    stroke.element = element;
    stroke.fill = fill;
    stroke.pins = pins;
    stroke.rake_path = {straight({from, heading(to - from)}, distance(from, to))};
    stroke.nodes = {{0, from, 0}, {distance(from, to), to, 1}};
    return stroke;
}
/// The robot's leg that draws a straight stroke.
Leg leg_of(const Stroke& stroke, const Robot& robot) {
    Curve curve = stroke.rake_path.front();
    curve.start.at = curve.start.at + robot.rake_offset * unit(curve.start.heading);
    return {Motion::draw, 0, states_along(curve, 0.01), {}};
}

struct Field {
    const Robot robot = *builtin_robot("beachbot");
    const Stroke area = stroke_along(0, {0, 0}, {4, 0}, true, robot.pins),
                 line = stroke_along(1, {2, -1}, {2, 1}, false, 1);
    Job job{{{.work = {0, {area}}}, {.work = {1, {line}}}}, {}, {}, {}};
    Raked raked{job, robot, {.on = true}};
    /// From below to above, over the area and, further left, not over the line.
    const Curve across = straight({{1, -1}, pi / 2}, 2), along = straight({{1, 0.6}, 0}, 2);
    void draw_area() { raked.draw(leg_of(area, robot), area, 7); }
    void draw_line() { raked.draw(leg_of(line, robot), line, 8); }
};

TEST(Raked, WheelsOnAnAreaAndTheTurningPointOverALineAreCountedUntilTheyAreFinished) {
    Field field;
    EXPECT_EQ(field.raked.rolled(field.across).metres, 0);
    field.draw_area();
    field.draw_line();
    const Rolled rolled = field.raked.rolled(field.across);
    // between the first front wheel's arrival and the last back wheel's departure
    EXPECT_NEAR(rolled.metres, field.robot.rake_width() + 0.35, 0.15);
    EXPECT_EQ(rolled.crossings, 0);
    ASSERT_TRUE(rolled.first);
    EXPECT_NEAR(rolled.first->y, -field.robot.rake_width() / 2 - 0.35, 0.1);
    EXPECT_EQ(field.raked.rolled(field.along).crossings, 1);
    EXPECT_EQ(field.raked.rolled(field.along).metres, 0);
    field.raked.finish(0);
    EXPECT_EQ(field.raked.rolled(field.across).metres, 0);
    EXPECT_EQ(field.raked.rolled(field.along).crossings, 1);
    field.raked.finish(1);
    EXPECT_EQ(field.raked.rolled(field.along).crossings, 0);
    EXPECT_EQ(field.raked.state(), 0u);
}

TEST(Raked, FinishingOneElementLeavesAnothersCells) {
    Field field;
    field.draw_area();
    const double before = field.raked.rolled(straight({{2, -1}, pi / 2}, 2)).metres;
    field.draw_line();
    field.raked.finish(1);
    EXPECT_GT(before, 0);
    EXPECT_EQ(field.raked.rolled(straight({{2, -1}, pi / 2}, 2)).metres, before);
}

TEST(Raked, TheStateIsThatOfWhatIsRakedInWhateverOrder) {
    Field one, other;
    one.draw_area();
    const auto area_alone = one.raked.state();
    one.draw_line();
    other.draw_line();
    EXPECT_NE(area_alone, other.raked.state());
    other.draw_area();
    EXPECT_EQ(one.raked.state(), other.raked.state());
    one.raked.finish(1);
    EXPECT_EQ(one.raked.state(), area_alone);
}

}  // namespace
}  // namespace strandline::order
