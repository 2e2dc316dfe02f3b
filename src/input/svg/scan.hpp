#pragma once
// Private to the room: the small grammars inside attributes (numbers, lengths, transforms), independent of
// locale.
#include <cstddef>
#include <string>
#include <string_view>

#include "math/geometry/geometry.hpp"

namespace strandline::svg {

/// Larger coordinates lose millimetres to rounding at any drawing size, and their squares soon overflow.
inline constexpr double largest_number = 1e15;

/// How reading a value went. `refused`: it is a number, but not finite or beyond largest_number: the file is
/// at fault.
enum class ValueState { good, malformed, refused };

struct Scanner {
    std::string_view text;
    std::size_t at = 0;
    bool done() const { return at >= text.size(); }
    char peek() const { return done() ? '\0' : text[at]; }
};
bool is_space(char c);
std::string_view trimmed(std::string_view text);
/// ASCII letters only, as CSS compares keywords.
std::string lower_case(std::string_view text);
void skip_space(Scanner& scanner);
/// Spaces and at most one comma between; true when there was one.
bool skip_separator(Scanner& scanner);
/// A digit, sign or dot, or one of the words for what is no number (nan, inf), which take_number then
/// refuses.
bool at_number(const Scanner& scanner);

struct Number {
    ValueState state = ValueState::malformed;
    double value = 0;
};
/// The longest number at the scanner: sign, `.5`, `5.`, exponent. Stays where it is when malformed.
Number take_number(Scanner& scanner);

/// What percentages and absolute units refer to.
struct Viewport {
    double width = 0, height = 0;
    double dpi = 96;  ///< px to the inch
};
enum class Axis { x, y, diagonal };
struct Length {
    ValueState state = ValueState::malformed;
    double value = 0;      ///< user units (px)
    bool percent = false;  ///< it was one
};
/// A length with or without a unit: px, pt, pc, mm, cm, in, Q, em, ex, ch, rem, %.
Length read_length(std::string_view text, Axis axis, const Viewport& viewport, double font_size);

struct Transform {
    ValueState state = ValueState::good;
    Affine map;
};
/// A transform list: matrix, translate, scale, rotate (with centre), skewX, skewY; also `px` and `deg` as CSS
/// writes them.
Transform read_transform(std::string_view text);

}  // namespace strandline::svg
