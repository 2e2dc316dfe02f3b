// What is finished is not driven over: areas where a way exists, lines where that costs less than it is
// worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "order/avoiding.hpp"

namespace strandline::order {
namespace {

Group line_group(int element, Point a, Point b) {
    Stroke stroke;
    stroke.element = element;
    stroke.rake_path = {straight({a, heading(b - a)}, distance(a, b))};
    stroke.nodes = {{0, a, 0}, {distance(a, b), b, 1}};
    return {.work = {element, {stroke}}, .name = "line " + std::to_string(element)};
}

/// A square whose one stroke runs along its lower edge, from right to left, and leaves it.
Group square_group(int element, Point low, double side) {
    Group group = line_group(element, low + Point{side - 0.3, 0.1}, low + Point{0.3, 0.1});
    group.work.strokes[0].fill = group.work.strokes[0].one_way = true;
    group.area = {Region{{low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}}, {}}};
    return group;
}

double metres_within(const Curve& curve, const Region& region) {
    double sum = 0;
    const std::vector<CurvePoint> points = sampled(curve, 0.01);
    for (std::size_t i = 1; i < points.size(); ++i)
        if (contains(region, between(points[i - 1].pose.at, points[i].pose.at, 0.5)))
            sum += points[i].s - points[i - 1].s;
    return sum;
}

/// Crossings of connections with lines that were drawn before them, apart from the first and last 5 cm.
int crossings(const Ordered& answer) {
    int count = 0;
    for (const Connection& c : answer.connections) {
        const std::vector<CurvePoint> points = sampled(c.curve, 0.01);
        const Point begin = points.front().pose.at, end = points.back().pose.at;
        for (std::size_t i = 1; i < points.size(); ++i)
            for (int k = 0; k <= c.from; ++k) {
                const Curve& line = answer.strokes[static_cast<std::size_t>(k)].rake_path.front();
                const auto hit =
                    crossing(points[i - 1].pose.at, points[i].pose.at, line.start.at, end_pose(line).at);
                if (hit && hit->s < 1 && distance(hit->at, begin) > 0.05 && distance(hit->at, end) > 0.05)
                    ++count;
            }
    }
    return count;
}

/// A line on each side of a square that is done before the second.
Job line_square_line() {
    Job job{{line_group(0, {-3, 2}, {-1, 2}), square_group(1, {0, 0}, 4), line_group(2, {5, 2}, {7, 2}),
             line_group(3, {-3, 2.6}, {-1, 2.6})},
            {{1, 0}, {0, 2}, {2, 3}},
            {},
            {}};
    return job;
}

Job three_rows() {
    return {{line_group(0, {0, 0}, {3, 0}), line_group(1, {0, 6}, {3, 6}), line_group(2, {0, 3}, {3, 3})},
            {},
            {},
            {}};
}

TEST(Avoid, ConnectionsGoRoundFinishedAreas) {
    const Robot robot = *builtin_robot("beachbot");
    const Job job = line_square_line();
    for (const bool avoid : {true, false}) {
        const auto answer = ordered(job, robot, options_for(robot, avoid));
        ASSERT_TRUE(answer);
        ASSERT_EQ(answer->connections.size(), 3u);
        double within = 0;
        for (std::size_t k = 1; k < 3; ++k)
            within += metres_within(answer->connections[k].curve, job.groups[1].area[0]);
        if (avoid)
            EXPECT_EQ(within, 0);
        else
            EXPECT_GT(within, 6);
        for (const Blemish& blemish : answer->blemishes)
            EXPECT_EQ(blemish.from, 0) << "but out of the square";
    }
}

TEST(Avoid, WhereThereIsNoWayTheLeastBadOneIsTakenAndListed) {
    const Robot robot = *builtin_robot("beachbot");
    // A ring that is done first, and a line within it.
    Job job{{line_group(0, {3, 3}, {4, 3}), square_group(1, {0, 0}, 7), line_group(2, {9, 3}, {11, 3})},
            {{1, 0}, {0, 2}},
            {},
            {}};
    job.groups[1].area[0].holes = {{{1.5, 1.5}, {1.5, 5.5}, {5.5, 5.5}, {5.5, 1.5}}};
    const auto answer = ordered(job, robot, options_for(robot, true));
    ASSERT_TRUE(answer);
    double listed = 0;
    for (const Blemish& blemish : answer->blemishes)
        if (blemish.from == 1) {
            listed += blemish.metres;
            EXPECT_LT(distance_to_outline(job.groups[1].area[0].holes[0], blemish.at), 0.4);
        }
    const double within = metres_within(answer->connections[1].curve, job.groups[1].area[0]);
    EXPECT_GE(within, 1.5 - 0.02);
    EXPECT_LT(within, 2);
    EXPECT_NEAR(listed, within + 2 * wheel_reach(robot), 0.15);
}

TEST(Avoid, AnOrderIsFoundThatCrossesLessAndWishesAreKept) {
    const Robot robot = *builtin_robot("beachbot");
    std::mt19937_64 random(7);
    const auto uniform = [&](double high) { return high * static_cast<double>(random() >> 11) * 0x1p-53; };
    int with = 0, without = 0;
    for (int round = 0; round < 4; ++round) {
        Job job;
        for (int i = 0; i < 24; ++i) {
            const Point a{uniform(8), uniform(8)};
            job.groups.push_back(line_group(i, a, a + (0.5 + uniform(2)) * unit(uniform(2 * pi))));
        }
        job.before = {{3, 4}, {4, 5}, {10, 2}};
        job.ties = {{7, 0, 8, 1}};
        job.groups[11].direction = tour::Direction::backward;
        for (const bool avoid : {true, false}) {
            const auto answer = ordered(job, robot, options_for(robot, avoid));
            ASSERT_TRUE(answer);
            const int counted = crossings(*answer);
            (avoid ? with : without) += counted;
            if (avoid) {
                int listed = 0;
                for (const Blemish& blemish : answer->blemishes) listed += blemish.crossings;
                EXPECT_NEAR(listed, counted, 1);  // chords of a curve, here and there, at a line's very end
            }
            std::vector<int> place(24);
            for (std::size_t k = 0; k < 24; ++k)
                place[static_cast<std::size_t>(answer->strokes[k].element)] = static_cast<int>(k);
            for (const auto& [a, b] : job.before)
                EXPECT_LT(place[static_cast<std::size_t>(a)], place[static_cast<std::size_t>(b)]);
            EXPECT_EQ(std::abs(place[7] - place[8]), 1);
            EXPECT_TRUE(answer->entries[static_cast<std::size_t>(place[11])].reversed);
        }
    }
    EXPECT_LT(5 * with, without);
}

TEST(Avoid, BatchesStayTogetherAndInOrder) {
    const Robot robot = *builtin_robot("beachbot");
    Job job;
    for (int i = 0; i < 12; ++i) job.groups.push_back(line_group(i, {0.4 * i, 0}, {0.4 * i, 2}));
    job.batches = {{1, 3, 5, 7, 9, 11}, {0, 2, 4, 6, 8, 10}};
    const auto answer = ordered(job, robot, options_for(robot, true));
    ASSERT_TRUE(answer);
    for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(answer->strokes[k].element % 2, k < 6 ? 1 : 0);
}

TEST(Avoid, KeepOutsAndTheFieldHoldWhateverElseIsAvoided) {
    const Robot robot = *builtin_robot("beachbot");
    const Region rock{{{3.5, -1}, {4.5, -1}, {4.5, 3}, {3.5, 3}}, {}};
    for (const bool avoid : {true, false})
        for (const bool kept : {true, false}) {
            Job job{{line_group(0, {0, 1}, {2, 1}), line_group(1, {6, 1}, {8, 1})}, {{0, 1}}, {}, {}};
            // the field leaves room on one side only
            if (kept) {
                job.keep_out = {rock};
                job.field = Region{{{-3, -1.5}, {11, -1.5}, {11, 6}, {-3, 6}}, {}};
            }
            const auto answer = ordered(job, robot, options_for(robot, avoid));
            ASSERT_TRUE(answer);
            const Curve& curve = answer->connections.at(0).curve;
            EXPECT_EQ(metres_within(curve, rock) == 0, kept);
            for (const CurvePoint& point : sampled(curve, 0.02)) EXPECT_GT(point.pose.at.y, -1.3);
            EXPECT_TRUE(answer->blemishes.empty());
        }
}

TEST(Avoid, KeepOutsThatNoLineIsNearAreNeverEntered) {
    const Robot robot = *builtin_robot("beachbot");
    std::mt19937_64 random(11);
    const auto uniform = [&](double high) { return high * static_cast<double>(random() >> 11) * 0x1p-53; };
    int without = 0;
    for (int round = 0; round < 6; ++round) {
        Job job;
        for (int i = 0; i < 8; ++i) {
            const Point a{uniform(10), uniform(10)};
            job.groups.push_back(line_group(i, a, a + (1 + uniform(2)) * unit(uniform(2 * pi))));
        }
        while (job.keep_out.size() < 5) {
            const Point low{uniform(10), uniform(10)};
            const double side = 0.4 + uniform(1.2);
            const Region square{{low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}},
                                {}};
            const Box near = grown(bounds(square), footprint_reach(robot) + robot.rake_offset + 0.02);
            const auto apart = [&](const Group& group) {
                const std::vector<CurvePoint> points = sampled(group.work.strokes[0].rake_path[0], 0.05);
                return std::ranges::none_of(points,
                                            [&](const CurvePoint& p) { return contains(near, p.pose.at); });
            };
            if (std::ranges::all_of(job.groups, apart) &&
                std::ranges::none_of(job.keep_out, [&](const Region& other) {
                    return overlaps(bounds(other), bounds(square));
                }))
                job.keep_out.push_back(square);
        }
        const auto entered = [&](const Job& asked) {
            const auto answer = ordered(asked, robot, options_for(robot, round % 2 == 0));
            int count = 0;
            for (const Connection& c : answer->connections)
                for (const CurvePoint& p : sampled(c.curve, 0.01))
                    for (const Region& region : job.keep_out)
                        count += !keeps_off(robot, p.pose.at, p.pose.heading, region);
            return count;
        };
        EXPECT_EQ(entered(job), 0) << round;
        Job free = job;
        free.keep_out.clear();
        without += entered(free);
    }
    EXPECT_GT(without, 100) << "or the test shows nothing";
}

