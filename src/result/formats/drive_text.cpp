// Drives of any origin: the pair of 2014 and CSV, read; and how a simulated drive went, written.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text/text.hpp"
#include "base/units/units.hpp"
#include "result/formats/formats.hpp"

namespace strandline::formats {
namespace {

constexpr int text_pins = 7;
constexpr unsigned turn_here = 128, end_here = 129;
/// Radians between samples of a turn on the spot.
constexpr double turn_step = 0.1;

/// The next line, without its end; nothing is left behind the last.
std::optional<std::string_view> next_line(std::string_view& rest) {
    if (rest.empty()) return std::nullopt;
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}
std::vector<std::string_view> words_of(std::string_view line, std::string_view between) {
    std::vector<std::string_view> words;
    const bool blanks = between.find(' ') != std::string_view::npos;
    while (true) {
        if (blanks) line.remove_prefix(std::min(line.find_first_not_of(between), line.size()));
        if (blanks && line.empty()) return words;
        const std::size_t end = line.find_first_of(between);
        words.push_back(line.substr(0, end));
        if (end == std::string_view::npos) return words;
        line.remove_prefix(end + 1);
    }
}
std::optional<double> number_in(std::string_view word) {
    while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
    while (!word.empty() && word.back() == ' ') word.remove_suffix(1);
    const auto value = parse_number(word, "");
    return value ? std::optional(*value) : std::nullopt;
}
std::string line_name(const std::string& place, std::size_t line) {
    return fmt::format("{}, line {}", place, line);
}

/// A mask of the text's seven pins as one of the robot's own: the inverse of what is written.
unsigned from_seven(unsigned seven, int pins) {
    if (pins <= text_pins) return (seven >> (text_pins - pins) / 2) & ((1U << pins) - 1U);
    unsigned mask = 0;
    for (int pin = 0; pin < pins; ++pin) {
        const int bit = std::min(text_pins - 1, static_cast<int>((pin + 0.5) * text_pins / pins));
        mask |= ((seven >> bit) & 1U) << pin;
    }
    return mask;
}

struct TextLine {
    Point at;
    unsigned column = 0;
};
Outcome<std::vector<TextLine>> lines_of(std::string_view text, const std::string& place) {
    std::vector<TextLine> lines;
    std::size_t number = 0;
    while (const auto line = next_line(text)) {
        ++number;
        const auto words = words_of(*line, " \t,;");
        if (words.empty() || words.front().starts_with('#')) continue;
        const auto x = number_in(words[0]), y = words.size() > 1 ? number_in(words[1]) : std::nullopt,
                   column = words.size() > 2 ? number_in(words[2]) : std::nullopt;
        if (words.size() != 3 || !x || !y || !column || *column < 0 || *column > end_here ||
            *column != std::floor(*column))
            return fail(line_name(place, number), "is not \"x y rake\"",
                        "metres, and 0 to 127 for the pins, 128 for a turn on the spot, 129 for the end");
        lines.push_back({{*x, *y}, static_cast<unsigned>(*column)});
    }
    if (lines.size() < 2) return fail(place, "has fewer than two lines", "a drive begins and ends somewhere");
    return lines;
}

/// Gives samples their times, as texts without time are driven: at the robot's speeds.
void time_evenly(std::vector<Sample>& samples, const Robot& robot) {
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        Sample &a = samples[i], &b = samples[i + 1];
        const double step = distance(a.pose.at, b.pose.at);
        const double turn = std::abs(wrap_angle(b.pose.heading - a.pose.heading));
        a.speed = a.mask != 0 ? robot.speed : robot.travel_speed;
        b.t = a.t + std::max(step / a.speed, turn / robot.turn_rate);
    }
}

struct Column {
    const char* name;
    int at = -1;
};

}  // namespace

