// The stage commands before the independent judges, where those are at hand (../shared); skipped elsewhere.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "cli/program.hpp"

namespace strandline::test {
namespace {

const fs::path shared = STRANDLINE_SHARED;

#define NEEDS(path) \
    if (!fs::exists(path)) GTEST_SKIP() << (path) << " is not at hand"

/// A command of the shell, its output and exit code.
Result shell(const Folder& folder, const std::string& command) {
    const fs::path out = folder / ".shell";
    const int status = std::system((command + " >'" + out.string() + "' 2>&1").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), {}};
}

double number_after(const std::string& text, const std::string& word) {
    const std::size_t at = text.find(word);
    return at == std::string::npos ? std::nan("") : std::atof(text.c_str() + at + word.size());
}

struct Optimum {
    const char* name;
    double length;
};

TEST(Judges, TheSixSmallToursAreOptimal) {
    NEEDS(shared / "judge/tour/verify.py");
    for (const auto& [name, optimum] : {Optimum{"lion_example", 1104.838},
                                        {"shark_test", 636.189},
                                        {"asl_logo", 858.085},
                                        {"asl_font", 352.550},
                                        {"flower_example", 60.701},
                                        {"maleficient", 558.238}}) {
        const Folder folder;
        const fs::path instance = shared / "judge/tour/instances" / (std::string("asset_") + name + ".json");
        const Result tour = run(folder, fmt::format("tour '{}' -o tour.json", instance.string()));
        ASSERT_EQ(tour.exit, 0) << tour.err;
        const Result verdict =
            shell(folder, fmt::format("python3 '{}' '{}' '{}'", (shared / "judge/tour/verify.py").string(),
                                      instance.string(), (folder / "tour.json").string()));
        ASSERT_EQ(verdict.exit, 0) << name << ": " << verdict.out;
        EXPECT_NEAR(number_after(verdict.out, "OK "), optimum, 1.1e-3) << name;
    }
}

TEST(Judges, ConnectionsKeepTheirLimits) {
    const fs::path judge = shared / "judge/curves/checkcurves.cpp";
    NEEDS(judge);
    const Folder folder;
    const std::string binary = (folder / "checkcurves").string();
    ASSERT_EQ(shell(folder, fmt::format("g++ -O1 -std=c++17 '{}' -o '{}'", judge.string(), binary)).exit, 0);
    std::mt19937_64 random(20140704);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    std::string pairs;
    for (int i = 0; i < 1000; ++i) {
        const double d = 0.1 * std::pow(200, uniform(0, 1)), a = uniform(-3.14159, 3.14159);
        pairs += fmt::format(
                     R"({{"start":[0,0,{}],"end":[{},{},{}],"R":1,"sigma":{},"kappa0":{},"kappa1":{}}})",
                     uniform(-3.14159, 3.14159), d * std::cos(a), d * std::sin(a), uniform(-3.14159, 3.14159),
                     i % 2 ? 2.5 : 10.0, i % 4 < 2 ? 0 : uniform(-1, 1), i % 4 < 2 ? 0 : uniform(-1, 1)) +
                 "\n";
    }
    write(folder / "pairs.jsonl", pairs);
    ASSERT_EQ(run(folder, "connect pairs.jsonl -o curves.jsonl").exit, 0);
    const Result verdict =
        shell(folder, fmt::format("'{}' --quiet --summary '{}'", binary, (folder / "curves.jsonl").string()));
    EXPECT_EQ(verdict.exit, 0) << verdict.out;
    EXPECT_NE(verdict.out.find("curves 1000, with any violation 0 "), std::string::npos) << verdict.out;
}

TEST(Judges, EveryPolygonIsFilledWithoutSpill) {
    const fs::path judge = shared / "judge/fill/evaluate.py";
    NEEDS(judge);
    const Folder folder;
    for (const char* name : {"square", "glyph_A", "disc", "L", "star"})
        for (const char* style : {"spiral", "zigzag"}) {
            const fs::path polygon = shared / "judge/fill/polygons" / (std::string(name) + ".json");
            const Result fill =
                run(folder, fmt::format("fill '{}' --style {} -o fill.json", polygon.string(), style));
            ASSERT_TRUE(fill.exit == 0 || fill.exit == 3) << name << ": " << fill.err;
            const Result verdict =
                shell(folder, fmt::format("/usr/bin/python3 '{}' '{}' --noraster", judge.string(),
                                          (folder / "fill.json").string()));
            ASSERT_EQ(verdict.exit, 0) << verdict.out;
            EXPECT_GT(number_after(verdict.out, "\"coverage\": "), 0.9)
                << name << " " << style << verdict.out;
            EXPECT_LT(number_after(verdict.out, "\"spill\": "), 0.01) << name << " " << style;
        }
}

TEST(Judges, TheDrawingsOf2014ArePlannedAndProved) {
    NEEDS(shared / "drawings");
    const Folder folder;
    int drawings = 0;
    for (const auto& entry : fs::directory_iterator(shared / "drawings")) {
        ++drawings;
        const std::string name = entry.path().string();
        const Result plan = run(folder, fmt::format("plan '{}' -o plan.json", name));
        ASSERT_EQ(plan.exit, 0) << name << "\n" << plan.err;
        // Lines are drawn without a fault; where an area's corridors are too narrow for the rake, check names
        // the place.
        const Result check = run(folder, "check plan.json -v");
        const bool lines = check.out.find(" 0 areas") != std::string::npos;
        EXPECT_TRUE(check.exit == 0 ||
                    (!lines && check.exit == 3 && check.out.find("fault: ") != std::string::npos))
            << name << "\n"
            << check.out;
        const Result trace = run(folder, "export plan.json --format trace -o trace.json");
        ASSERT_EQ(trace.exit, 0) << trace.err;
    }
    EXPECT_EQ(drawings, 7);
}

TEST(Judges, TheTraceOfALineDrawingBreaksNoLimit) {
    const fs::path judge = shared / "judge/trace/metrics.py";
    NEEDS(judge);
    const Folder folder;
    ASSERT_EQ(
        run(folder, fmt::format("plan '{}' -o plan.json", (shared / "drawings/lion_example.svg").string()))
            .exit,
        0);
    ASSERT_EQ(run(folder, "export plan.json --format trace --path robot -o trace.json").exit, 0);
    const Result verdict = shell(
        folder, fmt::format("/usr/bin/python3 '{}' '{}'", judge.string(), (folder / "trace.json").string()));
    ASSERT_EQ(verdict.exit, 0) << verdict.out;
    EXPECT_EQ(number_after(verdict.out, "n_bad_moves"), 0) << verdict.out;
}

}  // namespace
}  // namespace strandline::test
