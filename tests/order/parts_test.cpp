// The strokes of one area need not be driven in one go; closed lines are entered where that saves a loop.
#include <gtest/gtest.h>

#include <algorithm>

#include "path/order/order.hpp"

namespace strandline::order {
namespace {

Stroke stroke_from(int element, Point a, Point b, bool fill) {
    Stroke stroke;
    stroke.element = element;
    stroke.fill = stroke.one_way = fill;
    stroke.rake_path = {straight({a, heading(b - a)}, distance(a, b))};
    stroke.nodes = {{0, a, 0}, {distance(a, b), b, 1}};
    return stroke;
}
Group line_group(int element, Point a, Point b) {
    return {.work = {element, {stroke_from(element, a, b, false)}},
            .name = "line " + std::to_string(element)};
}
/// Three strokes one above the other: the first two may change places.
Group area_group(int element) {
    Group group;
    group.name = "area " + std::to_string(element);
    group.work = {element,
                  {stroke_from(element, {0, 0}, {2, 0}, true), stroke_from(element, {0, 8}, {2, 8}, true),
                   stroke_from(element, {0, 10}, {2, 10}, true)}};
    group.before = {{0, 2}, {1, 2}};
    return group;
}
Options options_for(const Robot& robot) {
    Options options;
    options.connect.limits = connect::limits_of(robot);
    if (robot.can_pivot) options.connect.style = connect::Style::straight;
    return options;
}
std::vector<double> heights(const Ordered& answer) {
    std::vector<double> found;
    for (const Stroke& stroke : answer.strokes) found.push_back(stroke.nodes.front().at.y);
    return found;
}

TEST(Parts, OtherWorkComesBetweenTheStrokesOfAnAreaWhereThatIsShorter) {
    const Robot plotter = *builtin_robot("plotter");
    Job job{{area_group(0), line_group(1, {0, 4}, {2, 4})}, {}, {}, Point{0, 0}};
    const auto parted = ordered(job, plotter, options_for(plotter));
    ASSERT_TRUE(parted);
    EXPECT_EQ(heights(*parted), (std::vector<double>{0, 4, 8, 10}));
    job.groups[0].before.clear();
    const auto whole = ordered(job, plotter, options_for(plotter));
    ASSERT_TRUE(whole);
    EXPECT_NE(heights(*whole), heights(*parted));
    EXPECT_LT(parted->straight, whole->straight - 1);
}

TEST(Parts, ThePairsHoldAndTheLastStrokeIsLast) {
    for (const char* name : {"plotter", "beachbot"}) {
        const Robot robot = *builtin_robot(name);
        // From the far end it would be shorter backwards.
        Job job{{area_group(0)}, {}, {}, Point{2, 11}};
        job.groups[0].before = {{0, 1}};
        const auto answer = ordered(job, robot, options_for(robot));
        ASSERT_TRUE(answer);
        EXPECT_EQ(heights(*answer), (std::vector<double>{0, 8, 10})) << name;
        EXPECT_EQ(answer->variants, std::vector<int>{-1});
    }
}

TEST(Parts, WishesForTheWholeHoldForItsParts) {
    const Robot plotter = *builtin_robot("plotter");
    const Job plain{{area_group(0), line_group(1, {0, 4}, {2, 4})}, {}, {}, Point{0, 0}};
    Job job = plain;
    job.before = {{1, 0}};
    auto answer = ordered(job, plotter, options_for(plotter));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->strokes.front().element, 1);
    job.before = {{0, 1}};
    answer = ordered(job, plotter, options_for(plotter));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->strokes.back().element, 1);
    job = plain;
    job.batches = {{1}, {0}};
    answer = ordered(job, plotter, options_for(plotter));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->strokes.front().element, 1);
    job = plain;
    job.ties = {{0, 1, 1, 0}};  // the area's end and the line's start
    answer = ordered(job, plotter, options_for(plotter));
    ASSERT_TRUE(answer);
    EXPECT_EQ(heights(*answer), (std::vector<double>{0, 8, 10, 4}));  // in one go
}

/// A drop with its point on the right, entered at its point or anywhere on its arc.
Group drop_group() {
    const double side = 1.2;
    Stroke stroke;
    stroke.closed = true;
    const Curve out = straight({{2, 0}, pi - 0.45}, side);
    const Point top = end_pose(out).at;
    const Curve back = straight({{top.x, -top.y}, 0.45}, side);
    // round the left: half a turn and what the sides lean
    const double turn = pi + 0.9, radius = top.y / std::cos(0.45);
    Curve round{end_pose(out), {{turn * radius, 1 / radius, 0}}};
    stroke.rake_path = {out, round, back};
    double s = 0;
    for (const Curve& curve : stroke.rake_path) {
        stroke.nodes.push_back({s, curve.start.at, static_cast<int>(stroke.nodes.size())});
        s += length(curve);
    }
    return {.work = {0, {stroke}}, .name = "drop"};
}

TEST(Parts, AClosedLineIsEnteredAtItsSharpCorner) {
    const Robot robot = *builtin_robot("beachbot");
    const auto loops = [](const Ordered& answer) {
        return std::ranges::count(legs_of(answer.stretches), Motion::loop, &Leg::motion);
    };
    // the point is on the far side
    Job job{{drop_group(), line_group(1, {-6, -1}, {-6, 1})}, {{1, 0}}, {}, Point{-6, -1}};
    const auto answer = ordered(job, robot, options_for(robot));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->entries.back().node, 0);
    EXPECT_EQ(loops(*answer), 0);
    job.groups[0].entry = 1;
    const auto fixed = ordered(job, robot, options_for(robot));
    ASSERT_TRUE(fixed);
    EXPECT_EQ(loops(*fixed), 1);
}

}  // namespace
}  // namespace strandline::order
