// All fonts of Debian's hershey-fonts-data, where the package is installed.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "input/lettering/lettering.hpp"

namespace strandline::lettering {
namespace {

namespace fs = std::filesystem;

std::vector<Font> all_fonts() {
    std::vector<Font> fonts;
    if (!fs::is_directory(STRANDLINE_HERSHEY_FONTS)) return fonts;
    for (const auto& entry : fs::directory_iterator(STRANDLINE_HERSHEY_FONTS)) {
        if (entry.path().extension() != ".jhf") continue;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(file), {});
        const auto font = read_font(bytes, entry.path().stem().string());
        EXPECT_TRUE(font) << (font ? "" : sentence(font.error()));
        if (font) fonts.push_back(*font);
    }
    return fonts;
}

TEST(Hershey, All32FontsAreRead) {
    const std::vector<Font> fonts = all_fonts();
    if (fonts.empty()) GTEST_SKIP() << "hershey-fonts-data is not installed";
    EXPECT_EQ(fonts.size(), 32U);
    for (const Font& font : fonts) {
        EXPECT_EQ(font.glyphs.size(), font.name == "japanese" ? 193U : font.name == "markers" ? 97U : 96U);
        // Hershey drew his letters 21 units high, on lines at -12 and 9; sets of signs are smaller.
        const double height = font.name == "markers" || font.name == "symbolic" ? 12
                              : font.name == "mathlow"                          ? 14
                                                                                : 21;
        EXPECT_EQ(font.base_line - font.cap_line, height) << font.name;
    }
}
TEST(Hershey, EveryCharacterOfAsciiIsKnownToEveryFont) {
    std::string all;
    for (char c = ' '; c <= '~'; ++c) all += c;
    for (const Font& font : all_fonts()) {
        const auto document = lettered(all, font, {});
        ASSERT_TRUE(document) << font.name;
        EXPECT_TRUE(document->warnings.empty()) << font.name;
    }
}

}  // namespace
}  // namespace strandline::lettering
