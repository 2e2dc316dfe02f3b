#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "base/units/units.hpp"
#include "input/drawing/drawing.hpp"

namespace strandline {
namespace {

struct Sheet {
    const char* name;
    double width, height;  // mm
};
constexpr std::array<Sheet, 10> sheets{{{"a0", 841, 1189},
                                        {"a1", 594, 841},
                                        {"a2", 420, 594},
                                        {"a3", 297, 420},
                                        {"a4", 210, 297},
                                        {"a5", 148, 210},
                                        {"a6", 105, 148},
                                        {"letter", 215.9, 279.4},
                                        {"legal", 215.9, 355.6},
                                        {"tabloid", 279.4, 431.8}}};

bool take_suffix(std::string& text, const std::string& suffix) {
    if (!text.ends_with(suffix)) return false;
    text.resize(text.size() - suffix.size());
    return true;
}

bool has_unit(const std::string& text) {
    return std::ranges::any_of(text, [](unsigned char c) { return std::isalpha(c) && c != 'e'; });
}

}  // namespace

Outcome<Canvas> canvas_named(const std::string& name) {
    std::string text = name;
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool landscape = take_suffix(text, "-landscape"),
               portrait = !landscape && take_suffix(text, "-portrait");

    std::optional<Canvas> canvas;
    for (const Sheet& sheet : sheets)
        if (text == sheet.name) canvas = Canvas{sheet.width / 1000, sheet.height / 1000};
    if (const auto cut = text.find('x'); !canvas && cut != std::string::npos) {
        std::string first = text.substr(0, cut);
        const std::string second = text.substr(cut + 1);
        if (!has_unit(first))
            first += second.substr(std::min(second.find_first_not_of("0123456789.+-e "), second.size()));
        const auto width = parse_length(first, "canvas"), height = parse_length(second, "canvas");
        if (!width) return tl::unexpected(width.error());
        if (!height) return tl::unexpected(height.error());
        canvas = Canvas{*width, *height};
    }
    if (!canvas)
        return fail("canvas", fmt::format("\"{}\" is no known size", name),
                    "use A0 to A6, letter, legal, or a size such as 14x14 or 210x297mm");
    if (!(canvas->width > 0 && canvas->height > 0))
        return fail("canvas", fmt::format("\"{}\" has no area", name), "give both sides above zero");
    if ((landscape && canvas->width < canvas->height) || (portrait && canvas->width > canvas->height))
        std::swap(canvas->width, canvas->height);
    return *canvas;
}

DrawingOptions options_for(const Canvas& canvas) {
    DrawingOptions options;
    const Canvas beach;
    const double share =
        std::min(1.0, std::min(canvas.width, canvas.height) / std::min(beach.width, beach.height));
    options.canvas = canvas;
    if (!(share > 0)) return options;  // make_drawing says what is wrong with it
    options.margin *= share;
    options.tolerance *= share;
    options.join_tolerance *= share;
    options.min_length *= share;
    return options;
}

}  // namespace strandline
