#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "formats/sample_plan.hpp"
#include "result/formats/formats.hpp"

namespace strandline {
namespace {

using testing::sample_plan;

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}
std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
    return n;
}
struct TextLine {
    Point at;
    int rake = -1;
};
std::vector<TextLine> robot_text(const std::string& text) {
    std::vector<TextLine> list;
    for (const std::string& line : lines_of(text)) {
        TextLine read;
        EXPECT_EQ(std::sscanf(line.c_str(), "%lf %lf %d", &read.at.x, &read.at.y, &read.rake), 3) << line;
        list.push_back(read);
    }
    return list;
}

TEST(Beachbot, BothFilesHoldTheSameInstantsAndMasks) {
    const auto pair = formats::write_beachbot(sample_plan());
    const auto robot = robot_text(pair.robot), rake = robot_text(pair.rake);
    ASSERT_EQ(robot.size(), rake.size());
    for (std::size_t i = 0; i < robot.size(); ++i) {
        EXPECT_EQ(robot[i].rake, rake[i].rake);
        EXPECT_NEAR(distance(robot[i].at, rake[i].at), 0.2, 2e-6) << "line " << i << ": the rake trails by L";
    }
    EXPECT_EQ(robot.front().rake, 8);
    EXPECT_EQ(lines_of(pair.robot).front(), "2.200000 2.000000 8");
}

TEST(Beachbot, ATurnOnTheSpotIsOneLineAndTheEndIsMarked) {
    const auto robot = robot_text(formats::write_beachbot(sample_plan()).robot);
    EXPECT_EQ(std::ranges::count(robot, 128, &TextLine::rake), 1);
    EXPECT_EQ(std::ranges::count(robot, 129, &TextLine::rake), 1);
    EXPECT_EQ(robot.back().rake, 129);
    const auto turn = std::ranges::find(robot, 128, &TextLine::rake);
    EXPECT_NEAR(distance(turn->at, {2.8, 3}), 0, 1e-5);
    EXPECT_EQ(std::next(turn)->at, turn->at) << "the drive goes on from where it turned";
}

TEST(Beachbot, PointsAreAtMostFiveCentimetresApartHoweverWideTheSamplesAre) {
    Plan plan = sample_plan();
    std::vector<Sample> few;  // every eighth sample, turns and changes of the mask kept
    for (std::size_t i = 0; i < plan.samples.size(); ++i)
        if (i % 8 == 0 || i + 1 == plan.samples.size() || plan.samples[i].motion == Motion::pivot ||
            plan.samples[i].motion != plan.samples[i - 1].motion)
            few.push_back(plan.samples[i]);
    plan.samples = few;
    const auto pair = formats::write_beachbot(plan);
    for (const std::string& text : {pair.robot, pair.rake}) {
        const auto lines = robot_text(text);
        for (std::size_t i = 1; i < lines.size(); ++i)
            EXPECT_TRUE(lines[i - 1].rake == 128 || distance(lines[i - 1].at, lines[i].at) < 0.05 + 2e-6)
                << i;
    }
}

TEST(Beachbot, MinusZeroIsWrittenAsZero) {
    Plan plan = sample_plan();
    plan.samples.resize(2);
    plan.samples[0].pose.at = {-0.0, -1e-9};
    const std::string text = formats::write_beachbot(plan).robot;
    EXPECT_TRUE(text.starts_with("0.000000 0.000000 8\n")) << text;
}

TEST(Beachbot, OnePinIsTheMiddleOneAndMoreThanSevenNeverReachTheMarks) {
    Plan plan = sample_plan();
    plan.robot.pins = 1;
    for (Sample& sample : plan.samples) sample.mask = sample.mask ? 1 : 0;
    EXPECT_EQ(robot_text(formats::write_beachbot(plan).rake).front().rake, 8);
    plan.robot.pins = 15;
    for (Sample& sample : plan.samples) sample.mask = sample.mask ? 0x7FFF : 0;
    EXPECT_EQ(robot_text(formats::write_beachbot(plan).rake).front().rake, 127);
}

TEST(Beachbot, APlanWithoutSamplesGivesEmptyFiles) { EXPECT_EQ(formats::write_beachbot(Plan{}).robot, ""); }

TEST(Trace, HoldsTargetsDrawMovesAndOneTravelMoveBetweenThem) {
    const std::string trace = formats::write_trace(sample_plan(), false);
    EXPECT_EQ(count(trace, "\"kind\": \"draw\""), 4U);
    EXPECT_EQ(count(trace, "\"kind\": \"travel\""), 3U);
    EXPECT_EQ(count(trace, "\"fill\": true, \"width\": 0.42"), 2U);
    EXPECT_EQ(count(trace, "\"closed\": false"), 2U);
    EXPECT_EQ(count(trace, "\"outer\""), 1U);
    EXPECT_NE(trace.find("\"curvature_limit\": 2,"), std::string::npos);
    EXPECT_NE(trace, formats::write_trace(sample_plan(), true));
    Plan plotter = sample_plan();
    plotter.robot.min_radius = 0;
    EXPECT_NE(formats::write_trace(plotter, false).find("\"curvature_limit\": null"), std::string::npos);
}

