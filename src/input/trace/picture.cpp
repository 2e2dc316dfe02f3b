// Which format a file is in, and what pictures of all formats have in common.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "input/trace/pixels.hpp"

namespace strandline::trace {

std::string_view format_of(std::string_view bytes) {
    using namespace std::string_view_literals;
    struct Magic {
        std::size_t at;
        std::string_view bytes, format;
    };
    constexpr std::array magics{Magic{0, "\x89PNG\r\n\x1a\n"sv, "PNG"},
                                Magic{0, "\xff\xd8\xff"sv, "JPEG"},
                                Magic{0, "GIF8"sv, "GIF"},
                                Magic{8, "WEBP"sv, "WebP"},
                                Magic{0, "II*\0"sv, "TIFF"},
                                Magic{0, "MM\0*"sv, "TIFF"},
                                Magic{0, "BM"sv, "BMP"},
                                Magic{4, "ftyp"sv, "HEIC or AVIF"}};
    for (const Magic& magic : magics)
        if (bytes.size() >= magic.at && bytes.substr(magic.at).starts_with(magic.bytes)) return magic.format;
    return {};
}

Outcome<Picture> read_picture(std::string_view bytes, const Limits& limits) {
    const std::string_view format = format_of(bytes);
    if (format == "PNG") return read_png(bytes, limits);
    if (format == "JPEG") return read_jpeg(bytes, limits);
    if (bytes.empty()) return fail("", "the file is empty", "name a PNG or JPEG picture");
    if (format.empty()) return fail("", "is not a picture that is known", "name a PNG or JPEG picture");
    return fail("", fmt::format("is a {} picture", format), "convert it to PNG");
}

Outcome<void> within(const Limits& limits, std::uint64_t width, std::uint64_t height) {
    if (width * height <= limits.pixels) return {};
    return fail("",
                fmt::format("is {} x {} pixels, more than {} million in all", width, height,
                            limits.pixels / 1'000'000),
                "scale it down");
}

Picture upright(Picture picture, int orientation) {
    if (orientation < 2 || orientation > 8) return picture;
    const int w = picture.width, h = picture.height;
    const bool transposed = orientation >= 5;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Picture turned{
        transposed ? h : w, transposed ? w : h, {}, picture.size_metres, std::move(picture.warnings)};
    if (transposed && turned.size_metres) std::swap(turned.size_metres->x, turned.size_metres->y);
    turned.grey.reserve(picture.grey.size());
    for (int row = 0; row < turned.height; ++row)
        for (int column = 0; column < turned.width; ++column) {
            const int x = transposed ? row : column, y = transposed ? column : row;
            const auto from_x = static_cast<std::size_t>(from_right ? w - 1 - x : x);
            const auto from_y = static_cast<std::size_t>(from_below ? h - 1 - y : y);
            turned.grey.push_back(picture.grey[from_y * static_cast<std::size_t>(w) + from_x]);
        }
    return turned;
}

}  // namespace strandline::trace
