// Passes that run out at sharp corners and begin anew beside them.
#include "path/fill/corners.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace strandline::fill {
namespace {

constexpr double w = 0.42;
const Options looping{.width = w, .tips = Tips::all, .masked = true};

/// East for 3 m, a corner to the left, then an arc of short chords.
Polyline into_an_arc(double turn, double chord) {
    Polyline line{{0, 0}, {3, 0}};
    double heading = turn;
    for (int i = 0; i < 60; ++i) {
        line.push_back(line.back() + chord * unit(heading));
        heading += chord / 2;  // a radius of 2 m
    }
    return line;
}

TEST(Corners, APassRunsOnUntilItsFlatEndHasPassedTheTip) {
    for (const double turn : {1.4, 1.8, 2.2, 2.5}) {
        const Polyline line{{0, 0}, {3, 0}, Point{3, 0} + 3 * unit(turn)};
        const std::vector<Polyline> passes = with_cut_corners(line, false, true, looping);
        ASSERT_EQ(passes.size(), 2u) << turn;
        // The outer edges of both passes meet there.
        const Point tip = Point{3, 0} + w / 2 * Point{std::tan(turn / 2), -1};
        EXPECT_NEAR(passes[0].back().x, tip.x, 1e-9) << turn;
        EXPECT_GT(length(passes[1]), 2.7);
        EXPECT_NEAR(distance(passes[1].back(), line.back()), 0, 1e-9);
    }
}

TEST(Corners, ThePassBehindACornerFollowsShortChordsAndNeverTurnsBack) {
    for (const double turn : {1.4, 1.8, 2.2, 2.5})
        for (const double chord : {0.03, 0.08, 0.3}) {
            const std::vector<Polyline> passes =
                with_cut_corners(into_an_arc(turn, chord), false, true, looping);
            ASSERT_EQ(passes.size(), 2u) << turn << ' ' << chord;
            for (const Polyline& pass : passes)
                for (std::size_t i = 2; i < pass.size(); ++i)
                    EXPECT_GT(dot(pass[i] - pass[i - 1], pass[i - 1] - pass[i - 2]), 0)
                        << turn << ' ' << chord;
        }
}

TEST(Corners, FlatOnesAndThoseOfOtherVehiclesStay) {
    const Polyline flat{{0, 0}, {3, 0}, Point{3, 0} + 3 * unit(1.0)}, sharp{{0, 0}, {3, 0}, {3, 3}};
    EXPECT_EQ(with_cut_corners(flat, false, true, looping), (std::vector<Polyline>{flat}));
    Options other = looping;
    other.tips = Tips::off;
    EXPECT_EQ(with_cut_corners(sharp, false, true, other), (std::vector<Polyline>{sharp}));
    other.tips = Tips::border;
    EXPECT_EQ(with_cut_corners(sharp, false, false, other), (std::vector<Polyline>{sharp}));
    EXPECT_EQ(with_cut_corners(sharp, false, true, other).size(), 2u);
    other.masked = false;  // pins that stay down would rake outside
    EXPECT_EQ(with_cut_corners(sharp, false, true, other), (std::vector<Polyline>{sharp}));
}

}  // namespace
}  // namespace strandline::fill
