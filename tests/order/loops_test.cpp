// Corner loops keep off what is finished, what must not be entered, and what their own area has raked so far.
#include <gtest/gtest.h>

#include <algorithm>

#include "order/avoiding.hpp"

namespace strandline::order {
namespace {

Stroke stroke_along(int element, const std::vector<Point>& points) {
    Stroke stroke;
    stroke.element = element;
    double s = 0;
    stroke.nodes.push_back({0, points.front(), 0});
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double length = distance(points[k - 1], points[k]);
        stroke.rake_path.push_back(straight({points[k - 1], heading(points[k] - points[k - 1])}, length));
        s += length;
        stroke.nodes.push_back({s, points[k], static_cast<int>(k)});
    }
    return stroke;
}

/// East, then north.
Group corner_group(int element) {
    return {.work = {element, {stroke_along(element, {{0, 0}, {3, 0}, {3, 3}})}}, .name = "corner"};
}

Region box(Point low, Point high) { return {{low, {high.x, low.y}, high, {low.x, high.y}}, {}}; }

/// Metres of the loops at which a wheel, or the turning point, is on the region.
double looped_over(const Ordered& answer, const Robot& robot, const Region& region) {
    double sum = 0;
    for (const Leg& leg : legs_of(answer.stretches)) {
        if (leg.motion != Motion::loop) continue;
        for (std::size_t i = 1; i < leg.path.size(); ++i) {
            const Pose& pose = leg.path[i].pose;
            const Point ahead = unit(pose.heading), left = left_normal(ahead);
            const bool over =
                contains(region, pose.at) || std::ranges::any_of(robot.wheels, [&](const Wheel& wheel) {
                    return contains(region, pose.at + wheel.at.x * ahead + wheel.at.y * left);
                });
            if (over) sum += leg.path[i].s - leg.path[i - 1].s;
        }
    }
    return sum;
}

void expect_one_loop_that_fits(const Ordered& answer) {
    EXPECT_EQ(answer.loops, 1);
    const std::vector<Leg> legs = legs_of(answer.stretches);
    for (std::size_t k = 1; k < legs.size(); ++k) {
        const Pose before = legs[k - 1].path.back().pose, after = legs[k].path.front().pose;
        EXPECT_LT(distance(before.at, after.at), 1e-6);
        EXPECT_LT(std::abs(wrap_angle(after.heading - before.heading)), 1e-6);
    }
    for (const Leg& leg : legs) {
        if (leg.motion == Motion::loop) {
            EXPECT_LT(max_curvature(leg.curve), 2 + 1e-6);
        }
    }
}

TEST(Loops, AtAGapThatIsJoinedDirectlyBelongToTheStrokeBehindIt) {
    const Robot robot = *builtin_robot("beachbot");
    // Up to 2 cm apart, with a bend of 85 degrees at either end of the gap: more than the rake can follow.
    const double bend = 85 * pi / 180, gap = 0.02;
    const Point on = Point{3, 0} + gap * unit(bend);
    const Job job{{{.work = {0, {stroke_along(0, {{0, 0}, {3, 0}})}}, .name = "first"},
                   {.work = {1, {stroke_along(1, {on, on + 3 * unit(2 * bend)})}}, .name = "second"}},
                  {{0, 1}},
                  {},
                  {}};
    Options options = options_for(robot, true);
    options.min_gap = 2 * gap;
    const auto answer = ordered(job, robot, options);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->direct, 1);
    EXPECT_GT(answer->loops, 0);
    for (const Leg& leg : legs_of(answer->stretches)) {
        if (leg.motion == Motion::loop) {
            EXPECT_EQ(leg.stroke, 1);
        }
    }
}

