#pragma once
// Private to the room: CSS colours as SVG files write them.
#include <optional>
#include <string_view>

#include "input/svg/svg.hpp"

namespace strandline::svg {

struct Ink {
    Colour colour;
    double alpha = 1;
};
/// Names, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla() with numbers, percentages, commas or
/// spaces, `transparent`. What follows an sRGB colour as icc-color(...) is passed over. Nothing for what is
/// no colour (also none and currentColor, which need a context). The text has no spaces around it.
std::optional<Ink> read_colour(std::string_view text);
/// 0..1 from a number or a percentage; clamped.
std::optional<double> read_share(std::string_view text);

}  // namespace strandline::svg
