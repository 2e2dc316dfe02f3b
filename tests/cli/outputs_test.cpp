// What the program writes, and what it must never write over.
#include <gtest/gtest.h>

#include "program.hpp"

namespace strandline::test {
namespace {

const std::string drawing =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
    "<path id='a' d='M10 10L90 90' stroke='black' fill='none'/></svg>";

TEST(Outputs, TheDrawingIsNeverReplaced) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    EXPECT_EQ(run(folder, "plan in.svg -o ./in.svg").exit, 2);
    EXPECT_EQ(run(folder, "plan ./in.svg -o in.json --open").exit, 2);
    EXPECT_EQ(run(folder, "plan in.svg -o plan.svg --open").exit, 2);
    EXPECT_EQ(read(folder / "in.svg"), drawing);
}

TEST(Outputs, ALinkIsFollowedAndRightsAreKept) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    write(folder / "real.json", "old");
    fs::permissions(folder / "real.json", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.json", folder / "link.json");
    ASSERT_EQ(run(folder, "-q plan in.svg -o link.json").exit, 0);
    EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
    EXPECT_GT(read(folder / "real.json").size(), 100u);
    EXPECT_EQ(fs::status(folder / "real.json").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Outputs, APipeIsWrittenToAsItIs) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    const Result result = run(folder, "-q plan in.svg -o /dev/null");
    EXPECT_EQ(result.exit, 0) << result.err;
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(Outputs, CheckRepeatsTheWarningsOfThePlan) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    const Result planned = run(folder, "plan in.svg -o plan.json --link b:0=c:0");
    const std::string said = planned.err.substr(0, planned.err.find('\n') + 1);
    EXPECT_EQ(said, "warning: link: node 0 of \"b\" is not in the drawing\n");
    EXPECT_EQ(run(folder, "check plan.json").err, said);
    EXPECT_EQ(run(folder, "-q check plan.json").err, "");
}

TEST(Outputs, AreasOfAPenOnPaperHaveFigures) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    ASSERT_EQ(run(folder, "-q plan in.svg --robot plotter --canvas A4 -o paper.json").exit, 0);
    ASSERT_EQ(run(folder, "-q plan in.svg -o beach.json").exit, 0);
    const std::string paper = run(folder, "simulate paper.json").out,
                      beach = run(folder, "simulate beach.json").out;
    EXPECT_NE(paper.find(" cm^2 not raked"), std::string::npos) << paper;
    EXPECT_NE(paper.find("mm in the mean"), std::string::npos) << paper;
    EXPECT_NE(beach.find(" cm in the mean"), std::string::npos) << beach;
}

TEST(Outputs, TheHelpNamesEveryRobot) {
    const Folder folder;
    EXPECT_NE(run(folder, "plan --help").out.find("beachbot, plotter, turf, diffdrive, sandtable, or"),
              std::string::npos);
}

TEST(Outputs, OfAPairBothOrNone) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    ASSERT_EQ(run(folder, "-q plan in.svg -o plan.json").exit, 0);
    fs::create_directory(folder / "a_rake.txt");  // cannot be written
    EXPECT_EQ(run(folder, "export plan.json --format beachbot -o a.txt").exit, 1);
    EXPECT_FALSE(fs::exists(folder / "a_robot.txt"));
    EXPECT_EQ(run(folder, "export plan.json --format beachbot -o -").exit, 2);
}

TEST(Outputs, AFullDiskIsSaid) {
    if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "/dev/full is not at hand";
    const Folder folder;
    write(folder / "in.svg", drawing);
    EXPECT_EQ(run(folder, "-q plan in.svg -o /dev/full").exit, 1);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_EQ(std::system(("'" STRANDLINE_PROGRAM "' settings >/dev/full 2>/dev/null; test $? -eq 1")), 0);
}

TEST(Outputs, WhatIsDroppedIsSaid) {
    const Folder folder;
    write(folder / "in.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
          "<path d='M10 10L90 90M50 50l0.01 0' stroke='black' fill='none'/></svg>");
    const Result result = run(folder, "plan in.svg -o plan.json");
    EXPECT_NE(result.err.find("1 lines under 0.01 m left out"), std::string::npos) << result.err;
}

TEST(Outputs, AWishThatTheRobotCannotFulfilIsRefused) {
    const Folder folder;
    write(folder / "in.svg", drawing);
    for (const char* wish : {"connect.style=straight", "corner.above=pivot"}) {
        const Result result = run(folder, std::string("plan in.svg -o plan.json --set ") + wish);
        EXPECT_EQ(result.exit, 2) << wish;
        EXPECT_NE(result.err.find("can_pivot"), std::string::npos) << result.err;
        EXPECT_EQ(
            run(folder, std::string("plan in.svg -o plan.json --set robot.can_pivot=on --set ") + wish).exit,
            0);
    }
}

}  // namespace
}  // namespace strandline::test
