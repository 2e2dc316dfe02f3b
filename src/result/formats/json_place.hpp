#pragma once
// Private to the room: values of a parsed file, each with its place in it, taken strictly.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "math/curve/curve.hpp"

namespace strandline::formats {

using Json = nlohmann::json;

/// A value of the file and the way to it, from which the JSON pointer (RFC 6901) is put together when
/// something is wrong there.
struct At {
    const Json& value;
    const At* parent = nullptr;
    std::string_view key = {};
    std::size_t index = 0;
};

/// Thrown by all of these and caught where the room's readers begin, never beyond: a reader of sixty nested
/// fields stays readable that way.
struct Refused {
    std::string pointer, reason;
};
[[noreturn]] void refuse(const At& at, std::string reason);
[[noreturn]] void mistyped(const At& at, const char* wanted);

At child(const At& at, std::string_view key);
At item(const At& at, std::size_t index);
const std::vector<Json>& array_at(const At& at);
/// An array that holds whole groups of `group` values.
const std::vector<Json>& groups_at(const At& at, std::size_t group);
double number(const At& at);
long long whole(const At& at, long long low, long long high);
std::vector<double> numbers(const At& at);
std::vector<double> exactly(const At& at, std::size_t count);
std::string text_at(const At& at);
/// ["M", x, y, "L", ...]
Path path_at(const At& at);
/// Refuses keys beside these.
void no_others(const At& at, const std::vector<std::string_view>& known);

}  // namespace strandline::formats
