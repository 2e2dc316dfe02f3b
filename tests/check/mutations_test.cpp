#include "check/mutations.hpp"

#include <gtest/gtest.h>

#include "check/valid_plan.hpp"

namespace strandline {
namespace {

using check::Law;
using check::Report;

std::string told(const Report& report) {
    std::string text;
    for (const check::Fault& f : report.faults)
        text += std::string(check::name_of(f.law)) + " at sample " + std::to_string(f.sample) + ": " +
                f.what + "\n";
    return text;
}
bool names(const Report& report, Law law) {
    return std::ranges::any_of(report.faults, [&](const check::Fault& f) { return f.law == law; });
}

/// The same plan on another part of the field, turned or mirrored.
Plan moved(Plan plan, double turn, bool mirror, Point by) {
    const double c = std::cos(turn), s = std::sin(turn), m = mirror ? -1 : 1;
    const Affine map = composed({c, s, -s, c, 7 + by.x, 7 + by.y}, {1, 0, 0, m, -7, -7 * m});
    const auto place = [&](Pose pose) { return Pose{apply(map, pose.at), m * pose.heading + turn}; };
    const auto curve = [&](Curve& k) {
        k.start = place(k.start);
        for (Clothoid& piece : k.pieces) piece = {piece.length, m * piece.curvature, m * piece.sharpness};
    };
    for (Sample& sample : plan.samples) {
        sample.pose = place(sample.pose);
        sample.rake = apply(map, sample.rake);
        sample.curvature *= m;
        sample.turn_rate *= m;
    }
    for (Stroke& stroke : plan.strokes)
        for (Curve& k : stroke.rake_path) curve(k);
    for (PlannedConnection& connection : plan.connections) curve(connection.curve);
    for (Element& element : plan.drawing.elements) {
        if (auto* line = std::get_if<LineElement>(&element.what)) {
            line->path = transformed(line->path, map);
            continue;
        }
        Region& region = std::get<RegionElement>(element.what).region;
        for (Point& p : region.outer) p = apply(map, p);
        if (mirror) std::ranges::reverse(region.outer);
    }
    return plan;
}

TEST(Check, AValidPlanHasNoFaultWhereverItLies) {
    for (const bool mirror : {false, true})
        for (double turn : {0.0, 0.7, pi / 2, 3.0}) {
            const Report report = check::prove(moved(by_hand::raked_plan(), turn, mirror, {0.4, -0.3}));
            EXPECT_TRUE(report.sound()) << told(report);
            EXPECT_TRUE(report.blemishes.empty());
        }
}

TEST(Check, FiguresAreMeasuredFromTheSamples) {
    Plan plan = by_hand::raked_plan();
    plan.figures = {};
    const Report report = check::prove(plan);
    EXPECT_NEAR(report.drawn, 2.0 + 1.2 + 3 * 1.6, 1e-3);
    EXPECT_NEAR(report.time, plan.samples.back().t, 1e-9);
    EXPECT_NEAR(report.coverage, 1, 1e-3);
    EXPECT_NEAR(report.max_curvature_up, 0.98 / 0.5, 1e-3);
    EXPECT_NEAR(report.max_sharpness_up, 9.8, 0.05);
    EXPECT_LT(report.worst_offset, 0.001);
    EXPECT_GT(report.up_driven, 5);
}

class Mutated : public testing::TestWithParam<mutations::Mutation> {};

TEST_P(Mutated, PlanIsNamedByItsLaw) {
    const mutations::Mutation& mutation = GetParam();
    const Report before = check::prove(by_hand::raked_plan());
    const Report after = check::prove(mutation.apply(by_hand::raked_plan()));
    ASSERT_TRUE(before.sound());
    if (mutation.listed)
        EXPECT_GT(after.crossings, before.crossings);
    else
        EXPECT_TRUE(names(after, mutation.law)) << told(after);
    EXPECT_LT(after.faults.size(), 25u) << "neighbouring samples are one fault\n" << told(after);
}

std::string test_name(const testing::TestParamInfo<mutations::Mutation>& info) {
    std::string name;
    for (char c : info.param.name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
    return name;
}
INSTANTIATE_TEST_SUITE_P(Twelve, Mutated, testing::ValuesIn(mutations::twelve()), test_name);
INSTANTIATE_TEST_SUITE_P(More, Mutated, testing::ValuesIn(mutations::more()), test_name);

TEST(Check, ASmallMutationIsNamedByItsLawAlone) {
    const auto laws = [](const Report& report) {
        std::vector<Law> all;
        for (const check::Fault& f : report.faults)
            if (std::ranges::find(all, f.law) == all.end()) all.push_back(f.law);
        return all;
    };
    EXPECT_EQ(laws(check::prove(mutations::pins_early(by_hand::raked_plan()))), std::vector{Law::pins});
    EXPECT_EQ(laws(check::prove(mutations::old_version(by_hand::raked_plan()))), std::vector{Law::version});
    EXPECT_EQ(laws(check::prove(mutations::not_a_number(by_hand::raked_plan()))), std::vector{Law::finite});
    EXPECT_EQ(laws(check::prove(mutations::wrong_offset(by_hand::raked_plan()))).front(), Law::drawn_right);
}

TEST(Check, ARunOfBadSamplesIsOneFaultAtItsWorst) {
    Plan plan = by_hand::raked_plan();
    const std::size_t i = mutations::drawing(plan) + 4;
    for (std::size_t k = i - 3; k <= i + 3; ++k) plan.samples[k].mask = 0;
    plan.samples[i].speed = 0.5;
    plan.samples[i + 1].speed = 0.4;
    const Report report = check::prove(plan);
    EXPECT_EQ(std::ranges::count(report.faults, Law::pins, &check::Fault::law), 1);
    ASSERT_EQ(std::ranges::count(report.faults, Law::speed, &check::Fault::law), 1);
    EXPECT_EQ(std::ranges::find(report.faults, Law::speed, &check::Fault::law)->sample, static_cast<int>(i));
}

}  // namespace
}  // namespace strandline
