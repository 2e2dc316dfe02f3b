// Files -> grey pixels.
#include <random>

#include "pictures.hpp"

namespace strandline::trace {
namespace {

using namespace std::string_literals;

Picture read_well(const std::string& file) {
    auto picture = read_picture(file);
    if (!picture) {
        ADD_FAILURE() << sentence(picture.error());
        return {};
    }
    return *picture;
}
std::string refusal(const std::string& file, const Limits& limits = {}) {
    const auto picture = read_picture(file, limits);
    return picture ? "was read" : sentence(picture.error());
}
using Greys = std::vector<unsigned char>;

TEST(Format, IsKnownByTheFirstBytes) {
    EXPECT_EQ(format_of(png_file(1, 1, "\0"s)), "PNG");
    EXPECT_EQ(format_of(jpeg_file(1, 1, "\0"s)), "JPEG");
    EXPECT_EQ(format_of("GIF89a"), "GIF");
    EXPECT_EQ(format_of("RIFF1234WEBPVP8 "), "WebP");
    EXPECT_EQ(format_of("II*\0...."s), "TIFF");
    EXPECT_EQ(format_of("<svg xmlns='http://www.w3.org/2000/svg'/>"), "");
    EXPECT_EQ(format_of(""), "");
    EXPECT_EQ(format_of("\x89PN"), "");
    EXPECT_NE(refusal("GIF89a").find("GIF"), std::string::npos);
    EXPECT_NE(refusal("hello").find("not a picture"), std::string::npos);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
}

TEST(Png, GreysComeAsTheyAre) {
    const Picture picture = read_well(png_file(3, 2, "\0\x10\x20\x80\xf0\xff"s));
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.grey, (Greys{0, 0x10, 0x20, 0x80, 0xf0, 0xff}));
    EXPECT_FALSE(picture.size_metres);
    EXPECT_TRUE(picture.warnings.empty());
}
TEST(Png, ColoursAreWeighedAndTransparencyLiesOnWhite) {
    const Picture picture =
        read_well(png_file(4, 1, "\xff\0\0\xff\0\xff\0\xff\0\0\0\0\0\0\0\x80"s, {PNG_COLOR_TYPE_RGBA}));
    EXPECT_EQ(picture.grey, (Greys{54, 182, 255, 127}));
}
TEST(Png, AllDepthsAndPalettesAreRead) {
    EXPECT_EQ(read_well(png_file(8, 1, "\xa5"s, {PNG_COLOR_TYPE_GRAY, 1})).grey,
              (Greys{255, 0, 255, 0, 0, 255, 0, 255}));
    EXPECT_EQ(read_well(png_file(2, 1, "\x0f"s, {PNG_COLOR_TYPE_GRAY, 4})).grey, (Greys{0, 255}));
    EXPECT_EQ(read_well(png_file(2, 1, "\x80\0\xff\xff"s, {PNG_COLOR_TYPE_GRAY, 16})).grey,
              (Greys{128, 255}));
    EXPECT_EQ(read_well(png_file(2, 1, "\0\x01"s, {PNG_COLOR_TYPE_PALETTE})).grey, (Greys{255, 0}));
}
TEST(Png, InterlacedIsTheSamePicture) {
    std::string data;
    for (int i = 0; i < 19 * 13; ++i) data += static_cast<char>(7 * i);
    EXPECT_EQ(read_well(png_file(19, 13, data, {.interlaced = true})).grey,
              read_well(png_file(19, 13, data)).grey);
}
TEST(Png, ItsResolutionIsItsSize) {
    const auto size = read_well(png_file(3, 2, std::string(6, '\0'), {.pixels_per_metre = 1000})).size_metres;
    EXPECT_EQ(size, (Point{0.003, 0.001}));
}

TEST(Jpeg, GreyAndColourAreRead) {
    for (const unsigned char g : Greys{0, 77, 200, 255})
        EXPECT_NEAR(read_well(jpeg_file(16, 16, std::string(256, static_cast<char>(g)))).grey[100], g, 1);
    std::string red;
    for (int i = 0; i < 256; ++i) red += "\xff\0\0"s;
    EXPECT_NEAR(read_well(jpeg_file(16, 16, red, {.channels = 3})).grey[100], 54, 2);
}
TEST(Jpeg, InkOfPrintersIsRead) {
    // As Adobe stores it: 255 is no ink. Full cyan, half black.
    std::string inks;
    for (int i = 0; i < 256; ++i) inks += "\0\xff\xff\x80"s;
    EXPECT_NEAR(read_well(jpeg_file(16, 16, inks, {.channels = 4})).grey[100], (255 - 54) / 2, 3);
}
TEST(Jpeg, ItsResolutionIsItsSize) {
    const auto size =
        read_well(jpeg_file(300, 150, std::string(45000, '\0'), {.dots_per_inch = 300})).size_metres;
    ASSERT_TRUE(size);
    EXPECT_NEAR(size->x, 0.0254, 1e-12);
    EXPECT_NEAR(size->y, 0.0127, 1e-12);
}
TEST(Jpeg, APhotoTakenTurnedStandsUpright) {
    // Seen upright: 16 wide, 32 high, the upper left corner dark. Stored as each orientation stores it.
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const bool transposed = orientation >= 5;
        const unsigned w = transposed ? 32 : 16, h = transposed ? 16 : 32;
        const bool right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
        const bool below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
        std::string data;
        for (unsigned y = 0; y < h; ++y)
            for (unsigned x = 0; x < w; ++x)
                data += (right ? x >= w - 8 : x < 8) && (below ? y >= h - 8 : y < 8) ? '\0' : '\xff';
        const Picture picture = read_well(jpeg_file(w, h, data, {.orientation = orientation}));
        ASSERT_EQ(picture.width, 16) << orientation;
        ASSERT_EQ(picture.height, 32) << orientation;
        for (std::size_t y = 0; y < 32; ++y)
            for (std::size_t x = 0; x < 16; ++x)
                ASSERT_NEAR(picture.grey[16 * y + x], x < 8 && y < 8 ? 0 : 255, 4) << orientation;
    }
}

