#include "path/order/order.hpp"

#include <gtest/gtest.h>

namespace strandline::order {
namespace {

Group line_group(int element, Point a, Point b, int pins = 1) {
    Stroke stroke;
    stroke.element = element;
    stroke.pins = pins;
    stroke.rake_path = {straight({a, heading(b - a)}, distance(a, b))};
    stroke.nodes = {{0, a, 0}, {distance(a, b), b, 1}};
    return {.work = {element, {stroke}}, .name = "line " + std::to_string(element)};
}

Options options_for(const Robot& robot) {
    Options options;
    options.connect.limits = connect::limits_of(robot);
    return options;
}

Job three_lines() {
    return {{line_group(0, {0, 0}, {3, 0}), line_group(1, {0, 6}, {3, 6}), line_group(2, {0, 3}, {3, 3})},
            {},
            {},
            {}};
}

void expect_legs_meet(const std::vector<Leg>& legs) {
    for (std::size_t i = 1; i < legs.size(); ++i) {
        const Pose a = legs[i - 1].path.back().pose, b = legs[i].path.front().pose;
        EXPECT_LT(distance(a.at, b.at), 1e-6) << "leg " << i;
        EXPECT_LT(std::abs(wrap_angle(a.heading - b.heading)), 1e-6) << "leg " << i;
    }
}

TEST(Order, EveryStrokeIsDrivenOnceAndLegsMeet) {
    const Robot robot = *builtin_robot("beachbot");
    const auto answer = ordered(three_lines(), robot, options_for(robot));
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->strokes.size(), 3u);
    std::vector<int> elements;
    for (const Stroke& stroke : answer->strokes) elements.push_back(stroke.element);
    std::sort(elements.begin(), elements.end());
    EXPECT_EQ(elements, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(answer->connections.size(), 2u);
    expect_legs_meet(legs_of(answer->stretches));
}

TEST(Order, StraightLengthIsWhatLiesBetweenTheStrokes) {
    const Robot plotter = *builtin_robot("plotter");
    Options options;
    options.connect.style = connect::Style::straight;
    const auto answer = ordered(three_lines(), plotter, options);
    ASSERT_TRUE(answer);
    EXPECT_NEAR(answer->straight, 6, 1e-9);  // up one side, three metres twice
    EXPECT_EQ(answer->direct, 0);
}

TEST(Order, DubinsBoundsWhatIsDrivenFromBelow) {
    const Robot robot = *builtin_robot("beachbot");
    const auto answer = ordered(three_lines(), robot, options_for(robot));
    ASSERT_TRUE(answer);
    double driven = 0;
    for (const Connection& c : answer->connections) driven += length(c.curve);
    EXPECT_GE(driven, answer->dubins - 1e-9);
    EXPECT_LT(driven, 1.2 * answer->dubins);
}

TEST(Order, AVariantIsTakenWhereItsOwnMetresAreFewerThanItSaves) {
    const Robot plotter = *builtin_robot("plotter");
    Options options;
    options.connect.style = connect::Style::straight;
    // From the start to an area that is raked away from it, or, for some metres more, towards the next line.
    Group area = line_group(0, {4, 0}, {1, 0}), line = line_group(1, {5, 0}, {8, 0});
    for (Group* group : {&area, &line})
        for (Stroke& stroke : group->work.strokes) stroke.one_way = true;
    std::vector<Stroke> other = line_group(0, {1, 0}, {4, 0}).work.strokes;
    other[0].one_way = true;
    for (const auto& [longer, expected] : {std::pair{5.0, 0}, std::pair{7.0, -1}}) {
        area.variants = {{other, longer}};
        Job job{{area, line}, {{0, 1}}, {}, Point{1, 0}};
        const auto answer = ordered(job, plotter, options);
        ASSERT_TRUE(answer);
        // 3 m to the start and 4 m to the line, or 0 m and 1 m.
        EXPECT_EQ(answer->variants, (std::vector<int>{expected, -1})) << longer;
        EXPECT_NEAR(answer->straight, expected == 0 ? 1 : 4, 1e-9);
    }
}

TEST(Order, StrokesWhosePinsHaveAnotherMiddleAreNotJoined) {
    // one pin of seven and two: the rake would have to be moved aside where they touch
    const Robot robot = *builtin_robot("beachbot");
    const Job job{{line_group(0, {0, 0}, {3, 0}, 1), line_group(1, {3.01, 0}, {6, 0}, 2)}, {}, {}, {}};
    const auto answer = ordered(job, robot, options_for(robot));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->direct, 0);
    EXPECT_EQ(answer->connections.size(), 1u);
    expect_legs_meet(legs_of(answer->stretches));
}

TEST(Order, StrokesThatTouchAreJoinedDirectlyAndStayTheirOwn) {
    const Robot robot = *builtin_robot("beachbot");
    const Job job{{line_group(0, {0, 0}, {3, 0}, 1), line_group(1, {3.01, 0}, {6, 0}, 3)}, {}, {}, {}};
    const auto answer = ordered(job, robot, options_for(robot));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->direct, 1);
    EXPECT_TRUE(answer->connections.empty());
    expect_legs_meet(legs_of(answer->stretches));
    double drawn[2] = {0, 0}, up = 0;
    for (const Leg& leg : legs_of(answer->stretches))
        for (std::size_t i = 1; i < leg.path.size(); ++i) {
            const double d = distance(rake_at(robot, leg.path[i - 1].pose), rake_at(robot, leg.path[i].pose));
            if (leg.motion == Motion::draw)
                drawn[leg.stroke] += d;
            else
                up += d;
        }
    EXPECT_NEAR(drawn[0] + drawn[1], 5.99, 1e-3);
    EXPECT_NEAR(std::max(drawn[0], drawn[1]), 3, 1e-3);
    EXPECT_NEAR(up, 0.01, 1e-3);
}

