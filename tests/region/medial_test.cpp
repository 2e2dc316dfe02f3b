#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "math/region/exact.hpp"
#include "region/shapes.hpp"

namespace strandline {
namespace {

// Of nearly parallel edges seen from outside, the diagram has corners farther off than the area is wide by
// any factor.
TEST(MedialAxis, IsBoundedByTheAreaHoweverItIsTurned) {
    const Polygon letter{{0, 0}, {1.2, 0}, {2, 3}, {4, 3}, {4.8, 0}, {6, 0}, {3.7, 8}, {2.3, 8}};
    for (int degree = 0; degree < 180; ++degree) {
        const double a = degree * pi / 180;
        const Affine map{std::cos(a), std::sin(a), -std::sin(a), std::cos(a), 0, 0};
        for (const Region& region : inset({{shapes::moved(letter, map), {}}}, 0.31)) {
            const Box box = grown(bounds(region), 0.1);
            for (const MedialAxis::Node& node : medial_axis(region, 0.1).nodes)
                ASSERT_TRUE(contains(box, node.at)) << degree;
        }
    }
}

// A comb: the axis about one tooth's tip is known without the others.
TEST(MedialAxis, NearAPlaceIsTheWholeOneThere) {
    Polygon comb{{0, -2}, {20, -2}};
    for (int tooth = 9; tooth >= 0; --tooth)
        for (const Point p : {Point{2.0 * tooth + 1.5, 0}, {2.0 * tooth + 1.2, 8}, {2.0 * tooth + 0.5, 7}})
            comb.push_back(p);
    const Box tip{{4, 6}, {5.5, 8}};
    const MedialAxis whole = medial_axis({comb, {}}, 0.1), near = medial_axis({comb, {}}, 0.1, {tip}, 1);
    EXPECT_LT(near.nodes.size(), whole.nodes.size() / 3);
    const auto there = [&](const MedialAxis& axis) {
        std::vector<std::pair<double, double>> found;
        for (const MedialAxis::Node& node : axis.nodes)
            if (contains(tip, node.at)) found.emplace_back(node.at.x, node.radius);
        std::ranges::sort(found);
        return found;
    };
    ASSERT_FALSE(there(whole).empty());
    ASSERT_EQ(there(near).size(), there(whole).size());
    for (std::size_t i = 0; i < there(whole).size(); ++i) {
        EXPECT_NEAR(there(near)[i].first, there(whole)[i].first, 1e-6);
        EXPECT_NEAR(there(near)[i].second, there(whole)[i].second, 1e-6);
    }
}

TEST(ExactInteger, IsTheNearestDoubleToTheLastBit) {
    std::mt19937_64 random(1);
    for (int round = 0; round < 200; ++round) {
        exact::Integer number = 1;
        for (int step = 0; step < 12; ++step) {
            number *= static_cast<std::int64_t>(random()) >> (random() % 60);
            const double nearest = number.convert_to<double>();
            EXPECT_NEAR(exact::ToDouble{}(number), nearest, 2.3e-16 * std::abs(nearest));
            EXPECT_NEAR(exact::ToWideExponent{}(number).d(), nearest, 2.3e-16 * std::abs(nearest));
        }
    }
    EXPECT_EQ(exact::ToDouble{}(exact::Integer(0)), 0);
    EXPECT_EQ(exact::ToDouble{}(exact::Integer(-3)), -3);
}

}  // namespace
}  // namespace strandline
