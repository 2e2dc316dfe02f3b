// The drawings of the project's own, and those of 2014 where they are at hand, from file to elements.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

Outcome<Drawing> drawing_of(const std::string& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    const auto read = svg::read(text.str());
    if (!read) return tl::unexpected(read.error());
    return make_drawing(*read, beachbot(), {});
}

struct Expected {
    const char* name;
    int lines, closed, regions, holes, inside, joined;
};

void expect_drawing(const std::string& folder, const Expected& expected) {
    const auto drawing = drawing_of(folder + "/" + expected.name + ".svg");
    ASSERT_TRUE(drawing) << expected.name << ": " << sentence(drawing.error());
    int lines = 0, closed = 0, regions = 0, holes = 0, inside = 0;
    for (const Element& element : drawing->elements) {
        inside += element.inside >= 0;
        if (const auto* line = std::get_if<LineElement>(&element.what)) {
            ++lines;
            closed += line->path.closed;
        } else {
            ++regions;
            holes += static_cast<int>(std::get<RegionElement>(element.what).region.holes.size());
        }
    }
    EXPECT_EQ(lines, expected.lines) << expected.name;
    EXPECT_EQ(closed, expected.closed) << expected.name;
    EXPECT_EQ(regions, expected.regions) << expected.name;
    EXPECT_EQ(holes, expected.holes) << expected.name;
    EXPECT_EQ(inside, expected.inside) << expected.name;
    EXPECT_EQ(drawing->counts.joined, expected.joined) << expected.name;
    EXPECT_TRUE(drawing->warnings.empty()) << expected.name;
    // Nothing outside the margin, and two sides of it touched.
    const Box box = bounds(*drawing);
    EXPECT_NEAR(std::max(box.width(), box.height()), 13, 0.004) << expected.name;
    EXPECT_GE(std::min(box.low.x, box.low.y), 0.5 - 1e-6) << expected.name;
    EXPECT_LE(std::max(box.high.x, box.high.y), 13.5 + 1e-6) << expected.name;
}

TEST(Drawings, OurOwnHaveTheElementsTheyShow) {
    for (const Expected& expected :
         {Expected{"crab", 13, 2, 3, 1, 0, 0}, Expected{"hello", 7, 1, 0, 0, 0, 1},
          Expected{"labyrinth", 2, 0, 0, 0, 0, 12}, Expected{"lighthouse", 12, 5, 4, 0, 3, 0},
          Expected{"mandala", 118, 54, 17, 0, 134, 0}, Expected{"shells", 5, 4, 2, 5, 4, 0},
          Expected{"starfish", 11, 6, 1, 1, 6, 0}, Expected{"sun", 8, 0, 9, 3, 0, 0},
          Expected{"waves", 12, 0, 0, 0, 0, 0}})
        expect_drawing(STRANDLINE_SOURCE "/drawings", expected);
}

TEST(Drawings, TheLighthouseMarksItsStart) {
    const auto drawing = drawing_of(STRANDLINE_SOURCE "/drawings/lighthouse.svg");
    ASSERT_TRUE(drawing);
    ASSERT_TRUE(drawing->start);
    EXPECT_LT(drawing->start->y, 1);
}

TEST(Drawings, ThoseOf2014HaveTheirLinesAndFills) {
    const std::string folder = STRANDLINE_SHARED "/drawings";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared drawings here";
    for (const Expected& expected :
         {Expected{"lion_example", 12, 0, 0, 0, 0, 0}, Expected{"shark_test", 16, 0, 0, 0, 0, 0},
          Expected{"asl_logo", 0, 0, 4, 0, 0, 0}, Expected{"flower_example", 4, 3, 1, 0, 1, 0},
          Expected{"floral_patterns", 90, 0, 0, 0, 0, 0}})
        expect_drawing(folder, expected);
}

}  // namespace
}  // namespace strandline
