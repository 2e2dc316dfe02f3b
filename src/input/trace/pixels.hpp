#pragma once
// Private to the room: one function a format, and what they share.
#include <cstdint>

#include "input/trace/trace.hpp"

namespace strandline::trace {

Outcome<Picture> read_png(std::string_view bytes, const Limits& limits);
Outcome<Picture> read_jpeg(std::string_view bytes, const Limits& limits);

inline unsigned char grey_of(unsigned r, unsigned g, unsigned b) {
    return static_cast<unsigned char>((2126 * r + 7152 * g + 722 * b + 5000) / 10000);
}
/// "is W x H pixels ...", where that is over the limit.
Outcome<void> within(const Limits& limits, std::uint64_t width, std::uint64_t height);
/// The picture as it was seen: `orientation` is EXIF's, 1 to 8 (2 to 4 flipped and turned, from 5 on also
/// transposed); others leave it as it is.
Picture upright(Picture picture, int orientation);

constexpr double metres_in_inch = 0.0254;

}  // namespace strandline::trace
