// A square of 100 mm, in all the ways that files state it, is 100 mm on the ground under --place actual.
#include <gtest/gtest.h>

#include "input/drawing/drawing.hpp"

namespace strandline {
namespace {

struct Sized {
    double width = 0, height = 0;  ///< metres
    std::string warnings;
};
Sized actual(const std::string& text, double dpi = 0) {
    const auto document = svg::read(text, {.dpi = dpi});
    if (!document) {
        ADD_FAILURE() << sentence(document.error()) << text;
        return {};
    }
    DrawingOptions options = options_for({0.42, 0.297});
    options.canvas = {0.42, 0.297};
    options.place = Place::actual;
    const auto drawing = make_drawing(*document, *builtin_robot("plotter"), options);
    if (!drawing) {
        ADD_FAILURE() << sentence(drawing.error()) << text;
        return {};
    }
    Box box;
    for (const auto& element : drawing->elements) box = united(box, bounds(element));
    Sized sized{box.width(), box.height(), {}};
    for (const auto& warning : drawing->warnings) sized.warnings += sentence(warning) + "\n";
    return sized;
}
constexpr double tenth = 0.1, hundredth_mm = 1e-5;

void expect_100_mm(const std::string& root, const std::string& width, double dpi = 0,
                   const std::string& style = "fill:none;stroke:#000;stroke-width:0.1") {
    const std::string text = "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='urn:i' " + root +
                             "><rect width='" + width + "' height='" + width + "' style='" + style +
                             "'/></svg>";
    const auto sized = actual(text, dpi);
    EXPECT_NEAR(sized.width, tenth, hundredth_mm) << text;
    EXPECT_NEAR(sized.height, tenth, hundredth_mm) << text;
}

TEST(Sizes, MillimetresWithAndWithoutViewBox) {
    expect_100_mm("width='200mm' height='200mm'", "100mm");
    expect_100_mm("width='200mm' height='200mm' viewBox='0 0 200 200'", "100");
    expect_100_mm("width='20cm' height='20cm' viewBox='0 0 1000 1000'", "500");
    expect_100_mm("width='100mm' height='100mm' viewBox='-50 -50 10 10'", "10");
    expect_100_mm("", "100mm");
}

TEST(Sizes, PixelsOf72And90And96Dpi) {
    expect_100_mm("width='500' height='500'", "377.952756");
    expect_100_mm("width='500px' height='500px' viewBox='0 0 500 500'", "377.952756");
    expect_100_mm("width='500' height='500'", "354.330709", 90);
    expect_100_mm("width='500' height='500' viewBox='0 0 500 500'", "354.330709", 90);
    expect_100_mm("width='500' height='500'", "283.464567", 72);
    expect_100_mm("viewBox='0 0 500 500'", "283.464567", 72);
    expect_100_mm("viewBox='0 0 500 500'", "377.952756");
    expect_100_mm("", "377.952756", 96);
}

TEST(Sizes, UnitsInsideFollowTheDpiToo) {
    expect_100_mm("width='200mm' height='200mm'", "100mm", 90);
    expect_100_mm("width='200mm' height='200mm'", "10cm", 72);
    expect_100_mm("width='10in' height='10in'", "283.464567pt", 90);
}

TEST(Sizes, PointsPicasInchesAndQuarters) {
    expect_100_mm("width='500pt' height='500pt'", "283.464567pt");
    expect_100_mm("width='500pt' height='500pt' viewBox='0 0 500 500'", "283.464567");
    expect_100_mm("width='40pc' height='40pc'", "23.6220472pc");
    expect_100_mm("width='10in' height='10in' viewBox='0 0 10 10'", "3.93700787");
    expect_100_mm("width='400Q' height='400Q'", "400Q");
}

TEST(Sizes, PercentOfThePage) {
    expect_100_mm("width='200mm' height='200mm'", "50%");
    expect_100_mm("width='200mm' height='200mm' viewBox='0 0 7 7'", "50%");
    expect_100_mm("width='100%' height='100%' viewBox='0 0 755.905512 755.905512'", "50%");
}

TEST(Sizes, ThePagesAspectIsFollowed) {
    // meet: the smaller scale of both; slice: the larger; none: each its own
    expect_100_mm("width='400mm' height='200mm' viewBox='0 0 100 100'", "50");
    expect_100_mm("width='400mm' height='200mm' viewBox='0 0 100 100' preserveAspectRatio='xMidYMid slice'",
                  "25");
    const auto stretched = actual(
        "<svg width='200mm' height='100mm' viewBox='0 0 100 100' preserveAspectRatio='none'>"
        "<rect width='50' height='100' fill='none' stroke='#000' stroke-width='0.1'/></svg>");
    EXPECT_NEAR(stretched.width, tenth, hundredth_mm);
    EXPECT_NEAR(stretched.height, tenth, hundredth_mm);
}

TEST(Sizes, OldInkscapesCountNinetyAndSaySo) {
    const auto file = [](const std::string& version) {
        return "<svg width='500' height='500' inkscape:version='" + version +
               "'><rect width='354.330709' height='354.330709' fill='none' stroke='#000' "
               "stroke-width='0.1'/></svg>";
    };
    for (const char* version : {"0.48.4 r9939", "0.91 r13725", "0.45.1"}) {
        const auto sized = actual(file(version));
        EXPECT_NEAR(sized.width, tenth, hundredth_mm) << version;
        EXPECT_NE(sized.warnings.find("its px are taken as 90 to the inch"), std::string::npos) << version;
    }
    EXPECT_NEAR(actual(file("0.92.4 (5da689c, 2019)")).width, 0.09375, hundredth_mm);
    EXPECT_NEAR(actual(file("1.3 (0e150ed, 2023)")).width, 0.09375, hundredth_mm);
    EXPECT_NEAR(actual(file("0.48"), 96).width, 0.09375, hundredth_mm);
    EXPECT_EQ(actual(file("0.48"), 96).warnings, "");
}

TEST(Sizes, IllustratorsPixelsAreAHintNotAGuess) {
    const std::string file =
        "<!-- Generator: Adobe Illustrator 27.0 --><svg width='500px' height='500px'>"
        "<rect width='377.952756' height='377.952756' fill='none' stroke='#000' stroke-width='0.1'/></svg>";
    EXPECT_NEAR(actual(file).width, tenth, hundredth_mm);
    EXPECT_NE(actual(file).warnings.find("--dpi 72"), std::string::npos);
    EXPECT_NEAR(actual(file, 72).width, tenth * 96 / 72, hundredth_mm);
}

}  // namespace
}  // namespace strandline
