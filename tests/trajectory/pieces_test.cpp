#include <gtest/gtest.h>

#include "path/trajectory/trajectory.hpp"

namespace strandline::trajectory {
namespace {

/// Straight on from x to x; its stroke is the stretch's own first one.
Stretch straight_on(Motion motion, double from, double to, int stroke) {
    const Curve curve = straight({{from, 0}, 0}, to - from);
    const int own = motion == Motion::draw ? 0 : -1;
    return {std::make_shared<const std::vector<Leg>>(
                std::vector<Leg>{{motion, own, states_along(curve, 0.01), {}}}),
            stroke};
}
/// On the spot, at x.
Stretch turning(double x, double from, double to) {
    return {std::make_shared<const std::vector<Leg>>(
                std::vector<Leg>{{Motion::pivot, -1, {{0, {{x, 0}, from}, 0}, {0, {{x, 0}, to}, 0}}, {}}}),
            0};
}
/// Back by a metre and on again, from x.
Stretch backing(double x) {
    const Curve curve{{{x, 0}, 0}, {{-1, 0, 0}, {1, 0, 0}}};
    return {std::make_shared<const std::vector<Leg>>(
                std::vector<Leg>{{Motion::connect, -1, states_along(curve, 0.01), curve}}),
            0};
}
/// A quarter, curved at once: the robot stands before it.
Stretch bend_from(double x, int stroke) {
    const Curve curve{{{x, 0}, 0}, {{0.5, 2, 0}}};
    return {std::make_shared<const std::vector<Leg>>(
                std::vector<Leg>{{Motion::draw, 0, states_along(curve, 0.01), {}}}),
            stroke};
}
const std::vector<Stroke> strokes(4);

void expect_the_same(const std::vector<Sample>& pieces, const std::vector<Sample>& whole) {
    ASSERT_EQ(pieces.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        Sample sample = pieces[i];
        EXPECT_NEAR(sample.t, whole[i].t, 1e-9) << i;
        EXPECT_NEAR(sample.speed, whole[i].speed, 1e-9) << i;
        EXPECT_NEAR(sample.turn_rate, whole[i].turn_rate, 1e-9) << i;
        sample.t = whole[i].t;
        sample.speed = whole[i].speed;
        sample.turn_rate = whole[i].turn_rate;
        EXPECT_EQ(sample, whole[i]) << i;
    }
}

TEST(Pieces, TogetherAreTheDriveTimedInWhole) {
    const Robot robot = *builtin_robot("beachbot");
    const std::vector<Stretch> drive{straight_on(Motion::draw, 0, 3, 0),
                                     straight_on(Motion::connect, 3, 5, 0),
                                     turning(5, 0, 2),
                                     turning(5, 2, 0),
                                     straight_on(Motion::draw, 5, 6, 1),
                                     backing(6),
                                     bend_from(6, 2)};
    const Options options{.dwell = 0.25};
    Pieces pieces;
    expect_the_same(joined(pieces.timed(drive, strokes, robot, options)),
                    timed(legs_of(drive), strokes, robot, options));
}

TEST(Pieces, StayTheSameObjectsFarFromWhatChanged) {
    const Robot robot = *builtin_robot("beachbot");
    std::vector<Stretch> drive;
    for (int k = 0; k < 4; ++k) {
        drive.push_back(straight_on(Motion::draw, 10 * k, 10 * k + 5, k));
        drive.push_back(straight_on(Motion::connect, 10 * k + 5, 10 * k + 10, 0));
    }
    Pieces pieces;
    const auto before = pieces.timed(drive, strokes, robot, {});
    drive[2] = straight_on(Motion::connect, 10, 15, 0);
    drive[3].stroke = 0;
    drive[4].stroke = 1;
    drive[6].stroke = 2;
    const auto after = pieces.timed(drive, strokes, robot, {});
    expect_the_same(joined(after), timed(legs_of(drive), strokes, robot, {}));
    ASSERT_EQ(after.size(), before.size());
    EXPECT_NE(after[2].piece, before[2].piece);
    for (const std::size_t far : {0u, 5u, 6u, 7u}) EXPECT_EQ(after[far].piece, before[far].piece) << far;
}

}  // namespace
}  // namespace strandline::trajectory
