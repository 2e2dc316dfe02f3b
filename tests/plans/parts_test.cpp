#include "plan/parts/parts.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"
#include "path/trajectory/trajectory.hpp"
#include "result/check/check.hpp"

namespace strandline::parts {
namespace {

/// A line, an arc, and an area of three strokes.
Plan whole() { return by_hand::raked_plan(); }

TEST(Parts, APartOfWholeElementsIsSound) {
    const Plan plan = whole();
    for (const auto& [first, end] : {std::pair{0, 1}, {1, 2}, {0, 2}, {1, 5}, {2, 5}, {0, 5}}) {
        const Plan piece = part(plan, first, end);
        const check::Report report = check::prove(piece);
        EXPECT_TRUE(report.sound()) << first << " to " << end << ": "
                                    << (report.faults.empty() ? "" : report.faults.front().what);
        EXPECT_EQ(piece.strokes.size(), static_cast<std::size_t>(end - first));
        EXPECT_TRUE(piece.warnings.empty());
        EXPECT_EQ(piece.samples.front().t, 0);
        EXPECT_EQ(piece.samples.front().speed, 0);
        EXPECT_EQ(piece.samples.back().mask, 0u);
    }
}

TEST(Parts, APlanWithAStrokeThatIsNotDrivenCannotBeCut) {
    Plan plan = whole();
    EXPECT_TRUE(can_be_cut(plan));
    for (Sample& sample : plan.samples)
        if (sample.stroke == 2) sample.motion = Motion::connect;
    ASSERT_FALSE(can_be_cut(plan));
    EXPECT_EQ(can_be_cut(plan).error().reason, "stroke 2 is never driven");
    EXPECT_FALSE(can_be_cut(Plan{}));
}

TEST(Parts, AnElementInTwoPartsIsNamed) {
    const Plan piece = part(whole(), 0, 3);
    ASSERT_EQ(piece.warnings.size(), 1u);
    EXPECT_EQ(piece.warnings.front().place, "area");
    EXPECT_FALSE(check::prove(piece).sound());  // its area is not full
}

TEST(Parts, TogetherThePartsDrawWhatTheWholeDraws) {
    const Plan plan = whole();
    double drawn = 0;
    std::size_t strokes = 0;
    const std::vector<int> begins = cuts(plan, {.seconds = 40});
    ASSERT_GT(begins.size(), 1u);
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const Plan piece = part(plan, begins[k], k + 1 < begins.size() ? begins[k + 1] : 5);
        drawn += piece.figures.drawn;
        strokes += piece.strokes.size();
    }
    Figures figures;
    measure(figures, plan.samples);
    EXPECT_NEAR(drawn, figures.drawn, 1e-9);
    EXPECT_EQ(strokes, plan.strokes.size());
}

TEST(Parts, CutsKeepTheLimitAndGoAfterWholeElements) {
    const Plan plan = whole();
    EXPECT_EQ(cuts(plan, {.seconds = 1e6}), std::vector<int>{0});
    EXPECT_EQ(cuts(plan, {.metres = 0.1}), (std::vector<int>{0, 1, 2, 3, 4}));  // each longer than that
    for (const double metres : {4.0, 8.0, 12.0, 20.0}) {
        const std::vector<int> begins = cuts(plan, {.metres = metres});
        for (std::size_t k = 0; k < begins.size(); ++k) {
            const int end = k + 1 < begins.size() ? begins[k + 1] : 5;
            const Plan piece = part(plan, begins[k], end);
            double driven = 0;
            for (std::size_t i = 1; i < piece.samples.size(); ++i)
                driven += distance(piece.samples[i - 1].pose.at, piece.samples[i].pose.at);
            EXPECT_TRUE(driven <= metres + 1e-9 || end == begins[k] + 1) << metres << " " << driven;
        }
    }
    // 12 m hold the line and the arc, not the area too: the cut is before the area, not in it.
    const std::vector<int> begins = cuts(plan, {.metres = 12});
    ASSERT_GE(begins.size(), 2u);
    EXPECT_EQ(begins[1], 2);
}

TEST(Parts, WhereToGoOnIsFoundByTimeElementAndPlace) {
    const Plan plan = whole();
    EXPECT_EQ(*stroke_at(plan, 0.0), 0);
    EXPECT_EQ(*stroke_at(plan, std::string("area")), 2);
    for (std::size_t i = 0; i + 1 < plan.samples.size(); i += 10) {
        const Sample& sample = plan.samples[i];
        if (sample.motion != Motion::draw) continue;
        EXPECT_EQ(*stroke_at(plan, sample.t), sample.stroke);
        EXPECT_EQ(*stroke_at(plan, sample.rake), sample.stroke);
    }
    EXPECT_FALSE(stroke_at(plan, 1e9));
    EXPECT_FALSE(stroke_at(plan, std::string("nothing")));
}

TEST(Parts, TimingAWholeDriveAnewChangesNothing) {
    const Plan plan = whole();
    const std::vector<Sample> again = trajectory::retimed(plan.samples, plan.robot);
    ASSERT_EQ(again.size(), plan.samples.size());
    // The drive by hand is timed a little more carefully than it need be.
    EXPECT_LE(again.back().t, plan.samples.back().t + 1e-9);
    EXPECT_GT(again.back().t, 0.9 * plan.samples.back().t);
    const std::vector<Sample> twice = trajectory::retimed(again, plan.robot);
    for (std::size_t i = 0; i < again.size(); ++i) EXPECT_NEAR(twice[i].t, again[i].t, 1e-6) << i;
}

}  // namespace
}  // namespace strandline::parts