Outcome<std::vector<Sample>> read_beachbot(std::string_view robot_text, std::string_view rake_text,
                                           const Robot& robot, const std::string& robot_place,
                                           const std::string& rake_place) {
    const auto p = lines_of(robot_text, robot_place);
    if (!p) return tl::unexpected(p.error());
    const auto q = lines_of(rake_text, rake_place);
    if (!q) return tl::unexpected(q.error());
    if (p->size() != q->size())
        return fail(rake_place, fmt::format("has {} lines, {} has {}", q->size(), robot_place, p->size()),
                    "both files of a pair tell the same instants");
    std::vector<Sample> samples;
    double looks = 0;
    for (std::size_t i = 0; i < p->size(); ++i) {
        const TextLine &here = (*p)[i], &rake = (*q)[i];
        // The robot looks from its rake to its turning point; a tool at the turning point looks where it
        // goes.
        const std::size_t ahead = std::min(i + 1, p->size() - 1);
        const Point along = robot.rake_offset > 0 ? here.at - rake.at : (*p)[ahead].at - here.at;
        const double heading_here = along == Point{} ? looks : heading(along);
        if (i > 0 && (*p)[i - 1].column == turn_here) {
            const Sample from = samples.back();
            const double turn = wrap_angle(heading_here - from.pose.heading);
            const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / turn_step)));
            for (int k = 1; k < parts; ++k) {
                Sample between = from;
                between.pose.heading = wrap_angle(from.pose.heading + turn * k / parts);
                between.rake = rake_at(robot, between.pose);
                samples.push_back(between);
            }
        }
        looks = heading_here;
        Sample sample;
        sample.pose = {here.at, heading_here};
        sample.rake = rake.at;
        sample.motion = here.column == turn_here ? Motion::pivot : Motion::connect;
        if (here.column < turn_here) sample.mask = from_seven(here.column, robot.pins);
        if (sample.mask != 0) sample.motion = Motion::draw;
        samples.push_back(sample);
    }
    time_evenly(samples, robot);
    return samples;
}

Outcome<std::vector<Sample>> read_drive_csv(std::string_view text, const Robot& robot,
                                            const std::string& place) {
    std::vector<Column> columns{{"x"}, {"y"}, {"pins"}, {"heading"}, {"t"}, {"rake_x"}, {"rake_y"}};
    std::vector<Sample> samples;
    std::size_t number = 0;
    bool titled = false;
    while (const auto line = next_line(text)) {
        ++number;
        const auto words = words_of(*line, ",");
        if (line->empty() || line->starts_with('#')) continue;
        if (!titled) {
            for (Column& column : columns) {
                const auto found = std::ranges::find(words, column.name);
                if (found != words.end()) column.at = static_cast<int>(found - words.begin());
            }
            for (std::size_t k = 0; k < 3; ++k)
                if (columns[k].at < 0)
                    return fail(line_name(place, number), fmt::format("has no column {}", columns[k].name),
                                "the first line names the columns: x,y,pins, and heading, t, rake_x, rake_y "
                                "where known");
            titled = true;
            continue;
        }
        std::vector<std::optional<double>> value;
        for (const Column& column : columns) {
            value.push_back(column.at >= 0 && static_cast<std::size_t>(column.at) < words.size()
                                ? number_in(words[static_cast<std::size_t>(column.at)])
                                : std::nullopt);
            if (column.at >= 0 && !value.back())
                return fail(line_name(place, number), fmt::format("has no number in column {}", column.name),
                            "every line has a number for every column");
        }
        Sample sample;
        sample.pose = {{*value[0], *value[1]}, value[3].value_or(0)};
        sample.mask =
            static_cast<unsigned>(std::clamp(*value[2], 0.0, 4294967295.0)) & pin_mask(robot, robot.pins);
        sample.motion = sample.mask != 0 ? Motion::draw : Motion::connect;
        sample.t = value[4].value_or(0);
        if (value[5] && value[6]) sample.rake = {*value[5], *value[6]};
        samples.push_back(sample);
    }
    if (samples.size() < 2)
        return fail(place, "has fewer than two places", "a drive begins and ends somewhere");
    const bool looks = columns[3].at >= 0, raked = columns[5].at >= 0 && columns[6].at >= 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        Sample& sample = samples[i];
        if (!looks) {
            const Point along = raked && robot.rake_offset > 0
                                    ? sample.pose.at - sample.rake
                                    : samples[std::min(i + 1, samples.size() - 1)].pose.at - sample.pose.at;
            sample.pose.heading = along == Point{} && i > 0 ? samples[i - 1].pose.heading : heading(along);
        }
        if (!raked) sample.rake = rake_at(robot, sample.pose);
    }
    if (columns[4].at < 0) time_evenly(samples, robot);
    return samples;
}

std::string write_log(const tracking::Driven& driven) {
    Text text;
    add(text,
        "t,planned_t,x,y,heading,believed_x,believed_y,believed_heading,planned_x,planned_y,"
        "planned_heading,v,omega,pins,rake_x,rake_y,off\n");
    for (const tracking::LogLine& line : driven.log) {
        bool first = true;
        for (const double value :
             {line.t, line.planned_t, line.real.at.x, line.real.at.y, line.real.heading, line.believed.at.x,
              line.believed.at.y, line.believed.heading, line.planned.at.x, line.planned.at.y,
              line.planned.heading, line.speed, line.turn_rate, static_cast<double>(line.mask), line.rake.x,
              line.rake.y, line.off}) {
            if (!first) add(text, ",");
            first = false;
            add_number(text, value);
        }
        add(text, "\n");
    }
    return text;
}

}  // namespace strandline::formats
