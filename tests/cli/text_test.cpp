// strandline text, and plan --text.
#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace strandline::test {
namespace {

/// A font of one glyph at A: a bar of 21 units.
std::string bar_font() {
    std::string text;
    for (int i = 0; i < 33; ++i) text += "    1  1OU\n";
    return text + "    2  3MWRFR[\n";
}

TEST(Text, IsAnSvgOfTrueSize) {
    const Folder folder;
    write(folder / "bar.jhf", bar_font());
    const Result made = run(folder, R"(text "A\nA" --font bar.jhf --height 21cm --line-spacing 2 -o a.svg)");
    ASSERT_EQ(made.exit, 0) << made.err;
    const std::string svg = read(folder / "a.svg");
    EXPECT_NE(svg.find("width=\"1mm\" height=\"631mm\" viewBox=\"0 0 1 631\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("id=\"t.2.1.A.1\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("d=\"M0.5 420.5L0.5 630.5\""), std::string::npos) << svg;
    EXPECT_NE(made.err.find("2 strokes, 0.001 m x 0.631 m"), std::string::npos) << made.err;
    EXPECT_NE(run(folder, "text AA --font bar.jhf --json -o a.svg").out.find("\"strokes\":2"),
              std::string::npos);
}
TEST(Text, RealNewlinesAndStdinAreTheSame) {
    const Folder folder;
    write(folder / "bar.jhf", bar_font());
    write(folder / "words", "A\nA");
    const std::string typed = run(folder, R"(text "A\nA" --font bar.jhf)").out;
    EXPECT_EQ(run(folder, "text \"A\nA\" --font bar.jhf").out, typed);
    EXPECT_EQ(run(folder, "text - --font bar.jhf < words").out, typed);
    EXPECT_NE(run(folder, R"(text 'A\\nA' --font bar.jhf)").out, typed);  // a backslash and an n
}
TEST(Text, IsPlannedAtItsHeight) {
    const Folder folder;
    write(folder / "bar.jhf", bar_font());
    const Result actual = run(folder, "plan --text A --font bar.jhf --height 2m -o plan.json --json");
    ASSERT_EQ(actual.exit, 0) << actual.err;
    EXPECT_NE(actual.out.find("\"drawn\": 2,"), std::string::npos) << actual.out;
    const Result fitted = run(folder, "plan --text A --font bar.jhf -o plan.json --json");
    ASSERT_EQ(fitted.exit, 0) << fitted.err;
    EXPECT_NE(fitted.out.find("\"scale\": 0.013"), std::string::npos) << fitted.out;
}
TEST(Text, WhatIsWrongIsSaidAndNothingIsWritten) {
    const Folder folder;
    write(folder / "bar.jhf", bar_font());
    write(folder / "not.jhf", "root:x:0\n");
    const auto refused = [&](const std::string& arguments, int code, const std::string& words) {
        expect_refused(folder, arguments, code, words);
    };
    refused("text -o out", 2, "missing");
    refused("text B --font bar.jhf -o out", 1, "\"B\"");
    refused("text A --font not.jhf -o out", 1, "not.jhf, line 1");
    refused("text A --font gone.jhf -o out", 1, "gone.jhf");
    refused("text A --font bar.jhf --height tall -o out", 2, "--height");
    refused("text A --font bar.jhf --height 0 -o out", 1, "height");
    refused("plan --text B --font bar.jhf -o out", 1, "\"B\"");
    refused("plan -o out", 2, "--text");
    refused("plan --text A in.svg -o out", 2, "in.svg");
}
TEST(Text, OfAnSvgIsOutlinedOrLeftOutByName) {
    const Folder folder;
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><text x='10' y='80' font-size='90' "
          "font-weight='bold' font-family='No Such Font'>I</text><path d='M0 0V100' stroke='black'/></svg>");
    const Result set = run(folder, "plan in.svg -o plan.json --json");
    ASSERT_EQ(set.exit, 0) << set.err;
    EXPECT_NE(set.err.find("No Such Font is not on this machine"), std::string::npos) << set.err;
    EXPECT_NE(set.out.find("\"elements\": 2"), std::string::npos) << set.out;
    const Result left_out = run(folder, "plan in.svg -o plan.json --json --set text.substitutes=off");
    EXPECT_NE(left_out.err.find("text is left out: the font No Such Font"), std::string::npos)
        << left_out.err;
    EXPECT_NE(left_out.out.find("\"elements\": 1"), std::string::npos) << left_out.out;
}
TEST(Text, AbsentFontsAreAMissingPackage) {
    const Folder folder;
    const std::string program = "'" STRANDLINE_PROGRAM "'";
    for (const char* arguments : {"text A", "text --list", "plan --text A"}) {
        const Result result =
            run(folder, "--version >/dev/null; STRANDLINE_FONTS=/nowhere " + program + " " + arguments);
        EXPECT_EQ(result.exit, 1) << result.err;
        EXPECT_NE(result.err.find("hershey-fonts-data"), std::string::npos) << result.err;
    }
}

}  // namespace
}  // namespace strandline::test
