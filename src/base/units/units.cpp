#include "base/units/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace strandline {
namespace {

struct Split {
    double number;
    std::string_view unit;
};

Outcome<Split> split(std::string_view text, const std::string& place) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code != std::errc{} || !std::isfinite(number))
        return fail(place, fmt::format("\"{}\" is not a finite number", text), "write a number such as 0.4");
    std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
    while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
    return Split{number, unit};
}

struct Unit {
    std::string_view name;
    double factor;
};

Outcome<double> parse_quantity(std::string_view text, const std::string& place,
                               std::initializer_list<Unit> units) {
    const auto parts = split(text, place);
    if (!parts) return tl::unexpected(parts.error());
    std::string known;
    for (const Unit& unit : units) {
        if (parts->unit == unit.name) return parts->number * unit.factor;
        if (!unit.name.empty()) known += (known.empty() ? "" : ", ") + std::string(unit.name);
    }
    return fail(place, fmt::format("unknown unit \"{}\"", parts->unit), "use one of " + known);
}

}  // namespace

Outcome<double> parse_length(std::string_view text, const std::string& place) {
    return parse_quantity(
        text, place,
        {{"", 1}, {"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000}, {"ft", 0.3048}, {"in", 0.0254}});
}
Outcome<double> parse_angle(std::string_view text, const std::string& place) {
    constexpr double degree = std::numbers::pi / 180;
    return parse_quantity(text, place, {{"", degree}, {"deg", degree}, {"rad", 1}});
}
Outcome<double> parse_duration(std::string_view text, const std::string& place) {
    return parse_quantity(text, place, {{"", 1}, {"s", 1}, {"min", 60}, {"h", 3600}});
}
Outcome<double> parse_number(std::string_view text, const std::string& place) {
    return parse_quantity(text, place, {{"", 1}});
}
std::string number_text(double value) { return fmt::format("{}", value); }

}  // namespace strandline
