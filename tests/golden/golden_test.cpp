// Our own drawings, planned for the beachbot (rake offset) and the plotter (none), against kept digests.
// STRANDLINE_REWRITE_GOLDEN=1 build/dev/tests/test_golden rewrites them; read the diff before committing it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "compare.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline {
namespace {

namespace fs = std::filesystem;
const fs::path source = STRANDLINE_SOURCE;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> drawings() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(source / "drawings"))
        if (entry.path().extension() == ".svg") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// What a plan comes to, in few lines: its figures, the order of its strokes, and every hundredth sample.
std::string digest(const Plan& plan) {
    const Figures& f = plan.figures;
    std::string text = fmt::format("elements {} lines {} regions {} strokes {}\n", f.elements, f.lines,
                                   f.regions, f.strokes);
    text += fmt::format("drawn {:.9f} straight {:.9f} dubins {:.9f} driven {:.9f} loops {:.9f} time {:.9f}\n",
                        f.drawn, f.up_straight, f.up_dubins, f.up_driven, f.loops_driven, f.time);
    for (const Entry& entry : plan.order) {
        const Stroke& stroke = plan.strokes[static_cast<std::size_t>(entry.stroke)];
        text += fmt::format("stroke of {} node {} {}\n",
                            plan.drawing.elements[static_cast<std::size_t>(stroke.element)].id, entry.node,
                            entry.reversed ? "reversed" : "forward");
    }
    for (std::size_t i = 0; i < plan.samples.size(); i += 100) {
        const Sample& s = plan.samples[i];
        text += fmt::format("at {:.9f} x {:.9f} y {:.9f} mask {} {}\n", s.t, s.pose.at.x, s.pose.at.y, s.mask,
                            name_of(s.motion));
    }
    return text;
}

Outcome<Plan> planned(const fs::path& drawing, const std::string& robot) {
    Options options;
    if (robot == "plotter") options = defaults_for({0.297, 0.21});
    const std::string text = read(drawing);
    return make_plan({text, drawing.filename().string()}, *builtin_robot(robot), options);
}

TEST(Golden, OurDrawingsPlanAsTheyDid) {
    const bool rewrite = std::getenv("STRANDLINE_REWRITE_GOLDEN") != nullptr;
    ASSERT_GE(drawings().size(), 8u);
    for (const fs::path& drawing : drawings())
        for (const std::string robot : {"beachbot", "plotter"}) {
            const auto plan = planned(drawing, robot);
            ASSERT_TRUE(plan) << drawing << ": " << sentence(plan.error());
            const fs::path kept = source / "tests/golden" / (drawing.stem().string() + "-" + robot + ".txt");
            if (rewrite) std::ofstream(kept) << digest(*plan);
            EXPECT_EQ(golden::difference(read(kept), digest(*plan)), "")
                << drawing.filename() << " for the " << robot;
        }
}

TEST(Golden, TheSamePlanTwiceIsTheSameToTheLastBit) {
    const fs::path drawing = drawings().front();
    const auto once = planned(drawing, "beachbot"), again = planned(drawing, "beachbot");
    ASSERT_TRUE(once && again);
    EXPECT_TRUE(*once == *again);
}

// The twin: the comparison itself can fail.
TEST(Golden, ADifferenceIsFound) {
    EXPECT_EQ(golden::difference("at 1.0 x 2\n", "at 1.0000001 x 2\n"), "");
    EXPECT_NE(golden::difference("at 1.0 x 2\n", "at 1.001 x 2\n"), "");
    EXPECT_NE(golden::difference("stroke of a\n", "stroke of b\n"), "");
    EXPECT_NE(golden::difference("one\n", "one\ntwo\n"), "");
    EXPECT_NE(golden::difference("", "one\n"), "");
}

}  // namespace
}  // namespace strandline
