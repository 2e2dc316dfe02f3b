// Text and font -> lines in millimetres.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "input/lettering/lettering.hpp"

namespace strandline::lettering {
namespace {

constexpr double millimetres = 1000;              // in a metre
constexpr double highest = 100'000;               // metres: nothing that drives is larger
constexpr std::size_t most_characters = 100'000;  // a long book's chapter; about a million strokes

struct Character {
    char32_t code;
    std::string utf8;
};

/// Nothing where the bytes are not UTF-8 (overlong forms and surrogates are not).
bool decode(std::string_view text, std::vector<Character>& characters) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t size = lead < 0x80   ? 1
                                 : lead < 0xC2 ? 0
                                 : lead < 0xE0 ? 2
                                 : lead < 0xF0 ? 3
                                 : lead < 0xF5 ? 4
                                               : 0;
        if (size == 0 || i + size > text.size()) return false;
        char32_t code = size == 1 ? lead : lead & (0x7FU >> size);
        for (std::size_t k = 1; k < size; ++k) {
            const auto byte = static_cast<unsigned char>(text[i + k]);
            if ((byte & 0xC0U) != 0x80U) return false;
            code = code << 6U | (byte & 0x3FU);
        }
        if ((size == 3 && code < 0x800) || (size == 4 && (code < 0x10000 || code > 0x10FFFF)) ||
            (code >= 0xD800 && code < 0xE000))
            return false;
        characters.push_back({code, std::string(text.substr(i, size))});
        i += size;
    }
    return true;
}

std::string hexadecimal(char32_t code) { return fmt::format("{:04X}", static_cast<std::uint32_t>(code)); }

/// As part of an id: what cannot be mistaken on a command line or in XML.
std::string name_in_id(const Character& c) {
    const bool plain = (c.code >= '0' && c.code <= '9') || (c.code >= 'A' && c.code <= 'Z') ||
                       (c.code >= 'a' && c.code <= 'z');
    return plain ? c.utf8 : fmt::format("u{}", hexadecimal(c.code));
}

/// For people: the character, or its number where it cannot be printed.
std::string shown(const Character& c) {
    const bool control = c.code < 0x20 || (c.code >= 0x7F && c.code < 0xA0);
    return control ? fmt::format("U+{}", hexadecimal(c.code)) : fmt::format("\"{}\"", c.utf8);
}

/// The characters that a font lacks, each once, in the order of the text.
class Missing {
  public:
    void note(const Character& c, std::size_t line, std::size_t column) {
        if (count_++ == 0) place_ = fmt::format("text, line {}, character {}", line, column);
        if (std::ranges::find(codes_, c.code) != codes_.end()) return;
        codes_.push_back(c.code);
        if (codes_.size() <= most_named) names_ += (names_.empty() ? "" : ", ") + shown(c);
    }
    void report(Warnings& warnings, const std::string& font) const {
        if (count_ == 0) return;
        const std::size_t more = codes_.size() - std::min(codes_.size(), most_named);
        warnings.push_back({place_, fmt::format("the font {} has no {}{}: left out ({} in all)", font, names_,
                                                more > 0 ? fmt::format(" and {} more", more) : "", count_)});
    }

  private:
    static constexpr std::size_t most_named = 20;
    std::vector<char32_t> codes_;
    std::string names_, place_;
    std::size_t count_ = 0;
};

std::vector<std::vector<Character>> lines_of(const std::vector<Character>& characters) {
    std::vector<std::vector<Character>> lines(1);
    for (const Character& c : characters) {
        if (c.code == '\n')
            lines.emplace_back();
        else if (c.code != '\r')
            lines.back().push_back(c);
    }
    return lines;
}

double rounded(double millimetre) { return std::round(millimetre * 1000) / 1000; }

Outcome<void> sensible(const Options& o) {
    if (!(o.height > 0 && o.height <= highest))
        return fail("height", "is not above 0 and at most 100 km", "write for example --height 1m");
    if (!(std::abs(o.line_spacing) <= 1000)) return fail("line spacing", "is out of range", "use 1 to 3");
    if (!(o.stroke_width >= 0 && o.stroke_width <= 1e6))
        return fail("stroke width", "is below 0 or above a kilometre",
                    "write a width in millimetres, such as 1");
    if (!(std::abs(o.letter_spacing) <= highest))
        return fail("letter spacing", "is out of range", "write for example 5cm");
    return {};
}

