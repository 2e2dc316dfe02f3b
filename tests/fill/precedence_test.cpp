// Which strokes of a fill wait for which.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fill/areas.hpp"

namespace strandline::fill {
namespace {

using areas::with;

/// Three squares of 4 m on a strip.
Region three_lobes() {
    return {{{0, 0},
             {14, 0},
             {14, 5},
             {10, 5},
             {10, 1.2},
             {9, 1.2},
             {9, 5},
             {5, 5},
             {5, 1.2},
             {4, 1.2},
             {4, 5},
             {0, 5}},
            {}};
}

std::vector<Point> points_of(const Stroke& stroke) {
    std::vector<Point> points;
    for (const Curve& curve : stroke.rake_path)
        for (const CurvePoint& point : sampled(curve, 0.1)) points.push_back(point.pose.at);
    return points;
}
double apart(const Stroke& a, const Stroke& b) {
    double least = 1e9;
    const std::vector<Point> others = points_of(b);
    for (const Point p : points_of(a))
        for (const Point q : others) least = std::min(least, distance(p, q));
    return least;
}

/// Another order that keeps the pairs.
std::vector<int> shuffled(const Fill& fill, std::mt19937& random) {
    std::vector<int> order, left;
    for (int k = 0; k < static_cast<int>(fill.strokes.size()); ++k) left.push_back(k);
    while (!left.empty()) {
        std::vector<int> ready;
        for (const int b : left)
            if (std::ranges::none_of(fill.before, [&](const auto& pair) {
                    return pair.second == b && std::ranges::find(left, pair.first) != left.end();
                }))
                ready.push_back(b);
        if (ready.empty()) return {};
        order.push_back(ready[random() % ready.size()]);
        std::erase(left, order.back());
    }
    return order;
}

std::vector<Region> several() {
    std::vector<Region> regions = areas::all();
    regions.push_back(three_lobes());
    return regions;
}

TEST(FillPrecedence, StrokesThatMeetAreInOrderAndTheLastIsLast) {
    for (const Style style : {Style::rings, Style::spiral, Style::zigzag})
        for (const Region& region : several()) {
            const Options options = with(style);
            const Fill fill = fill_region(region, 0, "area", options);
            const int count = static_cast<int>(fill.strokes.size());
            for (const auto& [a, b] : fill.before) EXPECT_TRUE(0 <= a && a < b && b < count);
            for (int b = 1; b < count; ++b)
                for (int a = 0; a < b; ++a) {
                    const bool paired = std::ranges::find(fill.before, std::pair{a, b}) != fill.before.end();
                    if (b == count - 1 || apart(fill.strokes[static_cast<std::size_t>(a)],
                                                fill.strokes[static_cast<std::size_t>(b)]) < options.width) {
                        EXPECT_TRUE(paired) << a << " " << b;
                    }
                }
        }
}

TEST(FillPrecedence, LobesThatDoNotMeetAreFree) {
    Options options = with(Style::rings);
    const Fill fill = fill_region(three_lobes(), 0, "area", options);
    ASSERT_GE(fill.strokes.size(), 3u);
    const int count = static_cast<int>(fill.strokes.size());
    EXPECT_LT(static_cast<int>(fill.before.size()), count * (count - 1) / 2);
}

TEST(FillPrecedence, AnyOrderThatKeepsThePairsRakesTheSame) {
    std::mt19937 random(7);
    int others = 0;
    for (const Style style : {Style::rings, Style::zigzag})
        for (const Region& region : several()) {
            const Options options = with(style);
            const Fill fill = fill_region(region, 0, "area", options);
            const std::vector<Polyline> straight(fill.strokes.size());
            const auto plain = account_of(region, fill.strokes, straight, options);
            for (int round = 0; round < 3; ++round) {
                const std::vector<int> order = shuffled(fill, random);
                ASSERT_EQ(order.size(), fill.strokes.size());
                others += std::ranges::is_sorted(order) ? 0 : 1;
                std::vector<Stroke> strokes;
                for (const int k : order) strokes.push_back(fill.strokes[static_cast<std::size_t>(k)]);
                const auto account = account_of(region, strokes, straight, options);
                EXPECT_NEAR(account.coverage, plain.coverage, 1e-3);
                EXPECT_NEAR(account.overdraw, plain.overdraw, 2e-3);
                EXPECT_NEAR(account.spill, plain.spill, 1e-3);
            }
        }
    EXPECT_GT(others, 3);
}

}  // namespace
}  // namespace strandline::fill
