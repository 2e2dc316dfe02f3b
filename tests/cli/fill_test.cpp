// strandline fill, and what fills a plan.
#include <gtest/gtest.h>

#include "program.hpp"

namespace strandline::test {
namespace {

const std::string hall =
    R"({"width": 0.4, "polygon": {"outer": [[0, 0], [10, 0], [10, 6], [0, 6]], "holes": []}})";

TEST(Fill, SegmentsOfAZigzagHaveTheirOwnStyle) {
    const Folder folder;
    write(folder / "hall.json", hall);
    const std::string call = "fill hall.json --style zigzag --cuts '5,-1 5,7' -o ";
    EXPECT_EQ(run(folder, call + "lines.json").exit, 0);
    const Result made = run(folder, call + "rings.json --segments '8m,3 style=rings'");
    EXPECT_EQ(made.exit, 0) << made.err;
    EXPECT_EQ(made.err.find("warning"), std::string::npos) << made.err;
    EXPECT_NE(read(folder / "rings.json"), read(folder / "lines.json"));
    EXPECT_NE(run(folder, call + "x.json --segments '18,3 style=rings'").err.find("choice 1"),
              std::string::npos);
    EXPECT_NE(run(folder, "fill hall.json --style zigzag --cuts '1,1 2,1' -o x.json").err.find("cut 1"),
              std::string::npos);
    EXPECT_NE(run(folder, "fill hall.json --style spiral --join nearest -o x.json").err.find("--join"),
              std::string::npos);
    expect_refused(folder, call + "out --segments '8,3 style=swirl'", 2, "--segments: segment 1");
}

/// A plate of 100 x 60 in a file.
void write_plate(const Folder& folder) {
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='60'><rect id='r' width='100' "
          "height='60'/></svg>");
}

TEST(Fill, WrongCutsSegmentsAndSpacingsOfAPlanAreRefused) {
    const Folder folder;
    write_plate(folder);
    const std::string call = "plan in.svg -o out --set fill.style=zigzag --set ";
    expect_refused(folder, call + "'fill.segments=1,1 style=swirl'", 2, "fill.segments");
    expect_refused(folder, call + "'fill.cuts=1,1'", 2, "fill.cuts");
    expect_refused(folder, call + "fill.spacing=5m", 2, "fill.spacing");
    expect_refused(folder, call + "fill.spacing=30cm --rule 'id=r: fill-cuts=1,1'", 2, "fill-cuts");
    expect_refused(folder, call + "fill.spacing=30cm --rule 'id=r: fill-spacing=5m'", 2, "fill-spacing");
    EXPECT_EQ(run(folder, call + "fill.spacing=42cm").exit, 0);
}

TEST(Fill, StrictSaysWhyItEndsWithThree) {
    const Folder folder;
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><polygon points='50,5 60,35 93,36 "
          "67,56 76,86 50,68 24,86 33,56 7,36 39,35'/></svg>");
    const Result made =
        run(folder, "plan in.svg -q --strict -o plan.json --set fill.join=nearest --set fill.style=zigzag");
    EXPECT_EQ(made.exit, 3);
    EXPECT_NE(made.err.find("strict: 1 thing is done otherwise"), std::string::npos) << made.err;
    EXPECT_NE(made.err.find("strict: along"), std::string::npos) << made.err;
    const Result all = run(folder, "check -v plan.json");
    EXPECT_NE(all.out.find("not drivable: at ("), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("bare as driven: "), std::string::npos) << all.out;
    // The plan's warnings are read elsewhere too: the program alone speaks of its switch.
    EXPECT_NE(run(folder, "check plan.json").out.find("places of the warnings: -v lists all"),
              std::string::npos);
    EXPECT_EQ(all.out.find("-v lists all"), std::string::npos) << all.out;
    EXPECT_EQ(read(folder / "plan.json").find("-v lists"), std::string::npos);
}

TEST(Fill, AnAreaThatIsLeftBareIsNamedWithTheChoiceThatLeavesIt) {
    const Folder folder;
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='2'><rect id='r' width='100' "
          "height='2'/></svg>");
    expect_refused(folder, "plan in.svg -o out --set fill.narrow=warn", 1, "narrow=warn");
    expect_refused(folder, "plan in.svg -o out --set fill.narrow=warn", 1, "(r: is 0.26 to 0.26 m wide");
}

}  // namespace
}  // namespace strandline::test
