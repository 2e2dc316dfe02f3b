// The simulated sand as a picture, and the picture of its flaws with a key.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "result/picture/page.hpp"
#include "result/picture/picture.hpp"

namespace strandline::picture {
namespace {

constexpr int least_pixels = 64, most_pixels = 16'000;

Outcome<void> drawable(const shade::View& view) {
    if (view.pixels < least_pixels || view.pixels > most_pixels)
        return fail("picture", fmt::format("{} pixels are out of range", view.pixels),
                    fmt::format("use {} to {}", least_pixels, most_pixels));
    const double longer = std::max(view.box.width(), view.box.height());
    if (!(longer > 0) || !std::isfinite(longer))
        return fail("picture", "the canvas has no extent, or too much", "check its size");
    return {};
}

/// The image at the upper left of the page.
void put(const Page& page, const shade::Image& image) {
    unsigned char* bytes = page.bytes();
    if (bytes == nullptr) return;  // png() says what is wrong with the page
    for (int row = 0; row < image.rows; ++row) {
        unsigned char* to = bytes + static_cast<std::ptrdiff_t>(row) * page.stride();
        for (int column = 0; column < image.columns; ++column, to += 4) {
            const shade::Rgb& c = image.at(column, row);
            to[0] = c.b;
            to[1] = c.g;
            to[2] = c.r;
            to[3] = 255;
        }
    }
    page.changed();
}

}  // namespace

Outcome<std::string> image_png(const shade::Image& image) {
    const Page page(image.columns, image.rows);
    put(page, image);
    return page.png();
}

Outcome<std::string> sand_png(const surface::Surface& surface, const shade::View& view) {
    if (const auto fits = drawable(view); !fits) return tl::unexpected(fits.error());
    return image_png(shade::sand(surface, view));
}

Outcome<std::string> flaws_png(const surface::Surface& surface, const shade::View& view) {
    if (const auto fits = drawable(view); !fits) return tl::unexpected(fits.error());
    const double letter = std::max(8.0, view.columns() / 60.0);
    const int key_height = static_cast<int>(std::ceil(4.2 * letter));
    const Page page(view.columns(), view.rows() + key_height);
    cairo_t* cr = page.cairo();
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    put(page, shade::flaws(surface, view));
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, letter);
    const std::vector<shade::Key> keys = shade::flaw_keys();
    constexpr int columns = 3;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const double x = letter + static_cast<double>(k % columns) * (view.columns() - letter) / columns;
        const double y = view.rows() + letter * (1.7 + 1.7 * static_cast<double>(k / columns));
        const shade::Rgb c = keys[k].colour;
        cairo_rectangle(cr, x, y - 0.9 * letter, 1.5 * letter, letter);
        cairo_set_source_rgb(cr, c.r / 255.0, c.g / 255.0, c.b / 255.0);
        cairo_fill(cr);
        cairo_set_source_rgb(cr, 0.17, 0.14, 0.09);
        cairo_move_to(cr, x + 2 * letter, y);
        cairo_show_text(cr, keys[k].meaning.c_str());
    }
    return page.png();
}

}  // namespace strandline::picture
