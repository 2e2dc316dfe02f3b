#include "result/shade/shade.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace strandline::shade {
namespace {

using surface::Surface;
using surface::Tile;

/// Colours are averaged over at most so many cells a pixel each way.
constexpr int most_cells = 4;

struct Colour {
    double r = 0, g = 0, b = 0;
};
constexpr Colour dry{226, 205, 165}, damp{164, 134, 93};
constexpr Rgb clean{236, 226, 201}, good{122, 101, 72}, missing{52, 116, 214}, stray{240, 140, 24},
    track{202, 178, 196}, on_line{178, 58, 190}, on_fill{222, 24, 60};

double at_most_one(double x) { return std::clamp(x, 0.0, 1.0); }

/// One grain's brightness, -1 .. 1: a hash of its cell (splitmix64, Steele, Lea and Flood 2014).
double grain(int i, int j) {
    std::uint64_t z =
        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) | static_cast<std::uint32_t>(j);
    z += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

/// Cells of a surface, asked for near to each other: the tile of the last one is remembered.
class Cells {
  public:
    explicit Cells(const Surface& surface) : surface_(surface) {}
    double height(int i, int j) const {
        const Tile* tile = tile_of(i, j);
        return tile == nullptr ? 0.0 : tile->height[Surface::place_in_tile(i, j)] / 100.0;
    }
    unsigned bits(int i, int j) const {
        const Tile* tile = tile_of(i, j);
        return tile == nullptr ? 0U : tile->bits[Surface::place_in_tile(i, j)];
    }

  private:
    const Tile* tile_of(int i, int j) const {
        const int column = i >> Surface::tile_bits, row = j >> Surface::tile_bits;
        if (!known_ || column != column_ || row != row_) {
            latest_ = surface_.find_tile(i, j);
            column_ = column;
            row_ = row;
            known_ = true;
        }
        return latest_;
    }
    const Surface& surface_;
    mutable const Tile* latest_ = nullptr;
    mutable int column_ = 0, row_ = 0;
    mutable bool known_ = false;
};

/// A cell as the eye sees it.
Colour seen(const Cells& cells, int i, int j) {
    // The slope towards the light, which comes from the upper left.
    const double slope =
        (cells.height(i + 1, j) - cells.height(i - 1, j)) - (cells.height(i, j + 1) - cells.height(i, j - 1));
    const double height = cells.height(i, j);
    // Turned sand is damp and darker as a whole, most so in the grooves.
    const double turned = (cells.bits(i, j) & surface::raked) != 0 ? 0.35 : 0;
    const double wet = at_most_one(turned - 0.6 * height);
    const double light = std::clamp(1 + 0.22 * slope + 0.10 * height + 0.045 * grain(i, j), 0.35, 1.35);
    const auto mixed = [&](double a, double b) { return std::min(255.0, (a + wet * (b - a)) * light); };
    return {mixed(dry.r, damp.r), mixed(dry.g, damp.g), mixed(dry.b, damp.b)};
}

Rgb flaw_at(unsigned bits) {
    const bool fill = (bits & surface::wanted_fill) != 0;
    const bool wanted = fill || (bits & surface::wanted_line) != 0;
    const bool raked = (bits & surface::raked) != 0, rolled = (bits & surface::rolled) != 0;
    if (wanted && !raked) return missing;
    if (wanted && rolled) return fill ? on_fill : on_line;
    if (wanted) return good;
    if (raked) return stray;
    return rolled ? track : clean;
}

Rgb rounded(Colour c) {
    const auto byte = [](double x) { return static_cast<std::uint8_t>(std::clamp(x + 0.5, 0.0, 255.0)); };
    return {byte(c.r), byte(c.g), byte(c.b)};
}

/// The mean over the cells under a pixel.
template <class ColourOf>
Rgb pixel(const Surface& surface, const View& view, int column, int row, ColourOf colour_of) {
    const double size = view.metres_a_pixel();
    const int n = std::clamp(static_cast<int>(std::ceil(size / surface.cell_size())), 1, most_cells);
    Colour sum;
    for (int b = 0; b < n; ++b)
        for (int a = 0; a < n; ++a) {
            const double x = view.box.low.x + (column + (a + 0.5) / n) * size;
            const double y = view.box.high.y - (row + (b + 0.5) / n) * size;
            const auto c = colour_of(surface.index(x), surface.index(y));
            sum.r += c.r;
            sum.g += c.g;
            sum.b += c.b;
        }
    const double cells = n * n;
    return rounded({sum.r / cells, sum.g / cells, sum.b / cells});
}

Image blank(const View& view) {
    Image image;
    image.columns = view.columns();
    image.rows = view.rows();
    image.pixels.resize(static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows));
    return image;
}

}  // namespace

double View::metres_a_pixel() const { return std::max(box.width(), box.height()) / pixels; }
int View::columns() const {
    return std::max(1, static_cast<int>(std::lround(box.width() / metres_a_pixel())));
}
int View::rows() const { return std::max(1, static_cast<int>(std::lround(box.height() / metres_a_pixel()))); }
Point View::in_pixels(Point p) const {
    return {(p.x - box.low.x) / metres_a_pixel(), (box.high.y - p.y) / metres_a_pixel()};
}

Image sand(const Surface& surface, const View& view) {
    Image image = blank(view);
    repaint(image, surface, view, view.box);
    return image;
}

void repaint(Image& image, const Surface& surface, const View& view, Box changed) {
    const Point upper_left = view.in_pixels({changed.low.x, changed.high.y});
    const Point lower_right = view.in_pixels({changed.high.x, changed.low.y});
    const auto pixel_of = [](double x, int most) {
        return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(most)));
    };
    const int end_row = pixel_of(lower_right.y + 2, image.rows);
    const int end_column = pixel_of(lower_right.x + 2, image.columns);
    const Cells cells(surface);
    for (int row = pixel_of(upper_left.y - 1, image.rows); row < end_row; ++row)
        for (int column = pixel_of(upper_left.x - 1, image.columns); column < end_column; ++column)
            image.at(column, row) =
                pixel(surface, view, column, row, [&](int i, int j) { return seen(cells, i, j); });
}

std::vector<Key> flaw_keys() {
    return {{good, "as drawn"},     {missing, "not raked"},       {stray, "raked where it should be clean"},
            {track, "wheel track"}, {on_line, "track on a line"}, {on_fill, "track on an area"}};
}

Image flaws(const Surface& surface, const View& view) {
    Image image = blank(view);
    const Cells cells(surface);
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.columns; ++column)
            image.at(column, row) =
                pixel(surface, view, column, row, [&](int i, int j) { return flaw_at(cells.bits(i, j)); });
    return image;
}

void paint(Image& image, const View& view, const std::vector<Point>& convex, Rgb colour) {
    // On a grid of one cell a pixel, y downwards.
    std::vector<Point> corners;
    for (Point p : convex) corners.push_back(view.in_pixels(p));
    const Grid grid(1);
    const CellRun rows = rows_in(grid, corners);
    for (int row = std::max(0, rows.first); row < std::min(rows.end, image.rows); ++row) {
        const CellRun run = row_in(grid, corners, row);
        for (int column = std::max(0, run.first); column < std::min(run.end, image.columns); ++column)
            image.at(column, row) = colour;
    }
}

}  // namespace strandline::shade
