#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "machine/site/site.hpp"

namespace strandline {
namespace {

const Site beach{{47.37, 8.55}, 0, 0, 0, 0.6};

std::vector<Marker> flags_of(const Site& site, const std::vector<Point>& places, bool geographic) {
    std::vector<Marker> flags;
    for (const Point p : places)
        flags.push_back({std::to_string(flags.size()), p,
                         geographic ? std::variant<Geographic, Point>(to_geographic(site, p))
                                    : std::variant<Geographic, Point>(to_local(site, p)),
                         0});
    return flags;
}
const std::vector<Point> corners{{0, 0}, {14, 0}, {14, 14}, {0, 14}};

TEST(Fit, ExactFlagsGiveTheSiteBack) {
    for (const double heading : {-3.0, -0.6, 0.0, 1.5, 3.1}) {
        Site site = beach;
        site.heading = heading;
        const auto found = located(flags_of(site, {{0, 0}, {14, 3}}, true));
        ASSERT_TRUE(found);
        EXPECT_LT(found->largest, 1e-6);
        EXPECT_NEAR(found->site.heading, heading, 1e-7);
        EXPECT_LT(length(to_canvas(beach, found->site.place)), 1e-6);
        EXPECT_EQ(found->site.x, 0);
    }
}

TEST(Fit, FlagsAKilometreAwayTurnNorthAndAreStillMet) {
    const auto found = located(flags_of(beach, {{900, 100}, {1000, 0}, {950, -300}}, true));
    ASSERT_TRUE(found);
    EXPECT_LT(found->largest, 1e-3);
    EXPECT_LT(length(to_canvas(beach, found->site.place)), 1e-3);
}

TEST(Fit, LocalMetresKeepThePlaceTheyCountFrom) {
    Site site = beach;
    site.x = 120;
    site.y = -35;
    Site base;
    base.place = beach.place;
    const auto found = located(flags_of(site, corners, false), base);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->site.place, beach.place);
    EXPECT_NEAR(found->site.x, 120, 1e-9);
    EXPECT_NEAR(found->site.y, -35, 1e-9);
    EXPECT_NEAR(found->site.heading, 0.6, 1e-12);
}

RC_GTEST_PROP(FitLaws, NoTurnOrShiftOfTheFitIsNearer, ()) {
    auto flags = flags_of(beach, corners, false);
    for (Marker& flag : flags) {
        Point& at = std::get<Point>(flag.measured);
        at = at + 0.001 * Point{static_cast<double>(*rc::gen::inRange(-100, 101)),
                                static_cast<double>(*rc::gen::inRange(-100, 101))};
    }
    const auto found = located(flags);
    RC_ASSERT(found.has_value());
    const auto squares = [&](const Site& site) {
        double sum = 0;
        for (const Marker& flag : flags) {
            const Point off = from_local(site, std::get<Point>(flag.measured)) - *flag.canvas;
            sum += dot(off, off);
        }
        return sum;
    };
    RC_ASSERT(std::abs(squares(found->site) - 4 * found->rms * found->rms) < 1e-12);
    for (const double step : {-1e-4, 1e-4}) {
        Site x = found->site, y = x, turned = x;
        x.x += step;
        y.y += step;
        // round the flags' middle: the shift that goes with the turn
        turned.heading += step;
        const Point before = to_local(found->site, {7, 7}), after = to_local(turned, {7, 7});
        turned.x += before.x - after.x;
        turned.y += before.y - after.y;
        for (const Site& other : {x, y, turned}) RC_ASSERT(squares(other) >= squares(found->site) - 1e-12);
    }
}

TEST(Fit, ResidualsSayWhichFlagIsWrong) {
    auto flags = flags_of(beach, corners, false);
    std::get<Point>(flags[2].measured).x += 0.4;
    const auto found = located(flags);
    ASSERT_TRUE(found);
    for (const PlacedMarker& placed : found->markers) EXPECT_LE(*placed.off, *found->markers[2].off);
    EXPECT_GT(found->largest, 0.1);
    EXPECT_LT(found->rms, found->largest);
}

TEST(Fit, APoleWithoutAPlaceIsFoundAndDoesNotBindTheFit) {
    auto flags = flags_of(beach, corners, true);
    flags.insert(flags.begin(), {"pole", {}, to_geographic(beach, {6, 5}), 0.3});
    const auto found = located(flags);
    ASSERT_TRUE(found);
    EXPECT_LT(distance(found->markers[0].at, {6, 5}), 1e-6);
    EXPECT_FALSE(found->markers[0].off);
}

TEST(Fit, SwappedCoordinatesAreNoticed) {
    auto flags = flags_of(beach, {{0, 0}, {14, 0}, {14, 9}}, false);
    for (Marker& flag : flags) {
        Point& at = std::get<Point>(flag.measured);
        std::swap(at.x, at.y);
    }
    const auto found = located(flags);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->mirrored);
    EXPECT_FALSE(located(flags_of(beach, corners, false))->mirrored);
}