TEST(Order, InnerComesBeforeOuterWhenAsked) {
    const Robot robot = *builtin_robot("beachbot");
    Job job = three_lines();
    job.before = {{1, 2}, {2, 0}};
    const auto answer = ordered(job, robot, options_for(robot));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->strokes[0].element, 1);
    EXPECT_EQ(answer->strokes[1].element, 2);
    EXPECT_EQ(answer->strokes[2].element, 0);
    job.before.push_back({0, 1});
    const auto circle = ordered(job, robot, options_for(robot));
    ASSERT_FALSE(circle);
    EXPECT_NE(sentence(circle.error()).find("line"), std::string::npos) << sentence(circle.error());
}

TEST(Order, TiesAreKeptWhateverTheSenses) {
    const Robot robot = *builtin_robot("beachbot");
    Job job = three_lines();
    job.ties = {{0, 0, 1, 1}};  // from the start of line 0 to the end of line 1, or back
    const auto answer = ordered(job, robot, options_for(robot));
    ASSERT_TRUE(answer);
    for (std::size_t i = 0; i + 1 < 3; ++i) {
        const int a = answer->strokes[i].element, b = answer->strokes[i + 1].element;
        if (a + b != 1) continue;
        const bool reversed_a = answer->entries[i].reversed, reversed_b = answer->entries[i + 1].reversed;
        EXPECT_TRUE(a == 0 ? reversed_a && reversed_b : !reversed_a && !reversed_b);
        return;
    }
    ADD_FAILURE() << "lines 0 and 1 are not next to each other";
}

TEST(Order, ALoopIntoAGapBelongsToTheStrokeBehindIt) {
    const Robot robot = *builtin_robot("beachbot");
    int loops = 0;
    for (const double degrees : {50.0, 70.0, 85.0}) {
        const Point on = unit(degrees * pi / 180), from = Point{3, 0} + 0.01 * on;
        const Job job{{line_group(0, {0, 0}, {3, 0}), line_group(1, from, from + 3 * on)}, {}, {}, {}};
        const auto answer = ordered(job, robot, options_for(robot));
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->direct, 1) << degrees;
        for (const Leg& leg : legs_of(answer->stretches)) {
            if (leg.motion != Motion::loop) continue;
            ++loops;
            EXPECT_EQ(leg.stroke, 1) << degrees;
        }
    }
    EXPECT_GT(loops, 0);
}

}  // namespace
}  // namespace strandline::order
