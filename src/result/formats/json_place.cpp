#include "result/formats/json_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace strandline::formats {

namespace {

std::string pointer(const At& at) {
    if (!at.parent) return {};
    return pointer(*at.parent) + "/" + (at.key.empty() ? std::to_string(at.index) : std::string(at.key));
}

std::string kind_of(const Json& value) {
    if (value.is_null()) return "null";
    if (value.is_number()) return value.is_number_integer() ? "a whole number" : "a number";
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array";
    return value.is_string() ? "a text" : "true or false";
}

}  // namespace

void refuse(const At& at, std::string reason) { throw Refused{pointer(at), std::move(reason)}; }

void mistyped(const At& at, const char* wanted) {
    refuse(at, fmt::format("{} where {} belongs", kind_of(at.value), wanted));
}

const std::vector<Json>& array_at(const At& at) {
    if (!at.value.is_array()) mistyped(at, "an array");
    return at.value.get_ref<const std::vector<Json>&>();
}
const std::vector<Json>& groups_at(const At& at, std::size_t group) {
    const auto& values = array_at(at);
    if (values.size() % group != 0)
        refuse(at, fmt::format("holds {} values, not a multiple of {}", values.size(), group));
    return values;
}
At child(const At& at, std::string_view key) {
    if (!at.value.is_object()) mistyped(at, "an object");
    const auto found = at.value.find(key);
    if (found == at.value.end()) refuse(at, fmt::format("\"{}\" is missing", key));
    return {*found, &at, key};
}
At item(const At& at, std::size_t index) { return {at.value[index], &at, {}, index}; }

double number(const At& at) {
    if (!at.value.is_number()) mistyped(at, "a finite number");
    return at.value.get<double>();  // finite: the parser refuses 1e999
}
long long whole(const At& at, long long low, long long high) {
    const Json& value = at.value;
    if (!value.is_number_integer()) mistyped(at, "a whole number");
    const bool huge =
        value.is_number_unsigned() && value.get<unsigned long long>() > static_cast<unsigned long long>(high);
    if (huge || value.get<long long>() < low || value.get<long long>() > high)
        refuse(at, fmt::format("{} is out of range", value.dump()));
    return value.get<long long>();
}
std::vector<double> numbers(const At& at) {
    const auto& values = array_at(at);
    std::vector<double> list(values.size());
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = number(item(at, i));
    return list;
}
std::vector<double> exactly(const At& at, std::size_t count) {
    auto list = numbers(at);
    if (list.size() != count) refuse(at, fmt::format("{} numbers where {} belong", list.size(), count));
    return list;
}

std::string text_at(const At& at) {
    if (!at.value.is_string()) mistyped(at, "a text");
    return at.value.get_ref<const std::string&>();
}

void no_others(const At& at, const std::vector<std::string_view>& known) {
    if (at.value.size() == known.size()) return;
    for (const auto& [key, value] : at.value.items())
        if (std::ranges::find(known, key) == known.end())
            refuse(at, fmt::format("\"{}\" is no key of it", key));
}

Path path_at(const At& at) {
    Path path;
    const auto& values = array_at(at);
    std::size_t i = 0;
    const auto next_number = [&] {
        if (i >= values.size()) refuse(at, "the path ends inside a segment");
        return number(item(at, i++));
    };
    const auto next_point = [&] {
        const double x = next_number();
        return Point{x, next_number()};
    };
    while (i < values.size()) {
        const At place = item(at, i);
        const std::string letter = text_at(place);
        if ((letter == "M") != (i == 0)) refuse(place, "a path begins with the one M that it has");
        ++i;
        if (letter == "M") {
            path.start = next_point();
        } else if (letter == "L") {
            path.segments.push_back(LineSegment{next_point()});
        } else if (letter == "C") {
            const Point control1 = next_point(), control2 = next_point();
            path.segments.push_back(CubicSegment{control1, control2, next_point()});
        } else if (letter == "A") {
            const Point center = next_point(), u = next_point(), v = next_point();
            const double start = next_number(), sweep = next_number();
            path.segments.push_back(ArcSegment{center, u, v, start, sweep, next_point()});
        } else if (letter == "Z" && i == values.size()) {
            path.closed = true;
        } else {
            refuse(place, fmt::format("\"{}\" is no segment of a path", letter));
        }
    }
    if (values.empty()) refuse(at, "a path begins with the one M that it has");
    return path;
}

}  // namespace strandline::formats
