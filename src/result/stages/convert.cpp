// CSV of a rake path -> CSV of the robot path that makes the rake follow it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/units/units.hpp"
#include "result/stages/points_curve.hpp"
#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

constexpr std::string_view rake_header = "x,y,pins";
// Farther out (metres) a double no longer holds a fraction of a millimetre with room to compute.
constexpr double farthest = 1e6;
// A path of hundreds of kilometres takes longer steps: only the states at the rows are asked for, and steps
// end on them.
constexpr double most_steps = 2e5;
// States are found again by the rake's arc length, which both sides add up in their own order (metres).
constexpr double same_s = 1e-7;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

bool is_header(std::string_view line) {
    std::string bare;
    std::copy_if(line.begin(), line.end(), std::back_inserter(bare),
                 [](char c) { return c != ' ' && c != '\t'; });
    return bare == rake_header;
}

Outcome<RakeRows::Row> read_row(std::string_view line, const std::string& place, const Robot& robot) {
    double values[3];
    for (int column = 0; column < 3; ++column) {
        const std::size_t comma = line.find(',');
        if ((comma == std::string_view::npos) != (column == 2))
            return fail(place, "does not have three columns", "write x,y,pins");
        const auto value = parse_number(trimmed(line.substr(0, comma)), place);
        if (!value) return tl::unexpected(value.error());
        values[column] = *value;
        if (column < 2) line.remove_prefix(comma + 1);
    }
    return rake_row({values[0], values[1]}, values[2], place, robot);
}

/// The last state at or before arc length s: at a corner the one after it.
std::size_t state_index(const Followed& followed, double s) {
    const auto after = std::upper_bound(followed.rake_s.begin(), followed.rake_s.end(), s + same_s);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - followed.rake_s.begin() - 1, 0));
}

std::vector<RobotRow> converted_stroke(const std::vector<RakeRows::Row>& rows, const Robot& robot,
                                       std::size_t row_number, Warnings& warnings) {
    std::vector<Point> points;
    for (const RakeRows::Row& row : rows) points.push_back(row.at);
    const PointsCurve curve = curve_through(points);
    std::vector<RobotRow> result;
    if (curve.curves.empty()) {
        warnings.push_back({fmt::format("row {}", row_number),
                            "a stroke of a single place has no direction: heading 0 is given"});
        for (const RakeRows::Row& row : rows)
            result.push_back({robot_at(robot, row.at, 0), 0, row.pins, row.at});
        return result;
    }
    FollowOptions options;
    // no connection follows here: the end's own steady state, whatever its curvature
    const Clothoid& end = curve.curves.back().pieces.back();
    options.end_delta = steady_delta(robot, end.end_curvature(), options.max_delta);
    options.steady_end = false;
    options.step = std::max(options.step, curve.s.back() / most_steps);
    const Followed followed = robot_path_for(curve.curves, robot, options);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RobotState& state = followed.path[state_index(followed, curve.s[i])];
        result.push_back({state.pose, state.curvature, rows[i].pins, rake_at(robot, state.pose)});
    }
    for (const Followed::Span& span : followed.undrivable) {
        const auto first =
            std::upper_bound(curve.s.begin(), curve.s.end(), span.from + same_s) - curve.s.begin();
        const auto last =
            std::lower_bound(curve.s.begin(), curve.s.end(), span.to - same_s) - curve.s.begin();
        const auto number = static_cast<std::ptrdiff_t>(row_number);
        const std::string place =
            fmt::format("rows {} to {}", number + std::max<std::ptrdiff_t>(first - 1, 0),
                        number + std::min<std::ptrdiff_t>(last, std::ssize(rows) - 1));
        warnings.push_back(
            {place,
             span.to - span.from > same_s
                 ? fmt::format(
                       "the rake cannot follow {:.3f} m of the path: it bends tighter than {} m for too long",
                       span.to - span.from, number_text(robot.rake_offset))
                 : "the rake cannot follow the corner: it turns too far"});
    }
    return result;
}

}  // namespace

Outcome<RakeRows::Row> rake_row(Point at, double pins, const std::string& place, const Robot& robot) {
    if (std::max(std::abs(at.x), std::abs(at.y)) > farthest)
        return fail(place, "is too far from the origin",
                    fmt::format("coordinates are metres, up to {}", farthest));
    const unsigned all_down = pin_mask(robot, robot.pins);
    if (!(pins >= 0 && pins <= all_down && pins == std::floor(pins)))
        return fail(place,
                    fmt::format("pins {} is not a whole number from 0 to {}", number_text(pins), all_down),
                    fmt::format("write how many of the {} pins of {} are down, or their mask", robot.pins,
                                robot.name));
    return RakeRows::Row{at, static_cast<unsigned>(pins)};
}

Outcome<RakeRows> read_rake_csv(std::string_view text, const std::string& place, const Robot& robot) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    RakeRows rows;
    bool new_stroke = true, header = false;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t stop = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, stop));
        text.remove_prefix(std::min(stop + 1, text.size()));
        const std::string where = fmt::format("{}, line {}", place, number);
        if (!header) {
            if (!is_header(line))
                return fail(where, "is not the header", fmt::format("begin with a line \"{}\"", rake_header));
            header = true;
        } else if (line.empty()) {
            new_stroke = true;
        } else {
            const auto row = read_row(line, where, robot);
            if (!row) return tl::unexpected(row.error());
            if (new_stroke) rows.strokes.emplace_back();
            new_stroke = false;
            rows.strokes.back().push_back(*row);
        }
    }
    if (!header) return fail(place, "is empty", fmt::format("begin with a line \"{}\"", rake_header));
    if (rows.strokes.empty())
        return fail(place, "holds no points", "write one point a line below the header");
    return rows;
}

Conversion converted(const RakeRows& rows, const Robot& robot) {
    Conversion conversion;
    std::size_t row_number = 1;
    for (const auto& stroke : rows.strokes) {
        conversion.strokes.push_back(converted_stroke(stroke, robot, row_number, conversion.undrivable));
        row_number += stroke.size();
    }
    return conversion;
}

std::string write_robot_csv(const Conversion& conversion) {
    std::string text = "x,y,theta,kappa,pins,x_rake,y_rake\n";
    for (std::size_t i = 0; i < conversion.strokes.size(); ++i) {
        if (i > 0) text += '\n';
        for (const RobotRow& row : conversion.strokes[i])
            fmt::format_to(std::back_inserter(text), "{:.9f},{:.9f},{:.9f},{:.9f},{},{:.9f},{:.9f}\n",
                           row.pose.at.x, row.pose.at.y, row.pose.heading, row.curvature, row.pins,
                           row.rake.x, row.rake.y);
    }
    return text;
}

}  // namespace strandline::stages