/// The judge's own figures of a trace, as text.
std::string judged(const std::string& trace) {
    const auto folder = std::filesystem::temp_directory_path() / "strandline-trace-test";
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "trace.json").string();
    std::ofstream(file) << trace;
    const std::string command =
        "/usr/bin/python3 " STRANDLINE_SHARED "/judge/trace/metrics.py " + file + " 2>&1";
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    while (pipe && std::fgets(buffer, sizeof buffer, pipe)) output += buffer;
    EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << output;
    return output;
}
double figure(const std::string& report, const std::string& name) {
    const auto at = report.find("  " + name + " ");
    EXPECT_NE(at, std::string::npos) << name << report;
    return at == std::string::npos ? -1 : std::stod(report.substr(at + 2 + name.size()));
}

TEST(Trace, TheJudgeMeasuresWhatWasDriven) {
    if (!std::filesystem::exists(STRANDLINE_SHARED "/judge/trace/metrics.py"))
        GTEST_SKIP() << "no judge here";
    const std::string rake = judged(formats::write_trace(sample_plan(), false));
    EXPECT_EQ(figure(rake, "n_bad_moves"), 0);
    EXPECT_NEAR(figure(rake, "draw_len"), 13.6, 0.002);
    EXPECT_NEAR(figure(rake, "fill_len"), 6.2, 0.002);
    const std::string robot = judged(formats::write_trace(sample_plan(), true));
    EXPECT_NEAR(figure(robot, "travel_len"), pi + 2.4, 0.002);
    EXPECT_NEAR(figure(robot, "kmax"), 2, 0.01) << "measured on chords of 5 cm";
    EXPECT_EQ(figure(robot, "k_over"), 0);
    EXPECT_NEAR(figure(robot, "join_max_deg"), 90, 1) << "the turn on the spot";
}

TEST(PlanSvg, DrawsGroovesAtTrueWidthAndEverythingWithYDown) {
    const std::string svg = formats::write_svg(sample_plan());
    EXPECT_EQ(count(svg, "<path stroke-width=\"42.00\""), 2U) << "seven pins, in centimetres";
    EXPECT_EQ(count(svg, "<path stroke-width=\"18.00\""), 1U);
    EXPECT_EQ(count(svg, "<path stroke-width=\"6.00\""), 1U);
    for (const char* part :
         {"stroke-linecap=\"butt\"", "<title id=\"title\">two lines and a &quot;door&quot; &lt;é>",
          "<desc id=\"desc\">", "id=\"rake-up\"", "id=\"arrows\"", "id=\"legend\"", "<circle", ">2 m<",
          "id=\"field\""})
        EXPECT_EQ(count(svg, part) > 0, true) << part;
    EXPECT_EQ(svg, formats::write_svg(sample_plan()));
    // Line 1 lies a metre higher on the canvas than line 0: further up in the picture is a smaller y.
    const auto y_of = [&](const std::string& width) {
        double x = 0, y = 0;
        const auto at = svg.find("<path stroke-width=\"" + width);
        std::sscanf(svg.c_str() + svg.find(" d=\"M", at) + 5, "%lf %lf", &x, &y);
        return y;
    };
    EXPECT_NEAR(y_of("6.00") - y_of("18.00"), 100, 0.2);
}

TEST(PlanSvg, OnASheetOfPaperHalfAMillimetreIsStillAWidth) {
    Plan plan = sample_plan();
    plan.robot.pin_pitch = 0.0005;
    plan.drawing.canvas = {0.297, 0.21};
    for (Sample& sample : plan.samples) sample.rake = 0.02 * sample.rake;
    EXPECT_EQ(count(formats::write_svg(plan), "<path stroke-width=\"5.00\""), 1U) << "tenths of a millimetre";
}

TEST(Csv, HasALineASampleAndArcLengthThatGrowsAsTheRobotDrives) {
    const auto lines = lines_of(formats::write_csv(sample_plan()));
    ASSERT_EQ(lines.size(), sample_plan().samples.size() + 1);
    EXPECT_EQ(lines[0], "s,t,x,y,heading,curvature,v,omega,pins,rake_x,rake_y,motion,stroke,told");
    EXPECT_EQ(lines[1],
              "0.000000,0.000000,2.200000,2.000000,0.000000,0.000000,0.200000,0.000000,8,2.000000,2.000000,"
              "draw,0,8");
    EXPECT_NEAR(std::stod(lines.back()), 13.6 + pi + 2.4, 1e-5) << "arcs, not chords";
}

TEST(Figures, AreOneJsonObjectWithAKeyALine) {
    const std::string text = formats::write_figures(sample_plan());
    EXPECT_EQ(text.substr(0, 2), "{\n");
    EXPECT_NE(text.find("\"strokes\": 4,\n"), std::string::npos);
    EXPECT_NE(text.find("\"one corner is rounded\""), std::string::npos);
    EXPECT_EQ(text.substr(text.size() - 3), "\n}\n");
}

}  // namespace
}  // namespace strandline
