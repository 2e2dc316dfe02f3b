#include "result/sketch/sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "formats/sample_plan.hpp"

namespace strandline {
namespace {

using testing::sample_plan;

TEST(Sketch, RunsTakeAllRakeUpMotionsBetweenTwoStrokesTogether) {
    const Plan plan = sample_plan();
    const auto runs = sketch::runs(plan.samples);
    ASSERT_EQ(runs.size(), 7U);  // four strokes, three trips between them
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(runs[i].draws, i % 2 == 0);
        EXPECT_EQ(runs[i].stroke, i % 2 == 0 ? static_cast<int>(i / 2) : -1);
        EXPECT_EQ(runs[i].first, i == 0 ? 0 : runs[i - 1].last) << "neighbours share a sample";
    }
    EXPECT_EQ(runs.back().last, plan.samples.size() - 1);
    EXPECT_TRUE(sketch::runs({}).empty());
}

TEST(Sketch, AGrooveIsAsWideAsItsPinsAndLiesWhereTheyAre) {
    Plan plan = sample_plan();
    for (Sample& sample : plan.samples)
        if (sample.stroke == 0) sample.mask = 0b1100001;  // the two leftmost and the rightmost pin
    const auto grooves = sketch::sketched(plan).grooves;
    ASSERT_EQ(grooves.size(), 5U);
    EXPECT_DOUBLE_EQ(grooves[0].width, 0.12);
    EXPECT_NEAR(grooves[0].offset, 0.15, 1e-12);
    EXPECT_NEAR(grooves[1].offset, -0.18, 1e-12);
    // Stroke 0 runs to the right at y = 2: left is up.
    EXPECT_NEAR(sketch::bar_track(plan.samples, grooves[0].run, grooves[0].offset).front().y, 2.15, 1e-12);
}

TEST(Sketch, ArrowsSitOnTheirTripAndLookWhereItGoes) {
    const auto trips = sketch::sketched(sample_plan()).trips;
    ASSERT_EQ(trips.size(), 3U);
    for (const sketch::Trip& trip : trips) {
        ASSERT_FALSE(trip.arrows.empty());
        for (const Pose& arrow : trip.arrows) EXPECT_LT(distance_to(trip.track, arrow.at), 1e-9);
    }
    EXPECT_NEAR(trips[1].arrows.back().heading, pi / 2, 1e-9) << "straight up to the door";
    EXPECT_TRUE(sketch::sketched(sample_plan(), {.arrows = false}).trips[0].arrows.empty());
}

TEST(Sketch, TheViewHoldsAllThatIsDrawnAndTheLegendBelowIt) {
    Plan plan = sample_plan();
    for (Sample& sample : plan.samples) sample.rake.x += 7;  // out of the canvas
    const auto sketch = sketch::sketched(plan);
    for (const Sample& sample : plan.samples) EXPECT_TRUE(contains(sketch.view, sample.rake));
    for (const auto& item : sketch.legend) {
        EXPECT_TRUE(contains(sketch.view, item.text_at)) << item.text;
        EXPECT_LT(item.at.y, sketch.canvas.low.y) << item.text;
    }
    EXPECT_TRUE(std::ranges::any_of(sketch.legend, [](const auto& item) { return item.text == "2 m"; }));
}

TEST(Sketch, KeepOutsAndABorderAreShownWithSignsThatFitTheLegend) {
    Plan plan = sample_plan();
    const auto sketch = sketch::sketched(plan);
    EXPECT_EQ(sketch.keep_outs, plan.drawing.keep_out);
    EXPECT_EQ(sketch.border, plan.drawing.border->outer);
    EXPECT_TRUE(contains(sketch.view, {-2, -2}) && contains(sketch.view, {12, 12}));
    constexpr double letter = 0.5;  // em
    for (const auto& item : sketch.legend)
        EXPECT_LT(item.text_at.x + letter * sketch.em * static_cast<double>(item.text.size()),
                  sketch.view.high.x)
            << item.text;
    plan.drawing.border.reset();
    plan.drawing.keep_out = {{{{500, 0}, {501, 0}, {501, 1}}, {}}};
    const auto plain = sketch::sketched(plan);
    EXPECT_TRUE(plain.border.empty()) << "the canvas and its run-out are not shown";
    EXPECT_FALSE(contains(plain.view, {500, 0})) << "what lies far away is not";
}

TEST(Sketch, ACanvasWithoutExtentIsNotDrawable) {
    Plan plan;
    plan.drawing.canvas = {0, 0};
    EXPECT_FALSE(sketch::drawable(sketch::sketched(plan)));
    plan.drawing.canvas = {std::nan(""), 1e308};
    EXPECT_FALSE(sketch::drawable(sketch::sketched(plan)));
}

TEST(Sketch, AnArrowHeadPointsAhead) {
    const Polygon head = sketch::arrow_head({{1, 1}, pi / 2}, 0.2);
    EXPECT_NEAR(head[0].x, 1, 1e-12);
    EXPECT_NEAR(head[0].y, 1.1, 1e-12);
    EXPECT_GT(signed_area(head), 0);
}

}  // namespace
}  // namespace strandline
