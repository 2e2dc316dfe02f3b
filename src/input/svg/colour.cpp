#include "input/svg/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "input/svg/scan.hpp"

namespace strandline::svg {

namespace {

struct Named {
    std::string_view name;
    std::uint32_t rgb;
};
/// CSS Color 4, section 6.1; sorted.
constexpr std::array named_colours = std::to_array<Named>({
    {"aliceblue", 0xf0f8ff},
    {"antiquewhite", 0xfaebd7},
    {"aqua", 0x00ffff},
    {"aquamarine", 0x7fffd4},
    {"azure", 0xf0ffff},
    {"beige", 0xf5f5dc},
    {"bisque", 0xffe4c4},
    {"black", 0x000000},
    {"blanchedalmond", 0xffebcd},
    {"blue", 0x0000ff},
    {"blueviolet", 0x8a2be2},
    {"brown", 0xa52a2a},
    {"burlywood", 0xdeb887},
    {"cadetblue", 0x5f9ea0},
    {"chartreuse", 0x7fff00},
    {"chocolate", 0xd2691e},
    {"coral", 0xff7f50},
    {"cornflowerblue", 0x6495ed},
    {"cornsilk", 0xfff8dc},
    {"crimson", 0xdc143c},
    {"cyan", 0x00ffff},
    {"darkblue", 0x00008b},
    {"darkcyan", 0x008b8b},
    {"darkgoldenrod", 0xb8860b},
    {"darkgray", 0xa9a9a9},
    {"darkgreen", 0x006400},
    {"darkgrey", 0xa9a9a9},
    {"darkkhaki", 0xbdb76b},
    {"darkmagenta", 0x8b008b},
    {"darkolivegreen", 0x556b2f},
    {"darkorange", 0xff8c00},
    {"darkorchid", 0x9932cc},
    {"darkred", 0x8b0000},
    {"darksalmon", 0xe9967a},
    {"darkseagreen", 0x8fbc8f},
    {"darkslateblue", 0x483d8b},
    {"darkslategray", 0x2f4f4f},
    {"darkslategrey", 0x2f4f4f},
    {"darkturquoise", 0x00ced1},
    {"darkviolet", 0x9400d3},
    {"deeppink", 0xff1493},
    {"deepskyblue", 0x00bfff},
    {"dimgray", 0x696969},
    {"dimgrey", 0x696969},
    {"dodgerblue", 0x1e90ff},
    {"firebrick", 0xb22222},
    {"floralwhite", 0xfffaf0},
    {"forestgreen", 0x228b22},
    {"fuchsia", 0xff00ff},
    {"gainsboro", 0xdcdcdc},
    {"ghostwhite", 0xf8f8ff},
    {"gold", 0xffd700},
    {"goldenrod", 0xdaa520},
    {"gray", 0x808080},
    {"green", 0x008000},
    {"greenyellow", 0xadff2f},
    {"grey", 0x808080},
    {"honeydew", 0xf0fff0},
    {"hotpink", 0xff69b4},
    {"indianred", 0xcd5c5c},
    {"indigo", 0x4b0082},
    {"ivory", 0xfffff0},
    {"khaki", 0xf0e68c},
    {"lavender", 0xe6e6fa},
    {"lavenderblush", 0xfff0f5},
    {"lawngreen", 0x7cfc00},
    {"lemonchiffon", 0xfffacd},
    {"lightblue", 0xadd8e6},
    {"lightcoral", 0xf08080},
    {"lightcyan", 0xe0ffff},
    {"lightgoldenrodyellow", 0xfafad2},
    {"lightgray", 0xd3d3d3},
    {"lightgreen", 0x90ee90},
    {"lightgrey", 0xd3d3d3},
    {"lightpink", 0xffb6c1},
    {"lightsalmon", 0xffa07a},
    {"lightseagreen", 0x20b2aa},
    {"lightskyblue", 0x87cefa},
    {"lightslategray", 0x778899},
    {"lightslategrey", 0x778899},
    {"lightsteelblue", 0xb0c4de},
    {"lightyellow", 0xffffe0},
    {"lime", 0x00ff00},
    {"limegreen", 0x32cd32},
    {"linen", 0xfaf0e6},
    {"magenta", 0xff00ff},
    {"maroon", 0x800000},
    {"mediumaquamarine", 0x66cdaa},
    {"mediumblue", 0x0000cd},
    {"mediumorchid", 0xba55d3},
    {"mediumpurple", 0x9370db},
    {"mediumseagreen", 0x3cb371},
    {"mediumslateblue", 0x7b68ee},
    {"mediumspringgreen", 0x00fa9a},
    {"mediumturquoise", 0x48d1cc},
    {"mediumvioletred", 0xc71585},
    {"midnightblue", 0x191970},
    {"mintcream", 0xf5fffa},
    {"mistyrose", 0xffe4e1},
    {"moccasin", 0xffe4b5},
    {"navajowhite", 0xffdead},
    {"navy", 0x000080},
    {"oldlace", 0xfdf5e6},
    {"olive", 0x808000},
    {"olivedrab", 0x6b8e23},
    {"orange", 0xffa500},
    {"orangered", 0xff4500},
    {"orchid", 0xda70d6},
    {"palegoldenrod", 0xeee8aa},
    {"palegreen", 0x98fb98},
    {"paleturquoise", 0xafeeee},
    {"palevioletred", 0xdb7093},
    {"papayawhip", 0xffefd5},
    {"peachpuff", 0xffdab9},
    {"peru", 0xcd853f},
    {"pink", 0xffc0cb},
    {"plum", 0xdda0dd},
    {"powderblue", 0xb0e0e6},
    {"purple", 0x800080},
    {"rebeccapurple", 0x663399},
    {"red", 0xff0000},
    {"rosybrown", 0xbc8f8f},
    {"royalblue", 0x4169e1},
    {"saddlebrown", 0x8b4513},
    {"salmon", 0xfa8072},
    {"sandybrown", 0xf4a460},
    {"seagreen", 0x2e8b57},
    {"seashell", 0xfff5ee},
    {"sienna", 0xa0522d},
    {"silver", 0xc0c0c0},
    {"skyblue", 0x87ceeb},
    {"slateblue", 0x6a5acd},
    {"slategray", 0x708090},
    {"slategrey", 0x708090},
    {"snow", 0xfffafa},
    {"springgreen", 0x00ff7f},
    {"steelblue", 0x4682b4},
    {"tan", 0xd2b48c},
    {"teal", 0x008080},
    {"thistle", 0xd8bfd8},
    {"tomato", 0xff6347},
    {"turquoise", 0x40e0d0},
    {"violet", 0xee82ee},
    {"wheat", 0xf5deb3},
    {"white", 0xffffff},
    {"whitesmoke", 0xf5f5f5},
    {"yellow", 0xffff00},
    {"yellowgreen", 0x9acd32},
});
static_assert(std::ranges::is_sorted(named_colours, {}, &Named::name));

Colour from_rgb(std::uint32_t rgb) {
    return {static_cast<unsigned char>(rgb >> 16 & 255), static_cast<unsigned char>(rgb >> 8 & 255),
            static_cast<unsigned char>(rgb & 255)};
}

std::optional<Ink> from_hex(std::string_view digits) {
    std::array<std::uint32_t, 8> v{};
    if (digits.size() > v.size()) return std::nullopt;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const char c = digits[i];
        if (c >= '0' && c <= '9')
            v[i] = static_cast<std::uint32_t>(c - '0');
        else if (c >= 'a' && c <= 'f')
            v[i] = static_cast<std::uint32_t>(c - 'a') + 10;
        else
            return std::nullopt;
    }
    const auto channel = [&](std::size_t i) { return static_cast<unsigned char>(17 * v[i]); };
    const auto wide = [&](std::size_t i) { return static_cast<unsigned char>(16 * v[i] + v[i + 1]); };
    switch (digits.size()) {
        case 3:
            return Ink{{channel(0), channel(1), channel(2)}, 1};
        case 4:
            return Ink{{channel(0), channel(1), channel(2)}, channel(3) / 255.0};
        case 6:
            return Ink{{wide(0), wide(2), wide(4)}, 1};
        case 8:
            return Ink{{wide(0), wide(2), wide(4)}, wide(6) / 255.0};
        default:
            return std::nullopt;
    }
}

unsigned char byte(double value) {
    return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// CSS Color 4, section 7.1. Hue in degrees, the others in 0..1.
Colour from_hsl(double hue, double saturation, double lightness) {
    hue = std::fmod(std::fmod(hue, 360.0) + 360.0, 360.0);
    const double reach = saturation * std::min(lightness, 1 - lightness);
    const auto channel = [&](double n) {
        const double k = std::fmod(n + hue / 30, 12.0);
        return byte(255 * (lightness - reach * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}))));
    };
    return {channel(0), channel(8), channel(4)};
}