struct Writer {
    const Font& font;
    const Options& options;
    double stroke_width = options.stroke_width > 0 ? options.stroke_width
                                                   : std::min(1.0, options.height* millimetres / 12);
    double scale = options.height * millimetres / (font.base_line - font.cap_line);  // mm to the font unit
    svg::Document document = {};
    Missing missing = {};

    const Glyph* glyph_of(const Character& c) const {
        const std::size_t index = c.code - U' ';
        return c.code >= U' ' && index < font.glyphs.size() ? &font.glyphs[index] : nullptr;
    }
    double advance(const Glyph& glyph) const {
        return (glyph.right - glyph.left) * scale + options.letter_spacing * millimetres;
    }
    double width_of(const std::vector<Character>& line) const {
        double width = 0;
        for (const Character& c : line)
            if (const Glyph* glyph = glyph_of(c)) width += advance(*glyph);
        return width == 0 ? 0 : width - options.letter_spacing * millimetres;
    }

    /// `pen`: the glyph's left bound on the base line.
    void draw(const Glyph& glyph, Point pen, std::size_t line, std::size_t column, const Character& c) {
        int number = 0;
        for (const Polyline& stroke : glyph.strokes) {
            std::vector<Point> points;
            for (const Point p : stroke)
                points.push_back({rounded(pen.x + (p.x - glyph.left) * scale),
                                  rounded(pen.y + (p.y - font.base_line) * scale)});
            svg::Shape shape;
            shape.id = fmt::format("t.{}.{}.{}.{}", line, column, name_in_id(c), ++number);
            shape.place = fmt::format("text, line {}, character {}, {}", line, column, shown(c));
            shape.line = static_cast<int>(line);
            shape.subpaths = {path_through(points, false)};
            shape.stroke = svg::Paint{};
            shape.stroke_width = stroke_width;
            shape.cap = svg::LineCap::round;
            shape.join = svg::LineJoin::round;
            document.shapes.push_back(std::move(shape));
        }
    }

    void write(const std::vector<Character>& line, std::size_t number) {
        const double share = options.align == Align::left ? 0 : options.align == Align::centre ? 0.5 : 1;
        Point pen{-share * width_of(line),
                  static_cast<double>(number - 1) * options.line_spacing * options.height * millimetres};
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Glyph* glyph = glyph_of(line[i]);
            if (!glyph) {
                missing.note(line[i], number, i + 1);
                continue;
            }
            draw(*glyph, pen, number, i + 1, line[i]);
            pen.x += advance(*glyph);
        }
    }

    /// The ink's box becomes the page, its corner the origin.
    void trim() {
        Box ink;
        for (const svg::Shape& shape : document.shapes) ink = united(ink, bounds(shape.subpaths.front()));
        ink = grown(ink, stroke_width / 2);
        for (svg::Shape& shape : document.shapes)
            for (Path& path : shape.subpaths) {
                path = transformed(path, {1, 0, 0, 1, -ink.low.x, -ink.low.y});
                const auto round_point = [](Point& p) { p = {rounded(p.x), rounded(p.y)}; };
                round_point(path.start);
                for (Segment& segment : path.segments) round_point(std::get<LineSegment>(segment).to);
            }
        document.view = {{0, 0}, {rounded(ink.width()), rounded(ink.height())}};
        document.size_metres = (1 / millimetres) * document.view.high;
    }
};

}  // namespace

Outcome<svg::Document> lettered(std::string_view text, const Font& font, const Options& options) {
    if (const auto fine = sensible(options); !fine) return tl::unexpected(fine.error());
    if (text.size() > 4 * most_characters)
        return fail("text", fmt::format("has more than {} characters", most_characters), "write it in parts");
    std::vector<Character> characters;
    if (!decode(text, characters)) return fail("text", "is not UTF-8", "save or type it as UTF-8");
    if (characters.size() > most_characters)
        return fail("text", fmt::format("has more than {} characters", most_characters), "write it in parts");
    Writer writer{font, options};
    std::size_t number = 0;
    for (const auto& line : lines_of(characters)) writer.write(line, ++number);
    writer.missing.report(writer.document.warnings, font.name);
    if (writer.document.shapes.empty()) {
        const Warnings& warnings = writer.document.warnings;
        return fail("text", warnings.empty() ? "holds nothing to draw" : warnings.front().reason,
                    "write letters that the font has");
    }
    writer.trim();
    return std::move(writer.document);
}

}  // namespace strandline::lettering
