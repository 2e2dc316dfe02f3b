// JHF -> glyphs, and the lines that they stand between.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "input/lettering/lettering.hpp"

namespace strandline::lettering {
namespace {

constexpr std::size_t number_columns = 5, count_columns = 3, head_columns = number_columns + count_columns;
constexpr char origin = 'R';  // the letter of coordinate 0

/// The lines of a text, one after the other, without their ends.
struct Lines {
    std::string_view rest;
    int number = 0;

    bool next(std::string_view& line) {
        if (rest.empty()) return false;
        const std::size_t end = rest.find('\n');
        line = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        ++number;
        return true;
    }
};

/// A number right-aligned in its columns.
bool read_number(std::string_view columns, int& value) {
    columns.remove_prefix(std::min(columns.find_first_not_of(' '), columns.size()));
    const char* end = columns.data() + columns.size();
    return !columns.empty() && std::from_chars(columns.data(), end, value).ptr == end && value >= 0;
}

Glyph glyph_of(std::string_view pairs) {
    const auto at = [&](std::size_t i) { return static_cast<double>(pairs[i] - origin); };
    Glyph glyph{at(0), at(1), {}};
    Polyline stroke;
    const auto lift = [&] {
        if (stroke.size() > 1) glyph.strokes.push_back(stroke);
        stroke.clear();
    };
    for (std::size_t i = 2; i + 1 < pairs.size(); i += 2) {
        if (pairs[i] == ' ' && pairs[i + 1] == origin) {
            lift();
            continue;
        }
        const Point p{at(i), at(i + 1)};
        if (stroke.empty() || stroke.back() != p) stroke.push_back(p);
    }
    lift();
    return glyph;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Most capitals end on both lines; a few, such as J and Q, do not.
Outcome<void> measure(Font& font) {
    std::vector<double> tops, bottoms;
    for (std::size_t i = 'A' - ' '; i <= 'Z' - ' ' && i < font.glyphs.size(); ++i) {
        Box box;
        for (const Polyline& stroke : font.glyphs[i].strokes) box = united(box, bounds(stroke));
        if (box.empty()) continue;
        tops.push_back(box.low.y);
        bottoms.push_back(box.high.y);
    }
    if (!tops.empty()) font.cap_line = median(tops), font.base_line = median(bottoms);
    if (font.cap_line < font.base_line) return {};
    return fail(font.name, "has no letters A to Z to measure its height by", "choose another font");
}

}  // namespace

Outcome<Font> read_font(std::string_view jhf, const std::string& name) {
    Font font{name, {}, 0, 0};
    Lines lines{jhf};
    std::string_view line;
    while (lines.next(line)) {
        if (line.find_first_not_of(' ') == std::string_view::npos) continue;
        const auto wrong = [&, at = lines.number](const char* what) {
            return fail(fmt::format("{}, line {}", name, at), what, "name a Hershey font (.jhf)");
        };
        int number = 0, count = 0;
        if (line.size() < head_columns + 2 || !read_number(line.substr(0, number_columns), number) ||
            !read_number(line.substr(number_columns, count_columns), count) || count < 1)
            return wrong("does not begin with the number of a glyph and its count of points");
        const std::size_t size = 2 * static_cast<std::size_t>(count);
        std::string pairs(line.substr(head_columns));
        while (pairs.size() < size && lines.next(line)) pairs += line;
        if (pairs.size() < size) return wrong("the file ends inside a glyph");
        pairs.resize(size);
        if (std::ranges::any_of(pairs, [](char c) { return c < ' ' || c > '~'; }))
            return wrong("holds characters that are no coordinates");
        if (pairs[0] > pairs[1]) return wrong("is a glyph whose left bound lies right of its right bound");
        font.glyphs.push_back(glyph_of(pairs));
    }
    if (font.glyphs.empty()) return fail(name, "holds no glyphs", "name a Hershey font (.jhf)");
    if (const auto measured = measure(font); !measured) return tl::unexpected(measured.error());
    return font;
}

}  // namespace strandline::lettering