TEST(Loops, GoRoundFinishedAreas) {
    const Robot robot = *builtin_robot("beachbot");
    const Region area = box({2, -2.5}, {4, -0.8});
    Group square{
        .work = {1, {stroke_along(1, {{3.7, -2.2}, {2.3, -2.2}})}}, .name = "square", .area = {area}};
    square.work.strokes[0].fill = square.work.strokes[0].one_way = true;
    const Job job{{corner_group(0), square}, {{1, 0}}, {}, {}};
    for (const bool avoid : {true, false}) {
        const auto answer = ordered(job, robot, options_for(robot, avoid));
        ASSERT_TRUE(answer);
        expect_one_loop_that_fits(*answer);
        if (avoid)
            EXPECT_EQ(looped_over(*answer, robot, area), 0);
        else
            EXPECT_GT(looped_over(*answer, robot, area), 0.3);
    }
}

TEST(Loops, KeepOutOfKeepOuts) {
    const Robot robot = *builtin_robot("beachbot");
    const Region rock = box({2.6, -2}, {4, -1.2});
    for (const bool there : {true, false}) {
        Job job{{corner_group(0)}, {}, {}, {}};
        if (there) job.keep_out = {rock};
        const auto answer = ordered(job, robot, options_for(robot, false));
        ASSERT_TRUE(answer);
        expect_one_loop_that_fits(*answer);
        int within = 0;
        for (const Leg& leg : legs_of(answer->stretches))
            for (const RobotState& state : leg.path)
                within += keeps_off(robot, state.pose.at, state.pose.heading, rock) ? 0 : 1;
        if (there)
            EXPECT_EQ(within, 0);
        else
            EXPECT_GT(within, 10);
    }
}

TEST(Loops, OfAFillKeepOffWhatItHasRaked) {
    const Robot robot = *builtin_robot("beachbot");
    // The second stroke's tip turns by 150 degrees: too sharp for a fill's rounding.
    const Stroke first = stroke_along(0, {{6, -0.6}, {3.2, -0.6}}),
                 second = stroke_along(0, {{0, 0}, {3, 0}, {0.4, 1.5}});
    Group fill{.work = {0, {first, second}}, .name = "fill", .area = {box({0, -0.9}, {6, 1.8})}};
    for (Stroke& stroke : fill.work.strokes) {
        stroke.fill = stroke.one_way = true;
        stroke.pins = robot.pins;
    }
    const Region raked = box({3.2, -0.81}, {6, -0.39});
    const Job job{{fill}, {}, {}, {}};
    for (const bool avoid : {true, false}) {
        const auto answer = ordered(job, robot, options_for(robot, avoid));
        ASSERT_TRUE(answer);
        expect_one_loop_that_fits(*answer);
        if (avoid)
            EXPECT_LT(looped_over(*answer, robot, raked), 0.06);
        else
            EXPECT_GT(looped_over(*answer, robot, raked), 0.3);
    }
}

TEST(Loops, KeepOffTheirOwnLineWhereThatIsWorthIt) {
    const Robot robot = *builtin_robot("beachbot");
    // The shortest loop at the last corner lies over the first stretch.
    Group line{.work = {0, {stroke_along(0, {{5, -0.6}, {-1, -0.6}, {-1, 0}, {3, 0}, {3, 3}})}},
               .name = "line"};
    line.direction = tour::Direction::forward;
    const Job job{{line}, {}, {}, {}};
    const auto crossings = [&](bool avoid) {
        const auto answer = ordered(job, robot, options_for(robot, avoid));
        EXPECT_TRUE(answer);
        if (!answer) return 0;
        const std::vector<Leg> legs = legs_of(answer->stretches);
        const Curve& last = std::find_if(legs.rbegin(), legs.rend(), [](const Leg& leg) {
                                return leg.motion == Motion::loop;
                            })->curve;
        int count = 0;
        const std::vector<CurvePoint> points = sampled(last, 0.02);
        for (std::size_t i = 1; i < points.size(); ++i)
            for (const auto& [a, b] : {std::pair<Point, Point>{{5, -0.6}, {-1, -0.6}}, {{-1, 0}, {3, 0}}}) {
                const auto hit = crossing(points[i - 1].pose.at, points[i].pose.at, a, b);
                count += hit && hit->s < 1 ? 1 : 0;
            }
        return count;
    };
    EXPECT_LT(crossings(true), crossings(false));
}

}  // namespace
}  // namespace strandline::order
