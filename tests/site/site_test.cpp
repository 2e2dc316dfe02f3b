#include "machine/site/site.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "site/earth.hpp"

namespace strandline {
namespace {

Site any_site() {
    const auto number = [](double low, double high) {
        return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) / 1e6;
    };
    return {{number(-89, 89), number(-180, 180)},
            number(0, 500),
            number(-200, 200),
            number(-200, 200),
            number(-7, 7)};
}
Point any_point() { return {*rc::gen::inRange(-700, 701) + 0.25, *rc::gen::inRange(-700, 701) - 0.125}; }

RC_GTEST_PROP(SiteLaws, ThereAndBackIsTheSamePointWithinAMicrometre, ()) {
    const Site site = any_site();
    const Point p = any_point();
    RC_ASSERT(distance(to_canvas(site, to_geographic(site, p)), p) < 1e-6);
    RC_ASSERT(distance(from_local(site, to_local(site, p)), p) < 1e-9);
}

RC_GTEST_PROP(SiteLaws, DistancesOnEarthAreThoseOnTheCanvasWithinAMillimetre, ()) {
    Site site = any_site();
    site.altitude = 0;
    site.x = site.y = 0;
    const Point p = any_point(), q = any_point();
    RC_ASSERT(std::abs(testing::chord(to_geographic(site, p), to_geographic(site, q)) - distance(p, q)) <
              1e-3);
}

RC_GTEST_PROP(SiteLaws, ASecondReaderFindsTheSamePlace, ()) {
    const Site site = any_site();
    const Point p = any_point();
    RC_ASSERT(distance(testing::read_back(site, to_geographic(site, p)), p) < 1e-4);
}

TEST(Site, HeadingIsClockwiseFromNorth) {
    const Site north{{47, 8}, 0, 0, 0, 0}, east{{47, 8}, 0, 0, 0, pi / 2};
    EXPECT_GT(to_geographic(north, {0, 100}).latitude, 47.0008);
    EXPECT_NEAR(to_geographic(north, {0, 100}).longitude, 8, 1e-9);
    EXPECT_GT(to_geographic(east, {0, 100}).longitude, 8.001) << "y looks east";
    EXPECT_LT(to_geographic(east, {100, 0}).latitude, 46.9992) << "x looks south";
    EXPECT_NEAR(local_heading(east, 0), -pi / 2, 1e-12);
}

TEST(Site, AKilometreNorthOnTheEquatorIsWhatTheMeridiansRadiusSays) {
    const double radius = 6335439.327;  // a (1 - e^2)
    EXPECT_NEAR(to_geographic({}, {0, 1000}).latitude * pi / 180 * radius, 1000, 1e-4);
}

TEST(Site, LongitudesStayWithin180Degrees) {
    const Site site{{10, 180}, 0, 0, 0, 0};
    const Geographic at = to_geographic(site, {500, 0});
    EXPECT_LT(at.longitude, -179.9);
    EXPECT_NEAR(to_canvas(site, at).x, 500, 1e-6);
}

TEST(Site, AllOfAPoleIsWithinItsOutline) {
    const Polygon outline = pole_outline({3, 4}, 0.5);
    for (double a = 0; a < 6.3; a += 0.01) EXPECT_TRUE(contains(outline, Point{3, 4} + 0.4999 * unit(a)));
    EXPECT_LT(area(outline), 1.03 * pi * 0.25);
}

}  // namespace
}  // namespace strandline
