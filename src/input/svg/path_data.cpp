// The d attribute: SVG 2, chapter 9.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "input/svg/outline.hpp"
#include "input/svg/svg.hpp"

namespace strandline::svg {

namespace {

/// Relative commands add up rounding errors of about 1e-12 of the coordinates; an end that near its start is
/// the start. Without this a closing line of no length would end in a corner of no meaning.
constexpr double same_point = 1e-9;

/// Collects subpaths command by command.
struct Pen {
    std::vector<Path> done;
    Path open;
    Point at;
    double reach = 0;  ///< largest coordinate of the open subpath
    std::size_t segments = 0;

    void lift() {
        segments += open.segments.size();
        if (!open.segments.empty()) done.push_back(std::move(open));
        open = Path{at, {}, false};
        reach = std::max(std::abs(at.x), std::abs(at.y));
    }
    void move(Point to) {
        lift();
        at = open.start = to;
        reach = std::max(std::abs(at.x), std::abs(at.y));
    }
    void arrive(Point to) {
        at = to;
        reach = std::max({reach, std::abs(to.x), std::abs(to.y)});
    }
    void line(Point to) {
        open.segments.emplace_back(LineSegment{to});
        arrive(to);
    }
    void cubic(Point control1, Point control2, Point to) {
        open.segments.emplace_back(CubicSegment{control1, control2, to});
        arrive(to);
    }
    void quadratic(Point control, Point to) {
        cubic(between(at, control, 2.0 / 3.0), between(to, control, 2.0 / 3.0), to);
    }
    void arc(double rx, double ry, double degrees, bool large, bool positive, Point to) {
        append_arc(open, at, rx, ry, degrees, large, positive, to);
        arrive(to);
    }
    void close() {
        const Point start = open.start;
        const double gap = distance(at, start);
        if (open.segments.empty() || gap > same_point * reach)
            open.segments.emplace_back(LineSegment{start});
        else if (gap > 0)
            std::visit([&](auto& segment) { segment.to = start; }, open.segments.back());
        open.closed = true;
        at = start;
        lift();
    }
};

constexpr std::size_t argument_count(char upper) {
    switch (upper) {
        case 'M':
        case 'L':
        case 'T':
            return 2;
        case 'H':
        case 'V':
            return 1;
        case 'S':
        case 'Q':
            return 4;
        case 'C':
            return 6;
        case 'A':
            return 7;
        default:
            return 0;
    }
}

std::string character_text(const Scanner& scanner) {
    const char c = scanner.peek();
    if (scanner.done()) return "the end";
    return c > ' ' && c < 127 ? fmt::format("'{}'", c) : std::string("an odd character");
}

std::string refused_number(const Scanner& scanner) {
    return fmt::format("a number that is not finite or beyond {:g} at character {}", largest_number,
                       scanner.at + 1);
}

struct Reader {
    Scanner scanner;
    Pen pen;
    std::optional<Point> cubic_control, quadratic_control;  ///< of the command just before, for S and T
    Outline result;

    bool stop(ValueState state, std::string_view wanted) {
        result.state = state;
        result.message = state == ValueState::refused
                             ? refused_number(scanner)
                             : fmt::format("{} expected, {} found at character {}", wanted,
                                           character_text(scanner), scanner.at + 1);
        return false;
    }

    /// The numbers of one command; false when one is missing or wrong.
    bool take_arguments(char upper, std::array<double, 7>& v) {
        const std::size_t count = argument_count(upper);
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) skip_separator(scanner);
            if (upper == 'A' && (i == 3 || i == 4)) {  // flags are one character: "a1 1 0 0110 10"
                if (scanner.peek() != '0' && scanner.peek() != '1')
                    return stop(ValueState::malformed, "a flag 0 or 1");
                v[i] = scanner.text[scanner.at++] - '0';
                continue;
            }
            const auto number = take_number(scanner);
            if (number.state != ValueState::good) return stop(number.state, "a number");
            v[i] = number.value;
        }
        return true;
    }

