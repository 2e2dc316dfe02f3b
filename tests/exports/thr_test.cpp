#include "exports/drive.hpp"
#include "result/exports/exports.hpp"

namespace strandline {
namespace {

using namespace testing;

std::string written(const Plan& plan) {
    const auto text = exports::thr(plan);
    EXPECT_TRUE(text) << (text ? "" : sentence(text.error()));
    return text ? text->files.at(0).bytes : "";
}
/// Strokes joined by straight lines: what a ball that never lifts can draw.
Polyline joined(const Plan& plan) {
    Polyline line;
    for (const Track& track : only_down(tracks_of(plan, true)))
        line.insert(line.end(), track.points.begin(), track.points.end());
    return line;
}
/// One line of the rake.
Plan line_plan(Point from, Point to) {
    Plan plan;
    plan.drawing.canvas = {10, 10};
    Sample a, b;
    a.rake = from;
    b.rake = to;
    a.mask = 1;
    a.stroke = 0;
    b.t = 1;
    plan.samples = {a, b};
    plan.options.thr.ends = "drawn";
    return plan;
}

TEST(Thr, ReadBackItIsWhatIsDrawnAndTheWaysBetween) {
    Plan plan = beach_plan();
    plan.options.thr.ends = "drawn";
    EXPECT_LT(apart(read_thr(written(plan)), joined(plan)), millimetre);
}

TEST(Thr, AStraightLineStaysStraightWhereverItPassesTheMiddle) {
    for (const double off : {0.0, 1e-9, 1e-5, 1e-3, 0.02, 0.5, 4.0}) {
        const Plan plan = line_plan({0.5, 5 + off}, {9.5, 5 + off});
        EXPECT_LT(apart(read_thr(written(plan)), {{0.5, 5 + off}, {9.5, 5 + off}}), millimetre) << off;
    }
    const Plan from_middle = line_plan({5, 5}, {7, 2});
    EXPECT_LT(apart(read_thr(written(from_middle)), {{5, 5}, {7, 2}}), millimetre);
}

TEST(Thr, ThetaRunsClockwiseFromTheTopAndNeverJumps) {
    Plan plan = beach_plan();
    double before = 0;
    bool begun = false;
    for (const std::string& line : lines_of(written(plan))) {
        if (line.starts_with("#")) continue;
        const double theta = std::stod(line);
        if (begun) {
            EXPECT_LT(std::abs(theta - before), pi + 1e-6);
        }
        before = theta;
        begun = true;
    }
    const auto lines = lines_of(written(line_plan({5, 9}, {9, 5})));  // from the top to the right
    EXPECT_EQ(lines[2], "0.000000 1.000000");
    EXPECT_EQ(lines.back(), "1.570796 1.000000");
}

TEST(Thr, ThetaGrowsRoundAfterRound) {
    Plan plan = line_plan({5, 9}, {5, 9});
    plan.samples.clear();
    for (int k = 0; k <= 600; ++k) {
        Sample sample;
        sample.t = k;
        sample.rake = Point{5, 5} + 4 * Point{std::sin(0.05 * k), std::cos(0.05 * k)};
        sample.mask = 1;
        sample.stroke = 0;
        plan.samples.push_back(sample);
    }
    EXPECT_NEAR(std::stod(lines_of(written(plan)).back()), 30, 1e-5);
}

TEST(Thr, TracksBeginAndEndAtTheRimOrTheMiddle) {
    Plan plan = beach_plan();
    for (const char* ends : {"nearest", "rim", "centre"}) {
        plan.options.thr.ends = ends;
        const auto lines = lines_of(written(plan));
        for (const std::string& line : {lines[2], lines.back()}) {
            const double rho = std::stod(line.substr(line.find(' ')));
            EXPECT_TRUE(rho == 0 || rho == 1) << ends << ": " << line;
            if (std::string(ends) == "rim") {
                EXPECT_EQ(rho, 1);
            }
            if (std::string(ends) == "centre") {
                EXPECT_EQ(rho, 0);
            }
        }
        EXPECT_LT(distance_to(read_thr(written(plan)), joined(plan).front()), millimetre);
    }
}

TEST(Thr, ARadiusThatIsTooSmallAndNothingDrawnAreRefused) {
    Plan plan = beach_plan();
    plan.options.thr.radius = 1;
    const auto refused = exports::thr(plan);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place, "thr.radius");
    plan.options.thr.radius = 50;
    plan.options.thr.ends = "drawn";
    EXPECT_LT(apart(read_thr(written(plan)), joined(plan)), millimetre);
    EXPECT_FALSE(exports::thr(Plan{}));
}

}  // namespace
}  // namespace strandline
