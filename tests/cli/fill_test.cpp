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
    expect_refused(folder, call + "out --segments '8,3 style=swirl'", 2, "--segments: segment 1");
}
TEST(Fill, AWrongSegmentOfAPlanIsNamedAndLeftOut) {
    const Folder folder;
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='60'><rect id='r' width='100' "
          "height='60'/></svg>");
    const Result made = run(folder,
                            "plan in.svg -o plan.json --set fill.style=zigzag --set "
                            "'fill.segments=1,1 style=swirl'");
    EXPECT_EQ(made.exit, 0) << made.err;
    EXPECT_NE(made.err.find("r, fill.segments"), std::string::npos) << made.err;
}

}  // namespace
}  // namespace strandline::test
