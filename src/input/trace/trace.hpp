#pragma once
// Pictures (PNG, JPEG) -> areas of ink: decoded to grey, cut at a threshold, traced by potrace. What comes
// out is a drawing in pixels of the picture, y down, with exact cubic outlines and holes.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/svg/svg.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline::trace {

/// The kind of picture by the first bytes: "PNG", "JPEG", and those that read_picture() refuses by name:
/// "GIF", "WebP", "TIFF", "BMP", "HEIC or AVIF". Empty: none of them.
std::string_view format_of(std::string_view bytes);

/// Rows from the top, each from the left, 0 black to 255 white. grey.size() = width * height, both at
/// least 1.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned char> grey;
    std::optional<Point> size_metres;  ///< where the file states its resolution
    Warnings warnings;                 ///< what a decoder repaired
};

struct Limits {
    std::size_t pixels = 100'000'000;
};

/// Grey is 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709) of the values as stored, transparent parts lie on
/// white, and a photo that was taken turned (EXIF) stands upright. Error: another format, damaged or cut off,
/// over a limit. O(pixels), and the memory of one row besides (four bytes a pixel where a PNG is interlaced).
Outcome<Picture> read_picture(std::string_view bytes, const Limits& limits = {});

struct Options {
    double threshold = 0;  ///< 0..1: ink is darker than this; 0: by Otsu's method
    bool invert = false;   ///< ink is what is not darker
    int despeckle = 2;     ///< specks of up to so many pixels are left out (potrace's turdsize)
    double alphamax = 1;   ///< corners: 0 keeps polygons, from 4/3 on there are none (potrace's)
    double opttolerance =
        0.2;  ///< pixels: curves are joined where that moves them less; 0: never (potrace's)
};

struct Traced {
    svg::Document document;  ///< shapes "region.1", ...: black fill, holes by even-odd
    double threshold = 0;    ///< that was used
    std::size_t holes = 0;
};

/// Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9 (1979): the grey value,
/// 0..1, that parts the histogram into the two classes with most variance between them. Error: the picture is
/// all one grey.
Outcome<double> otsu(const Picture& picture);

/// Selinger, "Potrace: a polygon-based tracing algorithm" (2003). Error: all one colour, all or nothing is
/// ink, only specks, over a million regions. About linear in the pixels.
Outcome<Traced> traced(const Picture& picture, const Options& options, const Progress& progress = {});

}  // namespace strandline::trace
