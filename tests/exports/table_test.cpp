#include <locale>
#include <set>

#include "exports/drive.hpp"
#include "result/exports/exports.hpp"
#include "result/formats/formats.hpp"

namespace strandline {
namespace {

using namespace testing;

const exports::Format& format(const std::string& name) {
    const auto& all = exports::table();
    return *std::ranges::find(all, name, &exports::Format::name);
}
std::string first_file(const std::string& name, const Plan& plan) {
    const auto written = format(name).write(plan, {});
    EXPECT_TRUE(written) << name;
    return written ? written->files.at(0).bytes : "";
}

/// Numbers as in much of Europe: 1.234,5.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Exports, NamesAreUniqueAndFilesAreTheOnesTheTablePromises) {
    std::set<std::string> names;
    for (const exports::Format& f : exports::table()) {
        EXPECT_TRUE(names.insert(f.name).second) << f.name;
        const auto written = f.write(beach_plan(), {});
        ASSERT_TRUE(written) << f.name;
        ASSERT_EQ(written->files.size(), f.suffixes.size()) << f.name;
        for (std::size_t k = 0; k < f.suffixes.size(); ++k) {
            EXPECT_EQ(written->files[k].suffix, f.suffixes[k]);
            EXPECT_FALSE(written->files[k].bytes.empty());
        }
    }
}

TEST(Exports, AreTheSameBytesInAnyLocale) {
    std::vector<std::string> before;
    for (const exports::Format& f : exports::table()) before.push_back(first_file(f.name, beach_plan()));
    const std::locale classic = std::locale::global(std::locale(std::locale(), new DecimalComma));
    for (std::size_t k = 0; k < before.size(); ++k)
        EXPECT_EQ(first_file(exports::table()[k].name, beach_plan()), before[k]) << exports::table()[k].name;
    std::locale::global(classic);
}

TEST(Exports, OnlyWhatConcernsThemCanBeSetLate) {
    Options options;
    EXPECT_TRUE(exports::set_for_export(options, "site.latitude", "47.37"));
    EXPECT_TRUE(options.site.known);
    const auto late = exports::set_for_export(options, "fill.style", "zigzag");
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().place, "fill.style");
    EXPECT_FALSE(exports::set_for_export(options, "mission.nonsense", "1"));
    Options other;
    other.fill.style = "zigzag";
    exports::take_export_options(other, options);
    EXPECT_EQ(other.site, options.site);
    EXPECT_EQ(other.fill.style, "zigzag");
}

TEST(Csv, ReadBackByTheSimulatorsReaderItIsTheDrive) {
    const Plan plan = beach_plan();
    const auto read = formats::read_drive_csv(first_file("csv", plan), plan.robot, "drive.csv");
    ASSERT_TRUE(read) << sentence(read.error());
    ASSERT_EQ(read->size(), plan.samples.size());
    for (std::size_t i = 0; i < read->size(); ++i) {
        EXPECT_LT(distance((*read)[i].pose.at, plan.samples[i].pose.at), 2e-6);
        EXPECT_LT(distance((*read)[i].rake, plan.samples[i].rake), 2e-6);
        EXPECT_EQ((*read)[i].mask, plan.samples[i].mask);
    }
}

TEST(Beachbot, ReadBackThePairIsTheDrive) {
    const Plan plan = beach_plan();
    const auto written = format("beachbot").write(plan, {});
    ASSERT_TRUE(written);
    const auto read =
        formats::read_beachbot(written->files[0].bytes, written->files[1].bytes, plan.robot, "robot", "rake");
    ASSERT_TRUE(read) << sentence(read.error());
    Plan same = plan;
    same.samples = *read;
    Polyline planned, robot;
    for (const Sample& sample : plan.samples) planned.push_back(sample.pose.at);
    for (const Sample& sample : same.samples) robot.push_back(sample.pose.at);
    EXPECT_LT(apart(robot, planned), millimetre);
}

TEST(Svg, ReadBackItsGroovesAreWhereTheRakeWas) {
    const Plan plan = beach_plan();
    std::vector<Track> read;
    Point corner;  // of the canvas, upper left
    for (const std::string& line : lines_of(first_file("svg", plan))) {
        // centimetres, y down: the canvas, then one path a groove, its points after M and L
        double side = 0;
        Point low;
        if (std::sscanf(line.c_str(), "<rect x=\"%lf\" y=\"%lf\" width=\"%lf\"", &low.x, &low.y, &side) ==
                3 &&
            side == 1000)
            corner = low;
        const auto at = line.find(" d=\"M");
        if (line.find("<path stroke-width=") == std::string::npos || at == std::string::npos) continue;
        std::string points = line.substr(at + 5, line.find('"', at + 5) - at - 5);
        std::ranges::replace_if(
            points, [](char c) { return c == 'L' || c == ','; }, ' ');
        std::istringstream in(points);
        read.push_back({true, {}});
        for (Point p; in >> p.x >> p.y;)
            read.back().points.push_back({(p.x - corner.x) / 100, 10 - (p.y - corner.y) / 100});
    }
    expect_same(read, only_down(tracks_of(plan, true)), millimetre);
}

}  // namespace
}  // namespace strandline