/// The inside of rgb(...) or hsl(...).
std::optional<Ink> from_function(std::string_view inside, bool hsl) {
    struct Component {
        double value;
        bool percent;
    };
    std::array<Component, 4> parts{};
    std::size_t count = 0;
    Scanner scanner{trimmed(inside)};
    while (!scanner.done()) {
        if (count == parts.size()) return std::nullopt;
        const auto number = take_number(scanner);
        if (number.state != ValueState::good) return std::nullopt;
        auto& part = parts[count++];
        part = {number.value, scanner.peek() == '%'};
        if (part.percent) ++scanner.at;
        if (hsl && count == 1 && scanner.text.substr(scanner.at).starts_with("deg")) scanner.at += 3;
        skip_separator(scanner);
        if (scanner.peek() == '/' && count == 3) {
            ++scanner.at;
            skip_space(scanner);
        }
    }
    if (count < 3) return std::nullopt;
    Ink ink;
    if (count == 4)
        ink.alpha = std::clamp(parts[3].percent ? parts[3].value / 100 : parts[3].value, 0.0, 1.0);
    if (hsl) {
        const auto share = [&](std::size_t i) { return std::clamp(parts[i].value / 100, 0.0, 1.0); };
        ink.colour = from_hsl(parts[0].value, share(1), share(2));
    } else {
        const auto channel = [&](std::size_t i) {
            return byte(parts[i].percent ? parts[i].value * 2.55 : parts[i].value);
        };
        ink.colour = {channel(0), channel(1), channel(2)};
    }
    return ink;
}

}  // namespace

