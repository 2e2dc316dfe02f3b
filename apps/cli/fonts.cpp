#include "fonts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "base/units/units.hpp"
#include "console.hpp"

namespace strandline::cli {
namespace {

namespace fs = std::filesystem;

/// What the files of hershey-fonts-data hold. Simplex: a line is one stroke; duplex: two; complex: one or
/// two, as a pen swells; triplex: up to three.
constexpr std::array<std::pair<std::string_view, std::string_view>, 32> known{{
    {"astrology", "roman, italic, bold, with signs of zodiac and planets"},
    {"cursive", "script, simplex, letters that join"},
    {"cyrilc_1", "cyrillic, complex, in the order of its alphabet"},
    {"cyrillic", "cyrillic, complex, by the sound of the Latin letter"},
    {"futural", "sans, simplex"},
    {"futuram", "sans, duplex"},
    {"gothgbt", "blackletter, English, triplex"},
    {"gothgrt", "blackletter, German, triplex"},
    {"gothiceng", "blackletter, English, triplex"},
    {"gothicger", "blackletter, German, triplex"},
    {"gothicita", "blackletter, Italian, triplex"},
    {"gothitt", "blackletter, Italian, triplex"},
    {"greek", "greek, simplex, by the sound of the Latin letter"},
    {"greekc", "greek, complex, A to X are alpha to omega"},
    {"greeks", "greek, simplex, A to X are alpha to omega"},
    {"japanese", "kana and some kanji, by position"},
    {"markers", "circles, squares, triangles"},
    {"mathlow", "sans, simplex, small letters at A to Z, with signs of mathematics"},
    {"mathupp", "sans, simplex, with signs of mathematics"},
    {"meteorology", "sans, simplex, with signs of the weather"},
    {"music", "roman, italic, with signs of music"},
    {"rowmand", "sans, duplex"},
    {"rowmans", "sans, simplex"},
    {"rowmant", "roman, triplex"},
    {"scriptc", "script, complex, letters that join"},
    {"scripts", "script, simplex, letters that join"},
    {"symbolic", "bells, trees, anchors, suits of cards, arcs"},
    {"timesg", "greek, complex, by the sound of the Latin letter"},
    {"timesi", "roman, italic, complex"},
    {"timesib", "roman, italic, triplex"},
    {"timesr", "roman, complex"},
    {"timesrb", "roman, triplex"},
}};

std::string fonts_folder() {
    const char* wished = std::getenv("STRANDLINE_FONTS");
    return wished && *wished ? wished : STRANDLINE_HERSHEY_FONTS;
}

constexpr const char* how_to_get_fonts =
    "install the package hershey-fonts-data, or set STRANDLINE_FONTS to a folder of .jhf files";

/// \n is a newline and \\ a backslash, for shells in which a newline is hard to type.
std::string unescaped(const std::string& typed) {
    std::string text;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        const char next = i + 1 < typed.size() ? typed[i + 1] : ' ';
        if (typed[i] != '\\' || (next != 'n' && next != '\\')) {
            text += typed[i];
            continue;
        }
        text += next == 'n' ? '\n' : '\\';
        ++i;
    }
    return text;
}

Outcome<lettering::Options> options_of(const LetteringArguments& a) {
    lettering::Options options;
    options.line_spacing = a.line_spacing;
    const auto read = [](const std::string& text, const char* option, double& value, double unit) {
        if (text.empty()) return Outcome<void>{};
        const auto length = parse_length(text, option);
        if (!length) return Outcome<void>{tl::unexpected(length.error())};
        value = *length * unit;
        return Outcome<void>{};
    };
    if (auto done = read(a.height, "--height", options.height, 1); !done) return tl::unexpected(done.error());
    if (auto done = read(a.letter_spacing, "--letter-spacing", options.letter_spacing, 1); !done)
        return tl::unexpected(done.error());
    if (auto done = read(a.stroke_width, "--stroke-width", options.stroke_width, 1000); !done)
        return tl::unexpected(done.error());
    options.align = a.align == "right"    ? lettering::Align::right
                    : a.align == "centre" ? lettering::Align::centre
                                          : lettering::Align::left;
    return options;
}

}  // namespace

Outcome<std::vector<FontEntry>> installed_fonts() {
    const std::string folder = fonts_folder();
    std::error_code code;
    std::vector<FontEntry> fonts;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        if (entry.path().extension() != ".jhf") continue;
        const std::string name = entry.path().stem().string();
        const auto* const row =
            std::ranges::find(known, std::string_view(name), [](const auto& k) { return k.first; });
        fonts.push_back({name, std::string(row == known.end() ? std::string_view{} : row->second)});
    }
    if (fonts.empty()) return fail(folder, "the Hershey fonts are not there", how_to_get_fonts);
    std::ranges::sort(fonts, {}, &FontEntry::name);
    return fonts;
}

Outcome<lettering::Font> font_named(const std::string& name) {
    if (name.ends_with(".jhf")) {
        const auto bytes = read_input(name);
        if (!bytes) return tl::unexpected(bytes.error());
        return lettering::read_font(*bytes, name);
    }
    const auto fonts = installed_fonts();
    if (!fonts) return tl::unexpected(fonts.error());
    if (std::ranges::find(*fonts, name, &FontEntry::name) == fonts->end()) {
        std::string names;
        for (const FontEntry& font : *fonts) names += (names.empty() ? "" : ", ") + font.name;
        return fail("--font " + name, "there is no such font in " + fonts_folder(), "use one of " + names);
    }
    const auto bytes = read_input((fs::path(fonts_folder()) / (name + ".jhf")).string());
    if (!bytes) return tl::unexpected(bytes.error());
    return lettering::read_font(*bytes, name);
}

Outcome<svg::Document> lettered(const LetteringArguments& arguments) {
    const auto options = options_of(arguments);
    if (!options) return tl::unexpected(options.error());
    const auto font = font_named(arguments.font);
    if (!font) return tl::unexpected(font.error());
    if (arguments.text != "-") return lettering::lettered(unescaped(arguments.text), *font, *options);
    const auto typed = read_input("-");
    if (!typed) return tl::unexpected(typed.error());
    return lettering::lettered(*typed, *font, *options);
}

Exit fault_of(const Error& error) { return error.place.starts_with("--") ? bad_call : bad_input; }

}  // namespace strandline::cli