TEST(Avoid, TheDriveBeginsWhereItIsParkedAndEndsAtTheCheapestExit) {
    const Robot robot = *builtin_robot("beachbot");
    Job job = three_rows();
    job.parked = Pose{{-3, 0}, 1};
    job.exits = {{{9, 9}, 0}, {{-4, 7}, pi}, {{20, 20}, 0}};
    const auto answer = ordered(job, robot, options_for(robot, true));
    ASSERT_TRUE(answer);
    const std::vector<Leg> legs = legs_of(answer->stretches);
    EXPECT_EQ(legs.front().path.front().pose, *job.parked);
    const Pose last = legs.back().path.back().pose;
    double nearest = 1;
    for (const Pose& exit : job.exits)
        nearest =
            std::min(nearest, distance(exit.at, last.at) + std::abs(wrap_angle(exit.heading - last.heading)));
    EXPECT_LT(nearest, 1e-6);
    EXPECT_LT(last.at.x, 15);
    ASSERT_EQ(answer->connections.size(), 4u);
    EXPECT_EQ(answer->connections.front().from, -1);
    EXPECT_EQ(answer->connections.back().to, -1);
    for (std::size_t i = 1; i < legs.size(); ++i)
        EXPECT_LT(distance(legs[i - 1].path.back().pose.at, legs[i].path.front().pose.at), 1e-6);
}

TEST(Avoid, TheSameJobGivesTheSameDrive) {
    const Robot robot = *builtin_robot("beachbot");
    const Job job = line_square_line();
    const auto a = ordered(job, robot, options_for(robot, true)),
               b = ordered(job, robot, options_for(robot, true));
    ASSERT_TRUE(a && b);
    EXPECT_EQ(legs_of(a->stretches), legs_of(b->stretches));
}

}  // namespace
}  // namespace strandline::order
