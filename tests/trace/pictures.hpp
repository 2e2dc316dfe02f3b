#pragma once
// Pictures made for the tests, and their files.
#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <functional>

// after <cstdio>, which it does not include
#include <jpeglib.h>

#include "input/trace/trace.hpp"

namespace strandline::trace {

/// Ink (black) where `dark` says so; x, y from the upper left.
inline Picture drawn(int width, int height, const std::function<bool(int, int)>& dark, unsigned char ink = 0,
                     unsigned char paper = 255) {
    Picture picture{width, height, {}, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture.grey.push_back(dark(x, y) ? ink : paper);
    return picture;
}

struct PngForm {
    int colour_type = PNG_COLOR_TYPE_GRAY, depth = 8;
    bool interlaced = false;
    unsigned pixels_per_metre = 0;
};
/// `row_bytes` bytes a row, as the form has them.
inline std::string png_file(unsigned width, unsigned height, std::string data, const PngForm& form = {}) {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp p, png_bytep bytes, png_size_t size) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(bytes), size);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, form.depth, form.colour_type,
                 form.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const png_color palette[2] = {{255, 255, 255}, {0, 0, 0}};
    if (form.colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
    if (form.pixels_per_metre > 0)
        png_set_pHYs(png, info, form.pixels_per_metre, 2 * form.pixels_per_metre, PNG_RESOLUTION_METER);
    const std::size_t row_bytes = data.size() / height;
    std::vector<png_bytep> rows;
    for (unsigned y = 0; y < height; ++y)
        rows.push_back(reinterpret_cast<png_bytep>(data.data() + y * row_bytes));
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return file;
}

struct JpegForm {
    int orientation = 0;  ///< EXIF's; 0: no EXIF
    int channels = 1;     ///< 1 grey, 3 RGB, 4 CMYK as Adobe writes it (inverted)
    int dots_per_inch = 0;
};
inline std::string jpeg_file(unsigned width, unsigned height, std::string data, const JpegForm& form = {}) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr handler{};
    jpeg.err = jpeg_std_error(&handler);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = width;
    jpeg.image_height = height;
    jpeg.input_components = form.channels;
    jpeg.in_color_space = form.channels == 1 ? JCS_GRAYSCALE : form.channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (form.dots_per_inch > 0) {
        jpeg.density_unit = 1;
        jpeg.X_density = jpeg.Y_density = static_cast<UINT16>(form.dots_per_inch);
    }
    jpeg_start_compress(&jpeg, TRUE);
    if (form.orientation > 0) {
        using namespace std::string_literals;
        // TIFF header, one entry: tag 0x0112, type short, one value.
        std::string exif = "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0?\0\0\0\0\0\0"s;
        exif[exif.find('?')] = static_cast<char>(form.orientation);
        jpeg_write_marker(&jpeg, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(exif.data()),
                          static_cast<unsigned>(exif.size()));
    }
    const std::size_t row_bytes = std::size_t{width} * static_cast<unsigned>(form.channels);
    for (unsigned y = 0; y < height; ++y) {
        JSAMPROW row = reinterpret_cast<JSAMPROW>(data.data() + y * row_bytes);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    std::string file(reinterpret_cast<char*>(bytes), size);
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
    return file;
}

}  // namespace strandline::trace
