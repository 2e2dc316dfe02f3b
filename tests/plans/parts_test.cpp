#include "plan/parts/parts.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"
#include "path/trajectory/trajectory.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"

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

/// Four lines, each a stroke, with the robot parked and its exit as said.
Plan parked_plan(bool parked, const std::string& exit) {
    Options options;
    options.park.exit = exit;
    options.park.exit_x = 11;
    if (parked) {
        options.park.parked = true;
        options.park.x = options.park.y = 1;
        options.park.heading = 0.5;
    }
    const auto plan = make_plan({R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 60"
        fill="none" stroke="black"><path id="a" d="M20 20H40"/><path id="b" d="M20 40H40"/>
        <path id="c" d="M60 20H80"/><path id="d" d="M60 40H80"/></svg>)",
                                 "lines.svg"},
                                *builtin_robot("beachbot"), options, {});
    EXPECT_TRUE(plan) << sentence(plan.error());
    return *plan;
}

TEST(Parts, EveryPartOfAParkedPlanIsReadBackAndSound) {
    for (const bool parked : {false, true})
        for (const char* exit : {"none", "parked", "outside", "pose"}) {
            if (!parked && exit == std::string("parked")) continue;
            const Plan plan = parked_plan(parked, exit);
            ASSERT_EQ(plan.strokes.size(), 4u);
            for (int first = 0; first < 4; ++first)
                for (int end = first + 1; end <= 4; ++end) {
                    const Plan piece = part(plan, first, end);
                    const auto where = ::testing::Message()
                                       << parked << " " << exit << ": " << first << " to " << end;
                    const auto back = formats::read_plan(formats::write_plan(piece), "part.json");
                    ASSERT_TRUE(back) << where << ": " << sentence(back.error());
                    EXPECT_EQ(*back, piece) << where;
                    for (const check::Fault& fault : check::prove(*back).faults)
                        ADD_FAILURE() << where << ": " << check::name_of(fault.law) << " " << fault.what;
                    EXPECT_EQ(piece.options.park.parked, parked && first == 0) << where;
                    EXPECT_EQ(piece.options.park.exit != "none", exit != std::string("none") && end == 4)
                        << where;
                    const bool way_in = first == 0 && parked,
                               way_out = end == 4 && exit != std::string("none");
                    EXPECT_EQ(piece.connections.size(),
                              static_cast<std::size_t>(end - first - 1 + way_in + way_out));
                    EXPECT_EQ(piece.figures.in_driven > 0, way_in) << where;
                    EXPECT_EQ(piece.figures.out_driven > 0, way_out) << where;
                }
        }
}

TEST(Parts, TheFaultOfADriveThatEndsElsewhereSaysMetresOrRadians) {
    const Plan plan = parked_plan(true, "none");
    const auto fault_of = [](const Plan& wrong) {
        for (const check::Fault& fault : check::prove(wrong).faults)
            if (fault.law == check::Law::ends) return fault.what;
        return std::string();
    };
    Plan beside = plan, turned = plan;
    beside.options.park.x += 2;
    turned.options.park.heading += 0.25;
    EXPECT_EQ(fault_of(beside),
              "the drive does not begin where the robot is parked (2.000 m off, allowed 0.001 m)");
    EXPECT_EQ(fault_of(turned),
              "the drive does not begin where the robot is parked (0.250 radians off, allowed 0.001)");
}

TEST(Parts, NoPartOfSeveralStrokesTakesLongerThanAsked) {
    for (const char* exit : {"none", "parked"}) {
        const Plan plan = parked_plan(true, exit);
        const double whole = plan.samples.back().t;
        for (double seconds = 5; seconds < whole + 10; seconds += 1.7) {
            const std::vector<int> begins = cuts(plan, {.seconds = seconds});
            EXPECT_EQ(begins.size() == 1, seconds >= whole);
            for (std::size_t k = 0; k < begins.size(); ++k) {
                const int end = k + 1 < begins.size() ? begins[k + 1] : 4;
                EXPECT_TRUE(part(plan, begins[k], end).figures.time <= seconds || end == begins[k] + 1)
                    << seconds << " s: " << begins[k] << " to " << end;
                // And none is shorter than need be: its next stroke would not have fitted.
                if (end < 4) {
                    EXPECT_GT(part(plan, begins[k], end + 1).figures.time, seconds);
                }
            }
        }
    }
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
