// The main job from the command line: SVG in, plan, robot text and picture out, checked.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "program.hpp"

namespace strandline::test {
namespace {

const std::string two_lines =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">
  <path id="a" d="M20 20 L100 20" stroke="black" stroke-width="2" fill="none"/>
  <path id="b" d="M20 80 C60 40 140 40 180 80" stroke="black" stroke-width="2" fill="none"/>
</svg>)";

TEST(MainJob, FromSvgToRobotTextAndPicture) {
    const Folder folder;
    write(folder / "in.svg", two_lines);
    const Result plan = run(folder, "plan in.svg -o plan.json");
    ASSERT_EQ(plan.exit, 0) << plan.err;
    for (const char* word : {"scale", "rake up", "Dubins", "time", "fallbacks", "sound"})
        EXPECT_NE(plan.err.find(word), std::string::npos) << word << "\n" << plan.err;
    EXPECT_EQ(run(folder, "check plan.json").exit, 0);
    ASSERT_EQ(run(folder, "export plan.json --format beachbot -o robot.txt").exit, 0);
    ASSERT_EQ(run(folder, "render plan.json -o picture.png").exit, 0);
    EXPECT_EQ(read(folder / "picture.png").substr(1, 3), "PNG");
    ASSERT_EQ(run(folder, "render plan.json -o picture.svg").exit, 0);

    // The pair: equally many lines, the last one 129, the first on the canvas.
    std::istringstream robot(read(folder / "robot_robot.txt")), rake(read(folder / "robot_rake.txt"));
    double x = 0, y = 0, u = 0, v = 0;
    int mask = 0, other = 0, lines = 0, drawn = 0;
    while (robot >> x >> y >> mask) {
        ASSERT_TRUE(rake >> u >> v >> other);
        EXPECT_EQ(mask, other);
        ++lines;
        drawn += mask > 0 && mask < 128;
    }
    EXPECT_FALSE(rake >> u);
    EXPECT_EQ(mask, 129);
    EXPECT_GT(drawn, 200);
}

TEST(MainJob, WorksThroughPipes) {
    const Folder folder;
    write(folder / "in.svg", two_lines);
    const Result piped = run(folder, "plan - -q < in.svg | '" STRANDLINE_PROGRAM "' check - --json");
    EXPECT_EQ(piped.exit, 0) << piped.err;
    EXPECT_NE(piped.out.find("\"sound\":true"), std::string::npos) << piped.out;
}

TEST(MainJob, TheSameCallGivesTheSameBytes) {
    const Folder folder;
    write(folder / "in.svg", two_lines);
    const Result once = run(folder, "-q plan in.svg"), again = run(folder, "-q plan in.svg");
    EXPECT_EQ(once.exit, 0) << once.err;
    EXPECT_EQ(once.out, again.out);
    EXPECT_EQ(once.err, "");
}

TEST(MainJob, PlacementIsKept) {
    const Folder folder;
    write(folder / "in.svg", two_lines);
    const Result scaled = run(folder, "plan in.svg -o plan.json --place scale=1:0.02");  // 160 mm -> 8 m
    EXPECT_EQ(scaled.exit, 0) << scaled.err;
    EXPECT_NE(scaled.err.find("50:1"), std::string::npos) << scaled.err;
    EXPECT_EQ(run(folder, "plan in.svg -o plan.json --place width=10m --canvas 12x12").exit, 0);
    EXPECT_EQ(
        run(folder, "plan in.svg -o plan.json --place actual --robot plotter --canvas A4-landscape").exit, 0);
    EXPECT_EQ(run(folder, "plan in.svg -o plan.json --place width").exit, 2);
}

TEST(MainJob, ASettingsFileAndEditsAreHeard) {
    const Folder folder;
    write(folder / "in.svg", two_lines);
    write(folder / "mine.toml",
          "link = [\"a:0=b:-1\"]\n[trajectory]\nstep = \"3cm\"\n[robot]\nbase = \"beachbot\"\nmin_radius = "
          "0.6\n");
    const Result plan = run(folder, "plan in.svg -o plan.json --config mine.toml");
    ASSERT_EQ(plan.exit, 0) << plan.err;
    EXPECT_NE(plan.err.find("1.67"), std::string::npos) << "limit 1/0.6: " << plan.err;
    write(folder / "wrong.toml", "[fill]\nstyle = \"swirl\"\n");
    const Result wrong = run(folder, "plan in.svg -o plan.json --config wrong.toml");
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_NE(wrong.err.find("line 2"), std::string::npos) << wrong.err;
    const Result idle = run(folder, "plan in.svg -o plan.json --link gone:0=a:0");
    EXPECT_EQ(idle.exit, 0);
    EXPECT_NE(idle.err.find("gone"), std::string::npos) << idle.err;
    EXPECT_EQ(run(folder, "plan in.svg -o plan.json --strict --link gone:0=a:0").exit, 3);
}

TEST(MainJob, HelpAndListsAnswer) {
    const Folder folder;
    EXPECT_EQ(run(folder, "--version").out.substr(0, 11), "strandline ");
    EXPECT_NE(run(folder, "plan --help").out.find("Examples"), std::string::npos);
    EXPECT_NE(run(folder, "formats").out.find("beachbot"), std::string::npos);
    EXPECT_NE(run(folder, "settings").out.find("fill.spacing"), std::string::npos);
    EXPECT_NE(run(folder, "robots").out.find("plotter"), std::string::npos);
    write(folder / "in.svg", two_lines);
    EXPECT_EQ(run(folder, "robots turf").exit, 0);
    write(folder / "turf.toml", run(folder, "robots turf").out);
    EXPECT_EQ(run(folder, "robots turf.toml -o turf.svg").exit, 0);
    EXPECT_EQ(read(folder / "turf.svg").substr(0, 5), "<svg ");
    EXPECT_EQ(run(folder, "robots turf -o same.toml").exit, 0);
    EXPECT_EQ(read(folder / "same.toml"), read(folder / "turf.toml"));
    EXPECT_EQ(run(folder, "robots -o all.toml").exit, 2);
    EXPECT_EQ(run(folder, "plan in.svg -o plan.json --robot turf.toml").exit, 0);
    EXPECT_EQ(run(folder, "fly").exit, 2);
}

TEST(MainJob, ListsAreJsonWhenAskedFor) {
    const Folder folder;
    const auto holds = [&](const std::string& arguments, const std::string& part) {
        const Result list = run(folder, arguments + " --json");
        EXPECT_EQ(list.exit, 0) << list.err;
        EXPECT_NE(list.out.find(part), std::string::npos) << part << " in: " << list.out;
        EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '{'),
                  std::count(list.out.begin(), list.out.end(), '}'));
        return list.out;
    };
    holds("formats", R"({"name":"trace","what":)");
    holds("settings", R"({"key":"trajectory.step","kind":"length","unit":"m","default":0.02,"low":)");
    holds("settings", R"("default":"rings","choices":["rings","spiral","zigzag"],"meaning":)");
    holds("settings", R"("default":true,"meaning":)");
    const std::string all = holds("robots", R"("name":"plotter")"),
                      one = holds("robots turf", R"("name":"turf")");
    EXPECT_NE(all.find(one.substr(0, one.find('\n'))), std::string::npos) << "the same robot in both";
}

}  // namespace
}  // namespace strandline::test
