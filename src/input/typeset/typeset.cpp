// The text of an SVG, piece by piece, and where the pieces stand.
#include "input/typeset/typeset.hpp"

#include <fmt/format.h>
#include <pango/pangoft2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "input/typeset/glyphs.hpp"

namespace strandline::typeset {
namespace {

constexpr double longest_line = 32'000;  // em; see layout_size in glyphs.cpp
constexpr double widest_glyph = 3;       // em; real fonts stay below
constexpr std::array generic{"serif", "sans-serif", "monospace", "cursive", "fantasy", "system-ui"};

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(g_ascii_tolower(c));
    return text;
}

/// "Arial, 'DejaVu Sans'" -> names without quotes and spaces round them.
std::vector<std::string> families_of(const std::string& css) {
    constexpr std::string_view around = " \t\n\"'";
    std::vector<std::string> names;
    for (std::size_t at = 0; at <= css.size();) {
        const std::size_t end = std::min(css.find(',', at), css.size());
        std::string name = css.substr(at, end - at);
        name.erase(0, std::min(name.find_first_not_of(around), name.size()));
        name.erase(name.find_last_not_of(around) + 1);
        if (!name.empty()) names.push_back(name);
        at = end + 1;
    }
    return names;
}

/// A part of a span that is set in one go, and where it begins.
struct Part {
    std::size_t span;
    std::string text;
    std::optional<double> x, y;
    double dx = 0, dy = 0, turn = 0;  ///< turn: radians, clockwise to the eye (y down)
};

std::optional<double> nth(const std::vector<double>& list, std::size_t i) {
    return i < list.size() ? std::optional(list[i]) : std::nullopt;
}

/// A span is cut before each character with a place of its own; where glyphs are turned, before each.
std::vector<Part> parts_of(const svg::TextSpan& span, std::size_t number) {
    std::vector<Part> parts;
    const char* const end = span.text.c_str() + span.text.size();
    std::size_t i = 0;
    for (const char* at = span.text.c_str(); at < end; at = g_utf8_next_char(at), ++i) {
        const std::size_t placed = std::max({span.x.size(), span.y.size(), span.dx.size(), span.dy.size()});
        if (i == 0 || i < placed || !span.rotate.empty()) {
            const double degrees = span.rotate.empty() ? 0 : span.rotate[std::min(i, span.rotate.size() - 1)];
            parts.push_back({number, "", nth(span.x, i), nth(span.y, i), nth(span.dx, i).value_or(0),
                             nth(span.dy, i).value_or(0), degrees * pi / 180});
        }
        parts.back().text.append(at, static_cast<std::size_t>(g_utf8_next_char(at) - at));
    }
    return parts;
}

Affine turned_at(Point origin, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    return {c, s, -s, c, origin.x, origin.y};
}

/// Pieces that are anchored together.
struct Chunk {
    struct Set {
        std::size_t span;
        std::vector<Path> outlines;
        Affine map;
    };
    std::vector<Set> sets;
    double start = 0, end = 0;
    svg::TextSpan::Anchor anchor = svg::TextSpan::Anchor::start;

    void finish(Outlines& result) {
        const double share = anchor == svg::TextSpan::Anchor::middle ? 0.5
                             : anchor == svg::TextSpan::Anchor::end  ? 1
                                                                     : 0;
        const Affine shift{1, 0, 0, 1, -share * (end - start), 0};
        for (const Set& set : sets)
            for (const Path& path : set.outlines)
                result.spans[set.span].push_back(transformed(path, composed(shift, set.map)));
        sets.clear();
    }
};

}  // namespace

struct Typesetter::Fonts {
    PangoFontMap* map = pango_ft2_font_map_new();
    PangoContext* context = pango_font_map_create_context(map);
    std::set<std::string> installed;  ///< in small letters

    Fonts() {
        pango_context_set_round_glyph_positions(context, FALSE);
        PangoFontFamily** families = nullptr;
        int count = 0;
        pango_font_map_list_families(map, &families, &count);
        for (int i = 0; i < count; ++i) installed.insert(lower(pango_font_family_get_name(families[i])));
        g_free(families);
    }
    ~Fonts() {
        g_object_unref(context);
        g_object_unref(map);
    }
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

    bool has(const std::string& family) const {
        return std::ranges::find(generic, family) != generic.end() || installed.contains(lower(family));
    }
};

Typesetter::Typesetter() : fonts_(std::make_unique<Fonts>()) {}
Typesetter::~Typesetter() = default;
Typesetter::Typesetter(Typesetter&&) noexcept = default;
Typesetter& Typesetter::operator=(Typesetter&&) noexcept = default;

Outcome<Outlines> Typesetter::outlines(const svg::Text& text, const Options& options) const {
    Outlines result{std::vector<std::vector<Path>>(text.spans.size()), {}};
    const auto warn = [&](std::string reason) {
        const Warning warning{text.place, std::move(reason)};
        if (std::ranges::find(result.warnings, warning) == result.warnings.end())
            result.warnings.push_back(warning);
    };
    Point pen;
    Chunk chunk;
    for (std::size_t i = 0; i < text.spans.size(); ++i) {
        const svg::TextSpan& span = text.spans[i];
        if (!g_utf8_validate(span.text.data(), static_cast<gssize>(span.text.size()), nullptr))
            return fail(text.place, "the text is not UTF-8", "save the file as UTF-8");
        if (!(span.size > 0)) continue;
        const double widest = widest_glyph + std::abs(span.letter_spacing / span.size);
        if (!(static_cast<double>(span.text.size()) * widest <= longest_line))
            return fail(text.place, "a text that is too long in one go", "split it");
        std::vector<std::string> families = families_of(span.family);
        const bool named = !families.empty();
        if (!named) families.emplace_back("sans-serif");
        const std::string wanted = families.front();
        if (!options.substitutes && !fonts_->has(wanted))
            return fail(text.place, fmt::format("the font {} is not on this machine", wanted),
                        "install it, turn the text into paths, or set text.substitutes=on");
        for (const Part& part : parts_of(span, i)) {
            if (part.x || part.y || (i == 0 && chunk.sets.empty())) {
                chunk.finish(result);
                pen = {part.x.value_or(pen.x), part.y.value_or(pen.y)};
                chunk.anchor = span.anchor;
                chunk.start = chunk.end = pen.x + part.dx;
            }
            pen = pen + Point{part.dx, part.dy};
            Piece piece =
                piece_of(fonts_->context, part.text, fmt::format("{}", fmt::join(families, ",")), span);
            chunk.sets.push_back({i, std::move(piece.outlines), turned_at(pen, part.turn)});
            pen.x += piece.advance;
            chunk.start = std::min(chunk.start, pen.x);
            chunk.end = std::max(chunk.end, pen.x);
            for (const std::string& used : piece.families) {
                if (!named)
                    warn(fmt::format("the text names no font: {} is used", used));
                else if (!fonts_->has(wanted))
                    warn(fmt::format("the font {} is not on this machine: {} is used", wanted, used));
                else if (lower(used) != lower(wanted) && std::ranges::find(generic, wanted) == generic.end())
                    warn(fmt::format("the font {} lacks some of the letters: {} is used for them", wanted,
                                     used));
            }
            for (const std::string& character : piece.missing)
                warn(fmt::format("no font on this machine has an outline of \"{}\": left out", character));
        }
    }
    chunk.finish(result);
    return result;
}

}  // namespace strandline::typeset