std::optional<Ink> read_colour(std::string_view text) {
    constexpr std::size_t longest =
        200;  // a colour is never longer; keeps a wrong one from being copied about
    if (const auto icc = text.find(" icc-color("); icc != std::string_view::npos)
        text = trimmed(text.substr(0, icc));
    if (text.empty() || text.size() > longest) return std::nullopt;
    const std::string word = lower_case(text);
    if (word[0] == '#') return from_hex(std::string_view(word).substr(1));
    for (const std::string_view start : {"rgb(", "rgba(", "hsl(", "hsla("})
        if (word.starts_with(start) && word.ends_with(')'))
            return from_function(std::string_view(word).substr(start.size(), word.size() - start.size() - 1),
                                 start[0] == 'h');
    if (word == "transparent") return Ink{{}, 0};
    const auto found = std::ranges::lower_bound(named_colours, std::string_view(word), {}, &Named::name);
    if (found == named_colours.end() || found->name != word) return std::nullopt;
    return Ink{from_rgb(found->rgb), 1};
}

std::optional<double> read_share(std::string_view text) {
    Scanner scanner{trimmed(text)};
    const auto number = take_number(scanner);
    if (number.state != ValueState::good) return std::nullopt;
    double value = number.value;
    if (scanner.peek() == '%') {
        value /= 100;
        ++scanner.at;
    }
    if (!scanner.done()) return std::nullopt;
    return std::clamp(value, 0.0, 1.0);
}

}  // namespace strandline::svg
