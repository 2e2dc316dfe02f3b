// plan --out-dir: several drawings into one folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace strandline::test {
namespace {

using Json = nlohmann::json;

std::string lines_to(int x) {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><path d='M10 10L" +
           std::to_string(x) + " 90' stroke='black' fill='none'/><path d='M90 10L60 " + std::to_string(x) +
           "' stroke='black' fill='none'/></svg>";
}

/// a.svg, b.svg and c.svg.
void write_three(const Folder& folder) {
    write(folder / "a.svg", lines_to(30));
    write(folder / "b.svg", lines_to(40));
    write(folder / "c.svg", lines_to(50));
}

/// What became of each file, in the order of the call: "planned planned failed".
std::string outcomes(const Result& result) {
    const Json json = Json::parse(result.out, nullptr, false);
    if (json.is_discarded()) return "no JSON: " + result.out;
    std::string all;
    for (const Json& file : json["files"])
        all += (all.empty() ? "" : ", ") + file["outcome"].get<std::string>();
    return all;
}

TEST(Batch, EachPlanIsTheOneThatPlanMakesWhateverTheNumberOfThreads) {
    const Folder folder;
    write_three(folder);
    ASSERT_EQ(run(folder, "-q plan a.svg b.svg c.svg --out-dir one").exit, 0);
    ASSERT_EQ(run(folder, "-q plan a.svg b.svg c.svg --out-dir three -j 3").exit, 0);
    for (const std::string name : {"a", "b", "c"}) {
        ASSERT_EQ(run(folder, "-q plan " + name + ".svg -o alone.json").exit, 0);
        EXPECT_EQ(read(folder / "alone.json"), read(folder / ("one/" + name + ".json"))) << name;
        EXPECT_EQ(read(folder / "alone.json"), read(folder / ("three/" + name + ".json"))) << name;
    }
    EXPECT_EQ(read(folder / "one/.strandline-batch"), read(folder / "three/.strandline-batch"));
}

TEST(Batch, OneFailureDoesNotStopTheOthersAndIsTheExitCode) {
    const Folder folder;
    write_three(folder);
    write(folder / "b.svg", "<svg");
    const Result result = run(folder, "plan a.svg b.svg absent.svg c.svg --out-dir plans -j 2 --json");
    EXPECT_EQ(result.exit, 1);
    EXPECT_EQ(outcomes(result), "planned, failed, failed, planned");
    EXPECT_NE(result.err.find("strandline: b.svg"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("strandline: absent.svg: cannot be read"), std::string::npos) << result.err;
    EXPECT_TRUE(fs::exists(folder / "plans/c.json"));
    EXPECT_FALSE(fs::exists(folder / "plans/b.json"));
}

TEST(Batch, TheTableHasALineAFileAndTheFiguresOfThePlan) {
    const Folder folder;
    write_three(folder);
    const Result result = run(folder, "plan a.svg b.svg c.svg --out-dir plans");
    ASSERT_EQ(result.exit, 0) << result.err;
    for (const char* words : {"1/3 a.svg: planned; 2 elements", "file ", "in all ", "3 planned"})
        EXPECT_NE(result.err.find(words), std::string::npos) << words << "\n" << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 3 + 1 + 3 + 1) << result.err;
    EXPECT_EQ(result.out, "");

    const Result again = run(folder, "-q plan a.svg --out-dir plans --json");
    const Json file = Json::parse(again.out)["files"][0], plan = Json::parse(read(folder / "plans/a.json"));
    EXPECT_EQ(file["plan"], "plans/a.json");
    EXPECT_EQ(file["elements"], plan["figures"]["elements"]);
    EXPECT_EQ(file["drawn"], plan["figures"]["drawn"]);
    EXPECT_EQ(file["time"], plan["figures"]["time"]);
    EXPECT_EQ(file["warnings"], plan["warnings"].size());
}

TEST(Batch, OnlyWhatWouldComeOutOtherwiseIsPlannedAgain) {
    const Folder folder;
    write_three(folder);
    const std::string call = "plan a.svg b.svg --out-dir plans --json ";
    EXPECT_EQ(outcomes(run(folder, call)), "planned, planned");
    EXPECT_EQ(outcomes(run(folder, call)), "up to date, up to date");
    // The time of a file says nothing, its content does.
    write(folder / "a.svg", lines_to(30));
    EXPECT_EQ(outcomes(run(folder, call)), "up to date, up to date");
    write(folder / "a.svg", lines_to(31));
    EXPECT_EQ(outcomes(run(folder, call)), "planned, up to date");
    // A setting, however it is said, and its default.
    EXPECT_EQ(outcomes(run(folder, call + "--margin 75cm")), "planned, planned");
    EXPECT_EQ(outcomes(run(folder, call + "--set canvas.margin=0.75m")), "up to date, up to date");
    write(folder / "mine.toml", "[canvas]\nmargin = 0.75\n");
    EXPECT_EQ(outcomes(run(folder, call + "--config mine.toml")), "up to date, up to date");
    EXPECT_EQ(outcomes(run(folder, call)), "planned, planned");
    // The robot.
    EXPECT_EQ(outcomes(run(folder, call + "--robot turf")), "planned, planned");
    EXPECT_EQ(outcomes(run(folder, call + "--robot turf --set robot.speed=0.1")), "planned, planned");
    // Plans that were changed, or are gone; the record too.
    EXPECT_EQ(outcomes(run(folder, call)), "planned, planned");
    write(folder / "plans/a.json", "changed");
    EXPECT_EQ(outcomes(run(folder, call)), "planned, up to date");
    fs::remove(folder / "plans/b.json");
    EXPECT_EQ(outcomes(run(folder, call)), "up to date, planned");
    EXPECT_EQ(outcomes(run(folder, call + "--force")), "planned, planned");
    write(folder / "plans/.strandline-batch", "{}");
    EXPECT_EQ(outcomes(run(folder, call)), "planned, planned");
}

TEST(Batch, DrawingsThatWouldShareAPlanAreRefusedBeforeTheFirstIsPlanned) {
    const Folder folder;
    write_three(folder);
    fs::create_directory(folder / "other");
    write(folder / "other/a.svg", lines_to(60));
    expect_refused(folder, "plan a.svg other/a.svg --out-dir out", 2, "both a.svg and other/a.svg");
    expect_refused(folder, "plan a.svg ./a.svg --out-dir out", 2, "a.json");
}

TEST(Batch, WhatIsForOneDrawingIsRefused) {
    const Folder folder;
    write_three(folder);
    expect_refused(folder, "plan a.svg b.svg -o out", 2, "--out-dir");
    expect_refused(folder, "plan a.svg b.svg --out-dir out -o x.json", 2, "-o");
    expect_refused(folder, "plan a.svg --out-dir out --split 5min", 2, "--split");
    expect_refused(folder, "plan a.svg - --out-dir out", 2, "-o");
    expect_refused(folder, "plan --out-dir out", 2, "missing");
    expect_refused(folder, "plan a.svg -j 2", 2, "--out-dir");
    expect_refused(folder, "plan a.svg b.svg --out-dir out --set fill.style=swirl", 2, "fill.style");
    expect_refused(folder,
                   "plan a.svg b.svg --out-dir out -j 2 --set tour.threads=2 --set tour.time_limit=1s", 2,
                   "tour.threads=1");
    write(folder / "file", "");
    expect_refused(folder, "plan a.svg --out-dir file", 2, "no folder");
    expect_refused(folder, "plan a.svg --out-dir " + std::string(300, 'x'), 2, "--out-dir");
}

TEST(Batch, StrictFallsShortOfUpToDatePlansToo) {
    const Folder folder;
    write_three(folder);
    const std::string call = "-q plan a.svg b.svg --out-dir plans --strict --link gone:0=gone:1";
    EXPECT_EQ(run(folder, call).exit, 3);
    EXPECT_EQ(run(folder, call).exit, 3);
}

/// Interrupted while long.svg is planned.
Result batch_interrupted(const Folder& folder, const std::string& more = "") {
    return interrupted(folder,
                       "plan a.svg long.svg b.svg --out-dir plans --json --set tour.moves=2000000000" + more,
                       "until grep -q '^1/3' said; do sleep 0.05; done; sleep 0.2");
}

TEST(Batch, AnInterruptLeavesFinishedPlansAndATable) {
    const Folder folder;
    write_three(folder);
    write_endless(folder / "long.svg");
    ASSERT_EQ(run(folder, "-q plan a.svg --out-dir plans --set tour.moves=2000000000").exit, 0);
    const Result result = batch_interrupted(folder);
    EXPECT_EQ(result.exit, 130);
    EXPECT_EQ(outcomes(result), "up to date, stopped, not begun");
    EXPECT_FALSE(fs::exists(folder / "plans/long.json"));
}

TEST(Batch, AnInterruptBeforeASizeFitsIsNoFailure) {
    const Folder folder;
    write_three(folder);
    write_endless(folder / "long.svg");
    const Result result = batch_interrupted(folder, " --max-time 1s");
    EXPECT_EQ(result.exit, 130);
    EXPECT_EQ(outcomes(result), "failed, stopped, not begun") << "a.svg was tried and does not fit";
}

TEST(Batch, WhatIsTakenForGrantedStandsInEachPlanAndIsSaidWithIt) {
    const Folder folder;
    write_three(folder);
    write(folder / "field.geojson", R"({"type": "Polygon", "coordinates":
        [[[-0.001, -0.001], [0.001, -0.001], [0.001, 0.001], [-0.001, 0.001], [-0.001, -0.001]]]})");
    const Result result = run(folder, "plan a.svg b.svg --out-dir plans --border field.geojson");
    ASSERT_EQ(result.exit, 0) << result.err;
    const Json plan = Json::parse(read(folder / "plans/b.json"));
    EXPECT_EQ(plan["warnings"].at(0)["place"], "field.geojson");
    const std::string words = "warning: field.geojson: no place on earth";
    const auto first = result.err.find(words);
    ASSERT_NE(first, std::string::npos) << result.err;
    EXPECT_NE(result.err.find(words, first + 1), std::string::npos) << "once a plan: " << result.err;
}

}  // namespace
}  // namespace strandline::test
