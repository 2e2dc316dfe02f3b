// The search for the least time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "plan/pipeline/pipeline.hpp"

namespace strandline {
namespace {

std::string short_lines(unsigned seed) {
    std::mt19937 random(seed);
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">)";
    for (int k = 0; k < 14; ++k) {
        const double x = 10 + 80 * share(), y = 10 + 80 * share(), angle = 2 * pi * share();
        svg += fmt::format(R"(<path d="M{} {} L{} {}" stroke="black" fill="none"/>)", x, y,
                           x + 8 * std::cos(angle), y + 8 * std::sin(angle));
    }
    return svg + "</svg>";
}

double time_of(const std::string& svg, const Robot& robot, const std::string& cost) {
    Options options;
    EXPECT_TRUE(set(options, "tour.cost", cost));
    const auto plan = make_plan({svg, "lines.svg"}, robot, options, {});
    EXPECT_TRUE(plan);
    return plan ? plan->figures.time : 0;
}

TEST(Seconds, ARobotThatTurnsSlowlyIsDoneEarlierWhereSecondsCount) {
    Robot slow = *builtin_robot("beachbot");
    slow.turn_rate = 0.1;  // a bend of 0.5 m takes four times as long as a straight of its length
    double metres = 0, seconds = 0;
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        metres += time_of(short_lines(seed), slow, "driven");
        seconds += time_of(short_lines(seed), slow, "seconds");
    }
    EXPECT_LT(seconds, 0.98 * metres);
}

TEST(Seconds, WhereNoBendIsSlowTheyAreMetres) {
    const Robot robot = *builtin_robot("turf");  // 0.9 m at 1 m/s is less than it may turn
    ASSERT_LT(robot.travel_speed / robot.min_radius, robot.turn_rate);
    Options driven, seconds;
    EXPECT_TRUE(set(seconds, "tour.cost", "seconds"));
    auto a = make_plan({short_lines(5), "lines.svg"}, robot, driven, {}),
         b = make_plan({short_lines(5), "lines.svg"}, robot, seconds, {});
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->order, b->order);
    EXPECT_EQ(a->samples.size(), b->samples.size());
}

}  // namespace
}  // namespace strandline