TEST(Fit, WhatAllowsNoFitIsRefusedWithTheReason) {
    const auto reason = [](const std::vector<Marker>& flags) {
        const auto found = located(flags);
        return found ? "" : found.error().reason;
    };
    const auto flags = flags_of(beach, corners, true);
    EXPECT_NE(reason({flags[0]}).find("only one"), std::string::npos);
    EXPECT_NE(reason({}).find("none"), std::string::npos);
    EXPECT_NE(reason({flags[0], flags[0]}).find("one place on the canvas"), std::string::npos);
    auto still = flags;
    for (Marker& flag : still) flag.measured = flags[0].measured;
    EXPECT_NE(reason(still).find("measured at one place"), std::string::npos);
    auto mixed = flags;
    mixed[1].measured = Point{1, 2};
    EXPECT_NE(reason(mixed).find("geographic"), std::string::npos);
    auto square = flags_of(beach, corners, false);  // mirrored: all turns are as good
    std::swap(square[1].measured, square[3].measured);
    EXPECT_NE(reason(square).find("no direction"), std::string::npos);
}

TEST(Markers, AreReadFromCsvWithUnits) {
    const auto read = read_markers(
        "# beach\nname, y, x, latitude, longitude, radius, "
        "note\nsw,0,0,47.1,8.5,,wet\n\n,2m,50cm,47.2,8.6,30cm,\n"
        "pole,,,47.3,8.7,0.5,\n",
        "flags.csv");
    ASSERT_TRUE(read) << sentence(read.error());
    ASSERT_EQ(read->size(), 3u);
    EXPECT_EQ((*read)[1].name, "2");
    EXPECT_EQ((*read)[1].canvas, (Point{0.5, 2}));
    EXPECT_EQ((*read)[1].radius, 0.3);
    EXPECT_FALSE((*read)[2].canvas);
    EXPECT_EQ(std::get<Geographic>((*read)[2].measured), (Geographic{47.3, 8.7}));
}

TEST(Markers, AWrongLineIsNamed) {
    const auto refused = [](const std::string& csv) {
        const auto read = read_markers(csv, "flags.csv");
        return read ? "" : sentence(read.error());
    };
    EXPECT_NE(refused("name,x,y,latitude,longitude\na,0,0,97,8\n").find("line 2, latitude"),
              std::string::npos);
    EXPECT_NE(refused("name,x,y,latitude,longitude\na,0,,47,8\n").find("one of x and y"), std::string::npos);
    EXPECT_NE(refused("name,x,y\na,0,0\n").find("where the marker was measured"), std::string::npos);
    EXPECT_NE(refused("name,x,y,east,north\na,,,1,2\n").find("neither"), std::string::npos);
    EXPECT_NE(refused("name,x,y,east,north\na,0,0,1,two\n").find("line 2, north"), std::string::npos);
    EXPECT_NE(refused("name,x,y,east,north\na,0,0,1,2,3\n").find("more values"), std::string::npos);
    EXPECT_NE(refused("").find("no markers"), std::string::npos);
}

}  // namespace
}  // namespace strandline