TEST(Damaged, WhatIsCutOffIsRefused) {
    std::string noise;
    for (int i = 0; i < 64 * 64; ++i) noise += static_cast<char>(i * i * 31);
    for (const std::string& file :
         {png_file(64, 64, noise), png_file(64, 64, noise, {.interlaced = true}), jpeg_file(64, 64, noise)})
        for (std::size_t keep = 8; keep < file.size() - 2; keep += 1 + file.size() / 50)
            EXPECT_NE(refusal(file.substr(0, keep)).find("cannot be read"), std::string::npos) << keep;
}
TEST(Damaged, AnyBytesGiveAPictureOrAnError) {
    std::mt19937 random(7);
    const std::string data(40 * 40, '\x55');
    for (const std::string& file : {png_file(40, 40, data), jpeg_file(40, 40, data, {.orientation = 6})})
        for (int k = 0; k < 2000; ++k) {
            std::string broken = file;
            for (unsigned i = 0; i < 1 + random() % 4; ++i)
                broken[8 + random() % (broken.size() - 8)] = static_cast<char>(random());
            const auto picture = read_picture(broken, {.pixels = 1'000'000});
            if (picture) {
                EXPECT_EQ(picture->grey.size(), std::size_t(picture->width) * std::size_t(picture->height));
            }
        }
}
TEST(Damaged, TooManyPixelsAreRefusedBeforeTheyAreRead) {
    const std::string white(200 * 100, '\xff');
    EXPECT_NE(refusal(png_file(200, 100, white), {.pixels = 19'999}).find("200 x 100 pixels"),
              std::string::npos);
    EXPECT_NE(refusal(jpeg_file(200, 100, white), {.pixels = 19'999}).find("200 x 100 pixels"),
              std::string::npos);
    EXPECT_EQ(refusal(png_file(200, 100, white), {.pixels = 20'000}), "was read");
}

}  // namespace
}  // namespace strandline::trace
