#pragma once
// The sand as a drive leaves it: every pin's groove and every wheel's track laid in time order on a tiled
// raster, later over earlier, the rake erasing what it covers. Six bytes a cell.
#include <array>
#include <cstdint>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/follow/follow.hpp"
#include "machine/ground/ground.hpp"
#include "machine/robot/robot.hpp"

namespace strandline::surface {

/// What a cell is, as bits. Raked sand that was rolled over later keeps `raked` and has `rolled` too.
enum Bit : std::uint8_t {
    raked = 1,         ///< a pin went through
    filled = 2,        ///< the last pin was a fill's
    rolled = 4,        ///< a wheel was there after every pin
    wanted_fill = 8,   ///< the drawing has an area here; set by who compares, not by a drive
    wanted_line = 16,  ///< ... or a line's groove
    border = 32        ///< near an area's outline
};
struct Tile {
    static constexpr std::size_t cells = 64 * 64;
    static constexpr float never = -1;
    Tile() { touched.fill(never); }
    std::array<float, cells> touched;  ///< s, by a pin or a wheel
    std::array<std::uint8_t, cells> bits{};
    std::array<std::int8_t, cells> height{};  ///< of the sand, hundredths of the groove's depth; 0: as it lay
};
class Surface : public Tiled<Tile> {
  public:
    using Tiled::Tiled;
    /// 0 where nothing was touched.
    unsigned bits(int i, int j) const {
        const Tile* tile = find_tile(i, j);
        return tile == nullptr ? 0U : tile->bits[place_in_tile(i, j)];
    }
    unsigned bits(Point p) const { return bits(index(p.x), index(p.y)); }
    /// Sets bits of the cells whose centres lie in a convex polygon.
    void mark(std::span<const Point> convex, unsigned bits);
    void mark(const std::vector<RowRun>& runs, unsigned bits);
    /// Square metres of the cells whose bits under `mask` are `value`.
    double area_of(unsigned mask, unsigned value) const;
};

/// What went on: samples with what each of their strokes is.
struct Drive {
    Robot robot;
    std::vector<Sample> samples;
    std::vector<int> elements;  ///< of each sample: what is drawn from it to the next, -1: nothing known
};

struct Options {
    double cell = 0.01;            ///< metres
    Box within = {};               ///< nothing is laid outside; empty: no bound
    std::vector<bool> fills = {};  ///< by element: it is an area. Others are lines
};
/// One centimetre, or a sixth of a pin where that is less, so that grooves have a shape.
double cell_for(const Robot& robot);

/// Lays drives one after the other, and parts of them: what was laid stays. Between two samples the wheels
/// roll first, then the rake, which trails them, lays its grooves: each run of lowered pins is a bar across
/// the robot's heading, and the hull of its two positions is raked. Steps over a metre are jumps and are not
/// laid. O(driven length x width / cell^2).
class Layer {
  public:
    Layer(const Drive& drive, const Options& options);
    /// Up to the sample of that number; at most all.
    void lay_to(std::size_t sample);
    const Surface& surface() const { return surface_; }
    Surface take() { return std::move(surface_); }

  private:
    void roll(const Sample& a, const Sample& b);
    void rake(const Sample& a, const Sample& b, bool fills);
    const Drive& drive_;
    Options options_;
    Surface surface_;
    std::size_t next_ = 0;
};
Surface laid(const Drive& drive, const Options& options, const Progress& progress = {});

/// How alike two drives leave the sand: raked cells of both over raked cells of either; 1 where neither
/// rakes.
double intersection_over_union(const Surface& a, const Surface& b);

}  // namespace strandline::surface
