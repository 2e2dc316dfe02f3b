// simulate, resume, split and plan --max-time, as a person calls them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace strandline::test {
namespace {

const std::string drawing =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
    "<path id='a' d='M10 10L90 20' stroke='black' fill='none'/>"
    "<path id='b' d='M10 40C40 30 60 60 90 50' stroke='black' fill='none'/>"
    "<path id='c' d='M10 70h40v20h-40z'/></svg>";

struct Planned : Folder {
    Planned() {
        write(*this / "in.svg", drawing);
        EXPECT_EQ(run(*this, "-q plan in.svg -o plan.json").exit, 0);
    }
};
nlohmann::json json_of(const Folder& folder, const std::string& arguments) {
    const Result result = run(folder, arguments + " --json -q");
    EXPECT_EQ(result.exit, 0) << result.err;
    return nlohmann::json::parse(result.out);
}

TEST(Simulate, APlanTheTextPairAndTheTableLeaveTheSameSand) {
    const Planned folder;
    ASSERT_EQ(run(folder, "export plan.json --format beachbot -o p.txt").exit, 0);
    ASSERT_EQ(run(folder, "export plan.json --format csv -o p.csv").exit, 0);
    const double own = json_of(folder, "simulate plan.json")["intersection_over_union"];
    EXPECT_GT(own, 0.9);
    for (const std::string drive : {"p_robot.txt p_rake.txt", "p.csv"}) {
        EXPECT_GE(json_of(folder, "simulate " + drive + " --against plan.json")["same_sand"], 0.995);
        EXPECT_NEAR(json_of(folder, "simulate " + drive + " --against in.svg")["intersection_over_union"],
                    own, 0.005);
    }
}

TEST(Simulate, PicturesAndAFilmAreWritten) {
    const Planned folder;
    ASSERT_EQ(run(folder, "-q simulate plan.json -o sand.png --flaws flaws.png --pixels 200").exit, 0);
    EXPECT_EQ(read(folder / "sand.png").substr(1, 3), "PNG");
    EXPECT_EQ(read(folder / "flaws.png").substr(1, 3), "PNG");
    ASSERT_EQ(run(folder, "-q simulate plan.json -o drive.gif --pixels 100 --seconds 1").exit, 0);
    EXPECT_EQ(read(folder / "drive.gif").substr(0, 6), "GIF89a");
    ASSERT_EQ(run(folder, "-q simulate plan.json -o d-%03d.png --pixels 100 --seconds 1").exit, 0);
    EXPECT_TRUE(fs::exists(folder / "d-000.png"));
    EXPECT_TRUE(fs::exists(folder / "d-012.png"));
    expect_refused(folder, "simulate plan.json -o sand.bmp", 2, "neither .png nor .gif");
}

TEST(Simulate, AControllerDrivesTheSameForASeed) {
    const Planned folder;
    const nlohmann::json once = json_of(folder, "simulate plan.json --noise --seed 3 --log drive.csv");
    EXPECT_EQ(once, json_of(folder, "simulate plan.json --noise --seed 3"));
    EXPECT_NE(once, json_of(folder, "simulate plan.json --noise --seed 4"));
    EXPECT_EQ(read(folder / "drive.csv").substr(0, 11), "t,planned_t");
    const nlohmann::json exact = json_of(folder, "simulate plan.json --noise 0 --wander 0 --delay 0.12s");
    EXPECT_LT(exact["tracking_max"], 0.003);
    expect_refused(folder, "simulate plan.json --noise 1h", 2, "--noise");
    ASSERT_EQ(run(folder, "export plan.json --format csv -o p.csv").exit, 0);
    expect_refused(folder, "simulate p.csv --noise", 2, "needs a plan");
}

TEST(Simulate, PlansAreCutAndGoOn) {
    const Planned folder;
    ASSERT_EQ(run(folder, "-q resume plan.json --from c -o rest.json").exit, 0);
    EXPECT_NE(run(folder, "check rest.json").out.find("check        sound"), std::string::npos);
    ASSERT_EQ(run(folder, "-q split plan.json --every 15m -o day.json").exit, 0);
    EXPECT_TRUE(fs::exists(folder / "day-1.json"));
    EXPECT_TRUE(fs::exists(folder / "day-2.json"));
    expect_refused(folder, "resume plan.json --from nothing -o out", 2, "no element");
    expect_refused(folder, "split plan.json --every soon -o out", 2, "neither a time nor a length");
    ASSERT_EQ(run(folder, "-q plan in.svg --split 2min -o p.json").exit, 0);
    EXPECT_TRUE(fs::exists(folder / "p-2.json"));
}

TEST(Simulate, TheLargestDrawingThatFitsATimeIsPlanned) {
    const Planned folder;
    const double whole = nlohmann::json::parse(run(folder, "plan in.svg -o p.json -q --json").out)["time"];
    const std::string limit = std::to_string(static_cast<int>(whole / 2)) + "s";
    const Result half = run(folder, "plan in.svg -o p.json -q --json --max-time " + limit);
    const double time = nlohmann::json::parse(half.out)["time"];
    EXPECT_LE(time, whole / 2);
    EXPECT_GT(time, 0.4 * whole);
    expect_refused(folder, "plan in.svg -o out -q --max-time 1s", 1, "m wide the drive takes longer");
}

TEST(Simulate, EachSizeThatIsTriedHasTheWholeTimeLimit) {
    const Folder folder;
    write_endless(folder / "in.svg");
    // Every search uses its limit up.
    const std::string call =
        "plan in.svg -o p.json -q --json --robot plotter --set tour.moves=2000000000 --set "
        "tour.time_limit=0.05s";
    const double whole = nlohmann::json::parse(run(folder, call).out)["time"];
    const Result half =
        run(folder, call + " --max-time " + std::to_string(static_cast<int>(whole / 2)) + "s");
    ASSERT_EQ(half.exit, 0) << half.err;
    EXPECT_LE(nlohmann::json::parse(half.out)["time"], whole / 2);
}

TEST(Simulate, AStoppedSearchForASizeSaysThatItWasStopped) {
    const Folder folder;
    write_endless(folder / "in.svg");
    const Result result =
        interrupted(folder, "plan in.svg -o p.json --set tour.moves=2000000000 --max-time 1s", "sleep 1");
    EXPECT_EQ(result.exit, 1);
    EXPECT_NE(result.err.find("--max-time: stopped before a smaller size was tried"), std::string::npos)
        << result.err;
    EXPECT_FALSE(fs::exists(folder / "p.json"));
}

}  // namespace
}  // namespace strandline::test
