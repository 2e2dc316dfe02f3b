#pragma once
// The final sand as colours: as a person sees it from above with the sun in the upper left, and with each
// flaw in a colour of its own. Pixels only; files are the picture room's and the film room's.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "result/surface/surface.hpp"

namespace strandline::shade {

struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb&) const = default;
};
/// Row by row from the upper left.
struct Image {
    int columns = 0, rows = 0;
    std::vector<Rgb> pixels;
    Rgb& at(int column, int row) { return pixels[index(column, row)]; }
    const Rgb& at(int column, int row) const { return pixels[index(column, row)]; }

  private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// What an image shows: metres, and pixels along the longer side.
struct View {
    Box box;
    int pixels = 1200;
    double metres_a_pixel() const;
    int columns() const;
    int rows() const;
    /// In pixels from the upper left.
    Point in_pixels(Point p) const;
};

/// Light on slopes, damp sand in grooves, grains (always the same ones). O(pixels x cells a pixel, at most
/// 16).
Image sand(const surface::Surface& surface, const View& view);
/// Only what `changed` holds is painted anew.
void repaint(Image& image, const surface::Surface& surface, const View& view, Box changed);

/// A colour of the picture of flaws and what it means.
struct Key {
    Rgb colour;
    std::string meaning;
};
std::vector<Key> flaw_keys();
/// Needs what was wanted marked on the surface (fidelity::judged).
Image flaws(const surface::Surface& surface, const View& view);

/// Fills a convex polygon, metres.
void paint(Image& image, const View& view, const std::vector<Point>& convex, Rgb colour);

}  // namespace strandline::shade
