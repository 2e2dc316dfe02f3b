#include "input/svg/scan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace strandline::svg {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// std::from_chars says "out of range" for both ends: this tells 1e999 from 1e-999 by the decimal place of
/// the first digit that counts.
bool underflows(std::string_view number) {
    constexpr long far = 1'000'000;  // exponents beyond it decide by their sign alone
    const auto exponent_at = number.find_first_of("eE");
    long exponent = 0;
    if (exponent_at != std::string_view::npos) {
        std::size_t i = exponent_at + 1;
        const bool negative = number[i] == '-';
        if (number[i] == '-' || number[i] == '+') ++i;
        for (; i < number.size(); ++i) exponent = std::min(far, exponent * 10 + (number[i] - '0'));
        if (negative) exponent = -exponent;
    }
    const auto mantissa = number.substr(0, exponent_at);
    const auto dot = std::min(mantissa.find('.'), mantissa.size());
    const auto first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    const long place = static_cast<long>(dot) - static_cast<long>(first);
    return exponent + place < 0;
}

/// The word nan, inf or infinity at the scanner, after a sign if any.
bool at_non_number(const Scanner& scanner) {
    std::size_t i = scanner.at;
    const auto& text = scanner.text;
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    if (i + 3 > text.size()) return false;
    const char a = lower(text[i]), b = lower(text[i + 1]), c = lower(text[i + 2]);
    return (a == 'n' && b == 'a' && c == 'n') || (a == 'i' && b == 'n' && c == 'f');
}

}  // namespace

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = lower(c);
    return result;
}

void skip_space(Scanner& scanner) {
    while (!scanner.done() && is_space(scanner.text[scanner.at])) ++scanner.at;
}

bool skip_separator(Scanner& scanner) {
    skip_space(scanner);
    if (scanner.peek() != ',') return false;
    ++scanner.at;
    skip_space(scanner);
    return true;
}

bool at_number(const Scanner& scanner) {
    const char c = scanner.peek();
    return is_digit(c) || c == '.' || c == '-' || c == '+' || at_non_number(scanner);
}

Number take_number(Scanner& scanner) {
    if (at_non_number(scanner)) return {ValueState::refused, 0};
    const char* const end = scanner.text.data() + scanner.text.size();
    const char* first = scanner.text.data() + scanner.at;
    if (first != end && *first == '+') {  // from_chars takes no plus, and "+-1" is no number
        ++first;
        if (first != end && *first == '-') return {};
    }
    double value = 0;
    const auto [last, error] = std::from_chars(first, end, value);
    if (error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) {
        if (!underflows({first, last})) return {ValueState::refused, 0};
        value = 0;
    }
    if (std::abs(value) > largest_number) return {ValueState::refused, value};
    scanner.at = static_cast<std::size_t>(last - scanner.text.data());
    return {ValueState::good, value};
}

Length read_length(std::string_view text, Axis axis, const Viewport& viewport, double font_size) {
    Scanner scanner{trimmed(text)};
    const auto number = take_number(scanner);
    if (number.state != ValueState::good) return {number.state, 0, false};
    const auto unit = lower_case(trimmed(scanner.text.substr(scanner.at)));
    const auto good = [&](double factor) {
        const double value = number.value * factor;
        return Length{std::abs(value) > largest_number ? ValueState::refused : ValueState::good, value,
                      unit == "%"};
    };
    if (unit.empty() || unit == "px") return good(1);
    if (unit == "pt") return good(viewport.dpi / 72.0);
    if (unit == "pc") return good(viewport.dpi / 6);
    if (unit == "mm") return good(viewport.dpi / 25.4);
    if (unit == "cm") return good(viewport.dpi / 2.54);
    if (unit == "in") return good(viewport.dpi);
    if (unit == "q") return good(viewport.dpi / 101.6);
    if (unit == "em") return good(font_size);
    if (unit == "ex" || unit == "ch")
        return good(font_size / 2);  // what CSS asks for where the font is not known
    if (unit == "rem") return good(16);
    if (unit == "%") {
        if (axis == Axis::x) return good(viewport.width / 100);
        if (axis == Axis::y) return good(viewport.height / 100);
        // SVG 2, 8.9: percentages of neither axis refer to the diagonal / sqrt 2
        return good(std::hypot(viewport.width, viewport.height) / std::numbers::sqrt2 / 100);
    }
    return {};
}

namespace {

/// Quarter turns are exact, so that what was upright stays upright.
Affine rotation(double degrees) {
    const double quarters = std::fmod(degrees, 360.0) / 90;
    if (quarters == std::floor(quarters)) {
        constexpr std::array<double, 4> cosines{1, 0, -1, 0};
        const auto i = static_cast<std::size_t>(static_cast<int>(quarters) + 4) % 4;
        const double c = cosines[i], s = cosines[(i + 3) % 4];
        return {c, s, -s, c, 0, 0};
    }
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    return {c, s, -s, c, 0, 0};
}

/// The map of one function of a transform list; nothing when its name or its count of numbers is wrong.
std::optional<Affine> transform_function(std::string_view name, const std::array<double, 6>& v,
                                         std::size_t n) {
    const auto slant = [&] { return std::tan(v[0] * pi / 180); };
    if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (n == 1 || n == 2)) return Affine{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
    if (name == "scale" && (n == 1 || n == 2)) return Affine{v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
    if (name == "rotate" && n == 1) return rotation(v[0]);
    if (name == "rotate" && n == 3)
        return composed({1, 0, 0, 1, v[1], v[2]}, composed(rotation(v[0]), {1, 0, 0, 1, -v[1], -v[2]}));
    if (name == "skewX" && n == 1) return Affine{1, 0, slant(), 1, 0, 0};
    if (name == "skewY" && n == 1) return Affine{1, slant(), 0, 1, 0, 0};
    return std::nullopt;
}

bool within_range(const Affine& m) {
    return std::ranges::all_of(std::array{m.a, m.b, m.c, m.d, m.e, m.f},
                               [](double v) { return std::abs(v) <= largest_number; });
}

}  // namespace

Transform read_transform(std::string_view text) {
    Transform result;
    Scanner scanner{trimmed(text)};
    if (scanner.text == "none") return result;
    const Transform malformed{ValueState::malformed, {}}, refused{ValueState::refused, {}};
    while (!scanner.done()) {
        const std::size_t name_at = scanner.at;
        while (is_letter(scanner.peek())) ++scanner.at;
        const auto name = scanner.text.substr(name_at, scanner.at - name_at);
        skip_space(scanner);
        if (name.empty() || scanner.peek() != '(') return malformed;
        ++scanner.at;
        skip_space(scanner);
        std::array<double, 6> values{};
        std::size_t count = 0;
        while (scanner.peek() != ')') {
            if (count == values.size()) return malformed;
            const auto number = take_number(scanner);
            if (number.state != ValueState::good) return {number.state, {}};
            values[count++] = number.value;
            const auto rest = scanner.text.substr(scanner.at);
            if (rest.starts_with("px")) scanner.at += 2;
            if (rest.starts_with("deg")) scanner.at += 3;
            if (skip_separator(scanner) && scanner.peek() == ')') return malformed;
        }
        ++scanner.at;
        const auto map = transform_function(name, values, count);
        if (!map) return malformed;
        result.map = composed(result.map, *map);
        if (!within_range(result.map)) return refused;
        skip_space(scanner);
        while (scanner.peek() == ',')
            skip_separator(scanner);  // SVG 1.1 lets any number of commas stand here
    }
    return result;
}

}  // namespace strandline::svg
