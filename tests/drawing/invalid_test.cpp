// Areas whose outlines touch or cross: filled by the file's rule, and said.
#include <gtest/gtest.h>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

Path ring(std::vector<Point> points) { return path_through(points, true); }

double whole_area(const Drawing& drawing) {
    double sum = 0;
    for (const Element& element : drawing.elements) sum += area(std::get<RegionElement>(element.what).region);
    return sum;
}

std::vector<std::string> said(const Drawing& drawing) {
    std::vector<std::string> reasons;
    for (const Warning& warning : drawing.warnings)
        if (warning.reason.find("touches or crosses") != std::string::npos) reasons.push_back(warning.reason);
    return reasons;
}

void expect_said(const svg::Shape& shape, double area_left, const std::string& rule) {
    const Drawing drawing = drawn({shape});
    EXPECT_NEAR(whole_area(drawing), area_left, 1e-3);
    ASSERT_EQ(said(drawing).size(), 1u);
    EXPECT_NE(said(drawing)[0].find(rule + " rule"), std::string::npos) << said(drawing)[0];
}

TEST(InvalidAreas, AreFilledByTheFilesRuleAndSaid) {
    expect_said(filled({ring({{10, 10}, {30, 30}, {30, 10}, {10, 30}})}), 200, "nonzero");  // bow-tie
    std::vector<Point> star;
    for (int k = 0; k < 5; ++k) star.push_back(Point{50, 50} + 20 * unit(4 * pi * k / 5));
    const double inner = 20 * std::cos(2 * pi / 5) / std::cos(pi / 5);
    const double middle = 2.5 * inner * inner * std::sin(2 * pi / 5);
    const double all = 5 * 20 * inner * std::sin(pi / 5);
    expect_said(filled({ring(star)}), all, "nonzero");
    expect_said(filled({ring(star)}, svg::FillRule::even_odd), all - middle, "even-odd");
    expect_said(filled({ring({{10, 10}, {50, 10}, {50, 50}, {30, 50}, {30, 30}, {30, 50}, {10, 50}})}), 1600,
                "nonzero");  // a slit of no width
    expect_said(
        filled({square({10, 10}, 60), square({20, 20}, 10), square({30, 30}, 10)}, svg::FillRule::even_odd),
        3400, "even-odd");  // holes that touch
}

TEST(InvalidAreas, RepeatedPointsAndHolesAreNoneOfThem) {
    const Drawing drawing =
        drawn({filled({ring({{10, 10}, {10, 10}, {50, 10}, {50, 50}, {50, 50}, {10, 50}, {10, 10}})}),
               filled({square({60, 60}, 30), square({70, 70}, 5)}, svg::FillRule::even_odd)});
    EXPECT_TRUE(said(drawing).empty());
    EXPECT_NEAR(whole_area(drawing), 1600 + 875, 1e-3);
}

TEST(InvalidAreas, AfterFiveTheRestAreCounted) {
    std::vector<svg::Shape> shapes;
    for (double x = 0; x < 80; x += 10)
        shapes.push_back(filled({ring({{x, 10}, {x + 8, 18}, {x + 8, 10}, {x, 18}})}));
    const Drawing drawing = drawn(shapes);
    EXPECT_EQ(said(drawing).size(), 5u);
    EXPECT_NE(drawing.warnings.back().reason.find("3 more outlines"), std::string::npos);
}

}  // namespace
}  // namespace strandline
