#include "exports/drive.hpp"
#include "result/exports/exports.hpp"

namespace strandline {
namespace {

using namespace testing;

std::string written(const Plan& plan) {
    const auto text = exports::gcode(plan);
    EXPECT_TRUE(text) << (text ? "" : sentence(text.error()));
    return text ? text->files.at(0).bytes : "";
}

TEST(Gcode, ReadBackItIsWhatTheToolDraws) {
    const Plan plan = beach_plan();
    expect_same(only_down(read_gcode(written(plan)).tracks), only_down(tracks_of(plan, true)), millimetre);
}

TEST(Gcode, TheToolGoesAlongTheMiddleOfTheStrokesPins) {
    Plan plan = beach_plan();
    const auto places = [&] { return only_down(read_gcode(written(plan)).tracks); };
    const auto before = places();
    for (Stroke& stroke : plan.strokes) stroke.pins = 2;
    const auto after = places();
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k)
        EXPECT_NEAR(distance(before[k].points.front(), after[k].points.front()), 0.03, 0.001) << k;
}

TEST(Gcode, EveryStrokeGoesDownOnceAndUpOnce) {
    const Program program = read_gcode(written(beach_plan()));
    EXPECT_EQ(std::ranges::count(program.others, "G1 Z0 F600"), 4);
    EXPECT_EQ(std::ranges::count(program.others, "G0 Z5"), 5) << "begin, four strokes, the last one by end";
    EXPECT_EQ(program.others.front(), "G21");
    EXPECT_EQ(program.others.back(), "M2");
}

TEST(Gcode, StopsAreBlocksBetweenStrokesToolUp) {
    Plan plan = beach_plan();
    plan.drawing.elements[1].layer = "gold (thin)";
    plan.options.gcode.stop = "T{tool} M6\\n(load {why}, {layer})";
    const auto lines = lines_of(written(plan));
    const auto change = std::ranges::find(lines, "T2 M6");
    ASSERT_NE(change, lines.end());
    EXPECT_EQ(*std::prev(change), "G0 Z5");
    EXPECT_EQ(*std::next(change), "(load tool 2, gold  thin )") << "no bracket within a comment";
    EXPECT_TRUE(std::next(change, 2)->starts_with("G0 X"));
}

TEST(Gcode, TemplatesAndFeedAreTheUsers) {
    Plan plan = beach_plan();
    plan.options.gcode.begin = "G21\\n({title})\\n{up}";
    plan.options.gcode.up = "M5";
    plan.options.gcode.down = "M3 S90 F{feed}";
    plan.options.gcode.feed = 1500;
    const std::string text = written(plan);
    EXPECT_TRUE(
        text.starts_with("G21\n(two lines and a \"door\" <é>)\nM5\nG0 X2000.000 Y2000.000\nM3 S90 "
                         "F1500\nG1 X6000.000 Y2000.000 F1500\nM5\n"))
        << text.substr(0, 200);
}

TEST(Gcode, TheLastStrokeIsLiftedOnceUnlessTheEndMovesFirst) {
    Plan plan = beach_plan();
    const auto last_lines = [&plan](const std::string& end) {
        plan.options.gcode.end = end;
        const auto lines = lines_of(written(plan));
        std::string last;
        for (auto line = std::prev(lines.end(), 4); line != lines.end(); ++line)
            last += (line->starts_with("G1 X") ? "G1" : *line) + "|";
        return last;
    };
    EXPECT_EQ(last_lines("{up}\\nM2"), "G1 Z0 F600|G1|G0 Z5|M2|");
    EXPECT_EQ(last_lines("M2"), "G1 Z0 F600|G1|G0 Z5|M2|");
    EXPECT_EQ(last_lines("G0 X0\\n{up}"), "G1|G0 Z5|G0 X0|G0 Z5|") << "nothing is dragged";
}

TEST(Gcode, AWrongTemplateIsRefusedByName) {
    Plan plan = beach_plan();
    plan.options.gcode.down = "G1 Z{depth}";
    const auto refused = exports::gcode(plan);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place, "gcode.down");
    EXPECT_NE(refused.error().reason.find("depth"), std::string::npos);
    plan.options.gcode.down = "G1 {feed";
    EXPECT_FALSE(exports::gcode(plan));
}

}  // namespace
}  // namespace strandline
