#include "path/trajectory/speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace strandline::trajectory {
namespace {

Course straight_course(double length, int intervals) {
    Course run;
    for (int i = 0; i <= intervals; ++i) {
        run.s.push_back(length * i / intervals);
        run.curvature.push_back(0);
        if (i > 0) run.limit.push_back(0.2);
    }
    return run;
}

double time_of(const Course& run, const std::vector<double>& v) {
    double t = 0;
    for (std::size_t i = 1; i < v.size(); ++i) t += 2 * (run.s[i] - run.s[i - 1]) / (v[i] + v[i - 1]);
    return t;
}

TEST(Speeds, AStraightRunIsATrapezoid) {
    const Robot robot;  // 0.2 m/s, 0.1 m/s^2: 0.2 m to reach full speed
    const Course run = straight_course(10, 1000);
    const auto v = speeds_along(run, robot);
    EXPECT_EQ(v.front(), 0);
    EXPECT_EQ(v.back(), 0);
    EXPECT_DOUBLE_EQ(v[500], 0.2);
    EXPECT_NEAR(time_of(run, v), 10 / 0.2 + 0.2 / 0.1, 0.1);
}

TEST(Speeds, AShortRunNeverReachesFullSpeed) {
    const Course run = straight_course(0.1, 10);
    for (double v : speeds_along(run, Robot{})) EXPECT_LT(v, 0.11);
}

/// The limits as a reader of the trajectory measures them: from neighbouring samples.
void expect_within_limits(const Course& run, const std::vector<double>& v, const Robot& robot) {
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        const double ds = run.s[i + 1] - run.s[i], dt = 2 * ds / (v[i] + v[i + 1]);
        ASSERT_GT(v[i] + v[i + 1], 0) << i;
        EXPECT_LE(v[i], run.limit[i] * 1.000001) << i;
        EXPECT_LE(std::abs(v[i] * run.curvature[i]), robot.turn_rate * 1.000001) << i;
        EXPECT_LE(std::abs(v[i + 1] - v[i]) / dt, robot.acceleration * 1.000001) << i;
        const double turn = (v[i + 1] * run.curvature[i + 1] - v[i] * run.curvature[i]) / dt;
        EXPECT_LE(std::abs(turn), robot.turn_acceleration * 1.000001) << i;
    }
}

TEST(Speeds, AnyRunKeepsEveryLimitBetweenSamples) {
    std::mt19937_64 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    for (int round = 0; round < 200; ++round) {
        Course run;
        const int n = 3 + static_cast<int>(random() % 300);
        double s = 0, k = uniform(-8, 8);
        for (int i = 0; i < n; ++i) {
            run.s.push_back(s);
            run.curvature.push_back(k);
            if (i > 0) run.limit.push_back(i % 50 < 25 ? 0.2 : 0.15);
            s += uniform(0.002, 0.05);
            k = round % 3 ? std::clamp(k + uniform(-0.5, 0.5), -12.0, 12.0) : uniform(-15, 15);
        }
        const Robot robot;
        expect_within_limits(run, speeds_along(run, robot), robot);
    }
}

}  // namespace
}  // namespace strandline::trajectory
