#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cstdint>
#include <random>

#include "formats/sample_plan.hpp"
#include "result/formats/formats.hpp"

namespace strandline {
namespace {

using testing::sample_plan;

Plan read_back(const Plan& plan) {
    const auto again = formats::read_plan(formats::write_plan(plan), "again");
    if (!again) ADD_FAILURE() << sentence(again.error());
    return again.value_or(Plan{});
}

/// Any finite double: every exponent, subnormals and both zeros too.
double any_double(std::mt19937_64& random) {
    for (;;)
        if (const double value = std::bit_cast<double>(random()); std::isfinite(value)) return value;
}
int up_to(std::mt19937_64& random, int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most + 1));
}
Point any_point(std::mt19937_64& random) { return {any_double(random), any_double(random)}; }
std::string any_text(std::mt19937_64& random) {
    std::string text;
    for (int n = up_to(random, 8); n > 0; --n)
        text += std::vector<std::string>{
            "a", "\"", "\\", "\n", "\x01", "é", "€", "\U0001F600", "/", "~"}[random() % 10];
    return text;
}
Path any_path(std::mt19937_64& random) {
    Path path{any_point(random), {}, random() % 2 == 0};
    for (int n = up_to(random, 5); n > 0; --n) {
        const auto point = [&] { return any_point(random); };
        if (random() % 3 == 0)
            path.segments.push_back(LineSegment{point()});
        else if (random() % 2 == 0)
            path.segments.push_back(CubicSegment{point(), point(), point()});
        else
            path.segments.push_back(
                ArcSegment{point(), point(), point(), any_double(random), any_double(random), point()});
    }
    return path;
}
Curve any_curve(std::mt19937_64& random) {
    Curve curve{{any_point(random), any_double(random)}, {}};
    for (int n = up_to(random, 4); n > 0; --n)
        curve.pieces.push_back({std::abs(any_double(random)), any_double(random), any_double(random)});
    return curve;
}
/// The sample plan with every number and text that may be anything replaced.
Plan any_plan(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Plan plan = sample_plan();
    plan.title = any_text(random);
    plan.drawing.to_canvas.e = any_double(random);
    if (random() % 2) plan.drawing.start.reset();
    if (random() % 2) plan.drawing.scale_denominator.reset();
    for (Element& element : plan.drawing.elements) {
        element.id = any_text(random);
        if (auto* line = std::get_if<LineElement>(&element.what)) line->path = any_path(random);
    }
    for (Stroke& stroke : plan.strokes) {
        stroke.rake_path.clear();
        for (int n = up_to(random, 3); n > 0; --n) stroke.rake_path.push_back(any_curve(random));
        stroke.nodes.assign(3, {any_double(random), any_point(random), up_to(random, 9)});
        stroke.closed = random() % 2;
    }
    for (Entry& entry : plan.order) entry = {up_to(random, 3), up_to(random, 2), random() % 2 == 0};
    for (PlannedConnection& connection : plan.connections) connection.curve = any_curve(random);
    plan.samples.resize(static_cast<std::size_t>(up_to(random, 40)));
    for (Sample& sample : plan.samples)
        sample = {any_double(random),
                  {any_point(random), any_double(random)},
                  any_double(random),
                  any_double(random),
                  any_double(random),
                  any_point(random),
                  static_cast<unsigned>(random()),
                  static_cast<Motion>(up_to(random, 4)),
                  up_to(random, 4) - 1};
    plan.figures.drawn = any_double(random);
    plan.warnings.assign(2, {any_text(random), any_text(random)});
    for (const Setting& setting : settings()) {
        const auto field = setting.field(plan.options);
        if (auto* const* number = std::get_if<double*>(&field))
            **number =
                setting.low + (setting.high - setting.low) * (static_cast<double>(random() >> 11) * 0x1p-53);
        else if (auto* const* flag = std::get_if<bool*>(&field))
            **flag = random() % 2;
        else if (auto* const* word = std::get_if<std::string*>(&field))
            **word = setting.kind != Setting::Kind::text ? setting.choices[random() % setting.choices.size()]
                     : setting.key.starts_with("field.")
                         ? "0,0 2,0 1," + std::to_string(1 + random() % 100)
                         : "id=" + std::to_string(random() % 100) + ": tool=2";
    }
    return plan;
}

TEST(PlanFile, WhatIsWrittenReadBackIsTheSamePlan) { EXPECT_EQ(read_back(sample_plan()), sample_plan()); }

TEST(PlanFile, AnEmptyPlanReadsBack) { EXPECT_EQ(read_back(Plan{}), Plan{}); }

TEST(PlanFile, AnyPlanReadsBackBitForBit) {
    EXPECT_TRUE(rc::check("round trip", [](std::uint64_t seed) {
        const Plan plan = any_plan(seed);
        const std::string text = formats::write_plan(plan);
        const auto again = formats::read_plan(text, "");
        // The text tells -0 from 0, which == does not.
        return again && *again == plan && formats::write_plan(*again) == text;
    }));
}

TEST(PlanFile, MinusZeroAndTheSmallestNumbersKeepTheirBits) {
    Plan plan = sample_plan();
    plan.samples.resize(3);
    plan.samples[0].pose.at.x = -0.0;
    plan.samples[1].pose.at.x = 5e-324;
    plan.samples[2].pose.at.x = 0.1 + 0.2;
    const Plan again = read_back(plan);
    ASSERT_EQ(again.samples.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(again.samples[i].pose.at.x),
                  std::bit_cast<std::uint64_t>(plan.samples[i].pose.at.x));
}

TEST(PlanFile, BytesThatAreNotUtf8AreReplacedSoThatTheFileCanBeRead) {
    Plan plan = sample_plan();
    plan.title = "caf\xE9 \xC3";
    EXPECT_EQ(read_back(plan).title, "caf\xEF\xBF\xBD \xEF\xBF\xBD");
}

TEST(PlanFile, HasOneTopLevelKeyALineSoThatPlansCanBeCompared) {
    Plan other = sample_plan();
    other.figures.time += 1;
    const auto lines = [](const std::string& text) {
        std::vector<std::string> list{""};
        for (const char c : text) c == '\n' ? list.push_back("") : list.back().push_back(c);
        return list;
    };
    const auto a = lines(formats::write_plan(sample_plan())), b = lines(formats::write_plan(other));
    ASSERT_EQ(a.size(), b.size());
    int different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
    EXPECT_EQ(different, 1);
}

}  // namespace
}  // namespace strandline
