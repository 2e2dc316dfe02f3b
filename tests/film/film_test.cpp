#include "result/film/film.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"

namespace strandline::film {
namespace {

const shade::View view{{{3, 2}, {11, 8}}, 160};
surface::Drive drive_by_hand() {
    const Plan plan = by_hand::raked_plan();
    return {plan.robot, plan.samples, {}};
}

TEST(Film, FramesPutOneOverTheOtherAreThePictures) {
    // What a viewer sees who only ever gets what changed.
    shade::Image seen;
    int frames = 0;
    for_frames(drive_by_hand(), view, {.cell = 0.02, .seconds = 3, .rate = 8}, [&](const Frame& frame) {
        if (frames++ == 0) seen = frame.image;
        for (int row = frame.top; row < frame.bottom; ++row)
            for (int column = frame.left; column < frame.right; ++column)
                seen.at(column, row) = frame.image.at(column, row);
        EXPECT_EQ(seen.pixels, frame.image.pixels) << frames;
        return true;
    });
    EXPECT_EQ(frames, 25);
}

TEST(Film, TheLastPictureIsTheSandWithoutTheRobot) {
    const surface::Drive drive = drive_by_hand();
    shade::Image last;
    for_frames(drive, view, {.cell = 0.02, .seconds = 1, .rate = 4}, [&](const Frame& frame) {
        if (frame.last) last = frame.image;
        return true;
    });
    EXPECT_EQ(last.pixels, shade::sand(surface::laid(drive, {.cell = 0.02}), view).pixels);
}

TEST(Film, AGifBeginsAndEndsAsOneAndIsTheSameEachTime) {
    const Options options{.cell = 0.02, .seconds = 1, .rate = 4};
    const auto bytes = gif(drive_by_hand(), view, options);
    ASSERT_TRUE(bytes.has_value());
    EXPECT_EQ(bytes->substr(0, 6), "GIF89a");
    EXPECT_EQ(bytes->back(), ';');
    EXPECT_EQ(*bytes, *gif(drive_by_hand(), view, options));
}

TEST(Film, MorePixelsThanAGifHoldsAreRefused) {
    const auto bytes = gif({}, {{{0, 0}, {1, 1}}, 70'000}, {});
    ASSERT_FALSE(bytes.has_value());
    EXPECT_NE(bytes.error().remedy, "");
}

}  // namespace
}  // namespace strandline::film
