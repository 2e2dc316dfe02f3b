#include <gtest/gtest.h>

#include "plan/model/model.hpp"

namespace strandline {
namespace {

TEST(Settings, EverySettingReadsBackWhatItPrints) {
    const Options defaults;
    for (const Setting& setting : settings()) {
        Options options;
        const std::string text = get(defaults, setting.key);
        const auto done = set(options, setting.key, text);
        ASSERT_TRUE(done) << setting.key << " = " << text << ": " << sentence(done.error());
        EXPECT_EQ(get(options, setting.key), text) << setting.key;
    }
}

TEST(Settings, AllOfThemInTheTablesOrderReadBackTheSameOptions) {
    // A value switches its own use on; the switch itself comes after it in the table and has the last word.
    Options wished, read;
    wished.place.x = 3;
    wished.fill.direction = 1;
    for (const Setting& setting : settings()) ASSERT_TRUE(set(read, setting.key, get(wished, setting.key)));
    EXPECT_EQ(read, wished);
}

TEST(Settings, GivingAValueSwitchesItOn) {
    Options options;
    ASSERT_TRUE(set(options, "fill.direction", "45"));
    EXPECT_FALSE(options.fill.best_direction);
    ASSERT_TRUE(set(options, "place.x", "1m"));
    EXPECT_TRUE(options.place.positioned);
    ASSERT_TRUE(set(options, "tour.start_y", "1m"));
    EXPECT_TRUE(options.tour.has_start);
}

TEST(Settings, KeysAreUniqueAndExplained) {
    std::vector<std::string> keys;
    for (const Setting& setting : settings()) {
        EXPECT_FALSE(setting.meaning.empty()) << setting.key;
        keys.push_back(setting.key);
    }
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST(Settings, LengthsTakeUnitsAndAnglesDegrees) {
    Options options;
    ASSERT_TRUE(set(options, "fill.spacing", "16cm"));
    EXPECT_DOUBLE_EQ(options.fill.spacing, 0.16);
    ASSERT_TRUE(set(options, "corner.threshold", "45"));
    EXPECT_DOUBLE_EQ(options.corner.threshold, pi / 4);
}

TEST(Settings, AWrongValueIsRefusedByNameWithItsRange) {
    Options options;
    const auto too_long = set(options, "trajectory.step", "0.2m");
    ASSERT_FALSE(too_long);
    EXPECT_EQ(too_long.error().place, "trajectory.step");
    EXPECT_NE(too_long.error().remedy.find("0.05"), std::string::npos);
    const auto style = set(options, "fill.style", "swirl");
    ASSERT_FALSE(style);
    EXPECT_NE(style.error().remedy.find("zigzag"), std::string::npos);
    EXPECT_FALSE(set(options, "tour.seed", "1.5"));
    EXPECT_FALSE(set(options, "canvas.width", "nan"));
    EXPECT_FALSE(set(options, "canvas.width", "14 parsec"));
    EXPECT_EQ(options, Options{});
}

TEST(Settings, AMisspeltKeyGetsTheNearestOne) {
    Options options;
    const auto done = set(options, "fil.spacing", "1");
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().remedy.find("fill.spacing"), std::string::npos);
}

}  // namespace
}  // namespace strandline
