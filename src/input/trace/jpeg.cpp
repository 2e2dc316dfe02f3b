// JPEG by libjpeg-turbo, its orientation by libexif. Errors come as long jumps: what they may leave behind
// lives in Reading, outside the function that they leave.
#include <fmt/format.h>
#include <libexif/exif-data.h>

#include <array>
#include <csetjmp>
#include <cwchar>

// after <cwchar>: it needs FILE
#include <jpeglib.h>

// after jpeglib.h
#include <jerror.h>

#include "input/trace/pixels.hpp"

namespace strandline::trace {
namespace {

struct Reading {
    Limits limits;
    jpeg_error_mgr handler{};
    std::jmp_buf jump{};
    jpeg_decompress_struct jpeg{};
    Picture picture = {};
    std::vector<unsigned char> row = {};
    std::string reason = {};
    std::optional<Error> too_large = {};
    int orientation = 0;  ///< EXIF's
    bool cut_off = false;

    explicit Reading(const Limits& most) : limits(most) {}
    ~Reading() { jpeg_destroy_decompress(&jpeg); }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
};

Reading& reading_of(j_common_ptr jpeg) { return *static_cast<Reading*>(jpeg->client_data); }

std::string message_of(j_common_ptr jpeg) {
    std::array<char, JMSG_LENGTH_MAX> text{};
    jpeg->err->format_message(jpeg, text.data());
    return text.data();
}

[[noreturn]] void on_error(j_common_ptr jpeg) {
    Reading& reading = reading_of(jpeg);
    reading.reason = message_of(jpeg);
    std::longjmp(reading.jump, 1);  // NOLINT(cert-err52-cpp): libjpeg has no other way
}
/// level -1: the data is damaged, and the decoder goes on with what it has.
void on_message(j_common_ptr jpeg, int level) {
    if (level != -1) return;
    Reading& reading = reading_of(jpeg);
    if (jpeg->err->msg_code == JWRN_JPEG_EOF || jpeg->err->msg_code == JWRN_HIT_MARKER)
        reading.cut_off = true;
    if (jpeg->err->num_warnings++ == 0)
        reading.picture.warnings.push_back(
            {"picture", "libjpeg says: " + message_of(jpeg) + "; parts of it may be wrong"});
}

/// EXIF's tag 0x0112; 0 where there is none.
int orientation_of(const jpeg_decompress_struct& jpeg) {
    int orientation = 0;
    for (const jpeg_marker_struct* marker = jpeg.marker_list; marker; marker = marker->next) {
        ExifData* data = exif_data_new_from_data(marker->data, marker->data_length);
        if (!data) continue;
        const ExifEntry* entry = exif_content_get_entry(data->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION);
        if (entry && entry->format == EXIF_FORMAT_SHORT && entry->size >= 2 && orientation == 0)
            orientation = exif_get_short(entry->data, exif_data_get_byte_order(data));
        exif_data_unref(data);
    }
    return orientation;
}

std::optional<Point> size_of(const jpeg_decompress_struct& jpeg) {
    constexpr int to_the_inch = 1, to_the_centimetre = 2;
    if (!jpeg.saw_JFIF_marker || jpeg.X_density == 0 || jpeg.Y_density == 0) return std::nullopt;
    const double unit = jpeg.density_unit == to_the_inch         ? metres_in_inch
                        : jpeg.density_unit == to_the_centimetre ? 0.01
                                                                 : 0;
    if (unit == 0) return std::nullopt;
    return Point{unit * jpeg.image_width / jpeg.X_density, unit * jpeg.image_height / jpeg.Y_density};
}

void keep_row(Reading& reading) {
    const unsigned char* at = reading.row.data();
    const bool cmyk = reading.jpeg.out_color_space == JCS_CMYK;
    // Adobe stores ink as what it leaves of the paper's white.
    const bool inverted = reading.jpeg.saw_Adobe_marker;
    for (int x = 0; x < reading.picture.width; ++x) {
        if (!cmyk) {
            reading.picture.grey.push_back(grey_of(at[0], at[1], at[2]));
            at += 3;
            continue;
        }
        const auto left = [&](int i) -> unsigned { return inverted ? at[i] : 255U - at[i]; };
        const unsigned k = left(3);
        reading.picture.grey.push_back(grey_of(left(0) * k / 255, left(1) * k / 255, left(2) * k / 255));
        at += 4;
    }
}

void read_pixels(Reading& reading) {
    jpeg_decompress_struct& jpeg = reading.jpeg;
    if (const auto fits = within(reading.limits, jpeg.image_width, jpeg.image_height); !fits) {
        reading.too_large = fits.error();
        return;
    }
    const bool cmyk = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    jpeg.out_color_space = cmyk ? JCS_CMYK : JCS_RGB;
    jpeg.dct_method = JDCT_ISLOW;  // the same on every machine
    reading.picture.width = static_cast<int>(jpeg.image_width);
    reading.picture.height = static_cast<int>(jpeg.image_height);
    reading.picture.size_metres = size_of(jpeg);
    reading.picture.grey.reserve(std::size_t{jpeg.image_width} * jpeg.image_height);
    reading.row.resize(std::size_t{jpeg.image_width} * (cmyk ? 4 : 3));
    jpeg_start_decompress(&jpeg);
    unsigned char* row = reading.row.data();
    while (jpeg.output_scanline < jpeg.output_height) {
        jpeg_read_scanlines(&jpeg, &row, 1);
        keep_row(reading);
    }
    jpeg_finish_decompress(&jpeg);
}

}  // namespace

Outcome<Picture> read_jpeg(std::string_view bytes, const Limits& limits) {
    Reading reading(limits);
    reading.jpeg.err = jpeg_std_error(&reading.handler);
    reading.jpeg.client_data = &reading;
    reading.handler.error_exit = on_error;
    reading.handler.emit_message = on_message;
    if (setjmp(reading.jump) == 0) {  // NOLINT(cert-err52-cpp)
        jpeg_create_decompress(&reading.jpeg);
        reading.jpeg.client_data = &reading;
        jpeg_mem_src(&reading.jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        jpeg_save_markers(&reading.jpeg, JPEG_APP0 + 1, 0xFFFF);
        jpeg_read_header(&reading.jpeg, TRUE);
        reading.orientation = orientation_of(reading.jpeg);
        read_pixels(reading);
    }
    if (reading.too_large) return tl::unexpected(*reading.too_large);
    if (!reading.reason.empty() || reading.cut_off)
        return fail("",
                    "is a JPEG picture that cannot be read: " +
                        (reading.cut_off ? "the file is cut off" : reading.reason),
                    "save it anew");
    return upright(std::move(reading.picture), reading.orientation);
}

}  // namespace strandline::trace