    void draw(char upper, Point base, const std::array<double, 7>& v) {
        const auto point = [&](std::size_t i) { return Point{v[i] + base.x, v[i + 1] + base.y}; };
        std::optional<Point> next_cubic, next_quadratic;
        switch (upper) {
            case 'M':
                pen.move(point(0));
                break;
            case 'L':
                pen.line(point(0));
                break;
            case 'H':
                pen.line({v[0] + base.x, pen.at.y});
                break;
            case 'V':
                pen.line({pen.at.x, v[0] + base.y});
                break;
            case 'C':
                next_cubic = point(2);
                pen.cubic(point(0), point(2), point(4));
                break;
            case 'S':
                next_cubic = point(0);
                pen.cubic(cubic_control ? pen.at + (pen.at - *cubic_control) : pen.at, point(0), point(2));
                break;
            case 'Q':
                next_quadratic = point(0);
                pen.quadratic(point(0), point(2));
                break;
            case 'T':
                next_quadratic = quadratic_control ? pen.at + (pen.at - *quadratic_control) : pen.at;
                pen.quadratic(*next_quadratic, point(0));
                break;
            default:
                pen.arc(v[0], v[1], v[2], v[3] != 0, v[4] != 0, point(5));
                break;
        }
        cubic_control = next_cubic;
        quadratic_control = next_quadratic;
    }

    /// One command letter with all its repeats; false at an error or the limit.
    bool command(std::size_t max_segments, bool first) {
        const char letter = scanner.peek();
        const bool relative = letter >= 'a' && letter <= 'z';
        char upper = relative ? static_cast<char>(letter - 'a' + 'A') : letter;
        if (upper != 'Z' && argument_count(upper) == 0) return stop(ValueState::malformed, "a command");
        if (first && upper != 'M') return stop(ValueState::malformed, "a first command M or m");
        ++scanner.at;
        if (upper == 'Z') {
            pen.close();
            cubic_control.reset();
            quadratic_control.reset();
            return true;
        }
        skip_space(scanner);
        while (true) {
            std::array<double, 7> v{};
            if (!take_arguments(upper, v)) return false;
            draw(upper, relative ? pen.at : Point{}, v);
            if (pen.segments + pen.open.segments.size() > max_segments) {
                result.over_limit = true;
                return false;
            }
            const bool comma = skip_separator(scanner);
            if (!at_number(scanner)) return !comma || stop(ValueState::malformed, "a number after the comma");
            if (upper == 'M') upper = 'L';  // further pairs after a moveto are lines
        }
    }
};

}  // namespace

Outline read_path(std::string_view d, std::size_t max_segments) {
    Reader reader;
    reader.scanner = {trimmed(d)};
    if (reader.scanner.text == "none") return {};
    reader.scanner = {d};
    skip_space(reader.scanner);
    bool first = true;
    while (!reader.scanner.done() && reader.command(max_segments, first)) {
        first = false;
        skip_space(reader.scanner);
    }
    reader.pen.lift();
    reader.result.subpaths = std::move(reader.pen.done);
    reader.result.segments = reader.pen.segments;
    return std::move(reader.result);
}

Outline read_points(std::string_view points, bool closed, std::size_t max_segments) {
    Outline result;
    Scanner scanner{points};
    Pen pen;
    skip_space(scanner);
    bool first = true;
    const auto stop = [&](ValueState state) {
        result.state = state;
        result.message = state == ValueState::refused
                             ? refused_number(scanner)
                             : fmt::format("a pair of numbers expected, {} found at character {}",
                                           character_text(scanner), scanner.at + 1);
    };
    while (!scanner.done()) {
        const auto x = take_number(scanner);
        if (x.state != ValueState::good) {
            stop(x.state);
            break;
        }
        skip_separator(scanner);
        const auto y = take_number(scanner);
        if (y.state != ValueState::good) {
            stop(y.state);
            break;
        }
        skip_separator(scanner);
        if (first)
            pen.move({x.value, y.value});
        else
            pen.line({x.value, y.value});
        first = false;
        if (pen.open.segments.size() > max_segments) {
            result.over_limit = true;
            break;
        }
    }
    if (closed && !pen.open.segments.empty()) pen.close();
    pen.lift();
    result.subpaths = std::move(pen.done);
    result.segments = pen.segments;
    return result;
}

PathData parse_path_data(std::string_view d) {
    auto outline = read_path(d, Limits{}.segments);
    if (outline.over_limit) outline.message = fmt::format("more than {} segments", Limits{}.segments);
    return {std::move(outline.subpaths), std::move(outline.message)};
}

}  // namespace strandline::svg
