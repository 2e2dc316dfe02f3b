// PNG by libpng. Its errors come as long jumps: what they may leave behind lives in Reading, outside the
// function that they leave.
#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>

#include "input/trace/pixels.hpp"

namespace strandline::trace {
namespace {

struct Reading {
    std::string_view rest;
    Limits limits;
    Picture picture = {};
    std::vector<unsigned char> rgba = {};   ///< one row, or the whole of an interlaced picture
    std::vector<unsigned char*> rows = {};  ///< of an interlaced picture
    std::string reason = {};
    std::optional<Error> too_large = {};
    png_structp png = nullptr;
    png_infop info = nullptr;

    Reading(std::string_view bytes, const Limits& most) : rest(bytes), limits(most) {}
    ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
};

Reading& reading_of(png_structp png) { return *static_cast<Reading*>(png_get_error_ptr(png)); }

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    reading_of(png).reason = message;
    png_longjmp(png, 1);
}
void on_warning(png_structp png, png_const_charp message) {
    Warnings& warnings = reading_of(png).picture.warnings;
    const Warning warning{"picture", fmt::format("libpng says: {}", message)};
    if (warnings.empty() || warnings.back() != warning) warnings.push_back(warning);
}
void on_read(png_structp png, png_bytep to, png_size_t size) {
    Reading& reading = *static_cast<Reading*>(png_get_io_ptr(png));
    if (reading.rest.size() < size) png_error(png, "the file is cut off");
    std::memcpy(to, reading.rest.data(), size);
    reading.rest.remove_prefix(size);
}

void keep_row(Reading& reading, const unsigned char* rgba) {
    const auto on_white = [](unsigned value, unsigned alpha) {
        return (value * alpha + 255 * (255 - alpha) + 127) / 255;
    };
    for (int x = 0; x < reading.picture.width; ++x, rgba += 4) {
        const unsigned a = rgba[3];
        reading.picture.grey.push_back(
            grey_of(on_white(rgba[0], a), on_white(rgba[1], a), on_white(rgba[2], a)));
    }
}

void read_header(Reading& reading) {
    png_structp png = reading.png;
    png_read_info(png, reading.info);
    const png_uint_32 width = png_get_image_width(png, reading.info);
    const png_uint_32 height = png_get_image_height(png, reading.info);
    if (const auto fits = within(reading.limits, width, height); !fits) {
        reading.too_large = fits.error();
        return;
    }
    reading.picture.width = static_cast<int>(width);
    reading.picture.height = static_cast<int>(height);
    png_uint_32 across = 0, down = 0;  // pixels to the metre
    int unit = PNG_RESOLUTION_UNKNOWN;
    if (png_get_pHYs(png, reading.info, &across, &down, &unit) && unit == PNG_RESOLUTION_METER &&
        across > 0 && down > 0)
        reading.picture.size_metres = Point{double(width) / across, double(height) / down};
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
}

void read_pixels(Reading& reading) {
    const bool interlaced = png_set_interlace_handling(reading.png) > 1;
    png_read_update_info(reading.png, reading.info);
    const auto height = static_cast<std::size_t>(reading.picture.height);
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(reading.picture.width);
    reading.picture.grey.reserve(row_bytes / 4 * height);
    reading.rgba.resize(interlaced ? row_bytes * height : row_bytes);
    if (interlaced) {
        for (std::size_t y = 0; y < height; ++y) reading.rows.push_back(reading.rgba.data() + y * row_bytes);
        png_read_image(reading.png, reading.rows.data());
        for (const unsigned char* row : reading.rows) keep_row(reading, row);
    } else {
        for (std::size_t y = 0; y < height; ++y) {
            png_read_row(reading.png, reading.rgba.data(), nullptr);
            keep_row(reading, reading.rgba.data());
        }
    }
    png_read_end(reading.png, nullptr);
}

}  // namespace

Outcome<Picture> read_png(std::string_view bytes, const Limits& limits) {
    Reading reading(bytes, limits);
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, on_error, on_warning);
    if (reading.png) reading.info = png_create_info_struct(reading.png);
    if (!reading.info) return fail("", "libpng cannot be started");
    if (setjmp(png_jmpbuf(reading.png)) == 0) {  // NOLINT(cert-err52-cpp): libpng has no other way
        png_set_read_fn(reading.png, &reading, on_read);
        read_header(reading);
        if (!reading.too_large) read_pixels(reading);
    } else {
        return fail("", "is a PNG picture that cannot be read: " + reading.reason, "save it anew");
    }
    if (reading.too_large) return tl::unexpected(*reading.too_large);
    return std::move(reading.picture);
}

}  // namespace strandline::trace
