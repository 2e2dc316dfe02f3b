// Pictures as input: strandline trace, and plan.
#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace strandline::test {
namespace {

using namespace std::string_literals;

unsigned crc(const std::string& bytes) {
    unsigned sum = ~0U;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int k = 0; k < 8; ++k) sum = sum >> 1U ^ (sum & 1U ? 0xEDB88320U : 0U);
    }
    return ~sum;
}
std::string big_endian(unsigned value) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(value >> shift & 0xFFU);
    return bytes;
}
std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<unsigned>(data.size())) + type + data + big_endian(crc(type + data));
}
/// Grey pixels, in a deflate block that is stored as it is (RFC 1950 and 1951).
std::string png(unsigned width, unsigned height, const std::string& pixels) {
    std::string raw;
    for (unsigned y = 0; y < height; ++y) raw += '\0' + pixels.substr(y * width, width);
    unsigned a = 1, b = 0;
    for (const char byte : raw) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<unsigned>(raw.size());
    const auto low = static_cast<char>(size & 0xFFU), high = static_cast<char>(size >> 8U);
    const std::string stored = "\x78\x01\x01"s + low + high + static_cast<char>(~low) +
                               static_cast<char>(~high) + raw + big_endian(b << 16U | a);
    return "\x89PNG\r\n\x1a\n"s + chunk("IHDR", big_endian(width) + big_endian(height) + "\x08\0\0\0\0"s) +
           chunk("IDAT", stored) + chunk("IEND", "");
}
/// 40 x 30, white, with a black square of 10 at (5, 5).
std::string square() {
    std::string pixels(40 * 30, '\xff');
    for (std::size_t y = 5; y < 15; ++y) pixels.replace(40 * y + 5, 10, 10, '\0');
    return png(40, 30, pixels);
}

TEST(Picture, IsTracedToSvg) {
    const Folder folder;
    write(folder / "in.png", square());
    const Result traced = run(folder, "trace in.png --set trace.alphamax=0 -o out.svg");
    ASSERT_EQ(traced.exit, 0) << traced.err;
    EXPECT_NE(traced.err.find("40 x 30 pixels, threshold 0.500 (found): 1 region, 0 holes"),
              std::string::npos)
        << traced.err;
    const std::string svg = read(folder / "out.svg");
    EXPECT_NE(svg.find("viewBox=\"0 0 40 30\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("id=\"region.1\""), std::string::npos) << svg;
    EXPECT_NE(run(folder, "trace in.png --invert --json -o out.svg").out.find("\"holes\":1"),
              std::string::npos);
}
TEST(Picture, IsPlannedWhateverItsNameSays) {
    const Folder folder;
    write(folder / "in.svg", square());
    ASSERT_EQ(run(folder, "plan in.svg -o plan.json --json").exit, 0);
    const Result piped = run(folder, "plan - --json -o plan.json < in.svg");
    EXPECT_EQ(piped.exit, 0) << piped.err;
    EXPECT_NE(piped.out.find("\"regions\": 1"), std::string::npos) << piped.out;
    EXPECT_EQ(run(folder, "plan in.svg --invert -o plan.json").exit, 0);
    EXPECT_EQ(run(folder, "check plan.json").exit, 0);
}
TEST(Picture, WhatIsWrongIsSaidAndNothingIsWritten) {
    const Folder folder;
    write(folder / "in.png", square());
    write(folder / "cut.png", square().substr(0, 400));
    write(folder / "white.png", png(40, 30, std::string(40 * 30, '\xff')));
    write(folder / "gif.png", "GIF89a........");
    write(folder / "empty.png", "");
    const auto refused = [&](const std::string& arguments, int code, const std::string& words) {
        expect_refused(folder, arguments, code, words);
    };
    for (const char* command : {"plan ", "trace "}) {
        refused(command + "cut.png -o out"s, 1, "cut.png: is a PNG picture that cannot be read");
        refused(command + "white.png -o out"s, 1, "white.png: the picture is all one colour");
        refused(command + "gif.png -o out"s, 1, "gif.png: is a GIF picture");
        refused(command + "empty.png -o out"s, 1, "empty.png: ");
        refused(command + "in.png -o out --set trace.threshold=2"s, 2, "trace.threshold");
        refused(command + "in.png -o out --set trace.despeckle=100"s, 1, "specks");
        refused(command + "in.png -o in.png"s, 2, "in.png");
    }
    EXPECT_EQ(read(folder / "in.png"), square());
}

}  // namespace
}  // namespace strandline::test
