#include "result/surface/surface.hpp"

#include <algorithm>
#include <cmath>

#include "machine/pins/pins.hpp"

namespace strandline::surface {
namespace {

/// Metres: a longer step between samples is a jump of a broken drive.
constexpr double longest_step = 1.0;
/// Hundredths of a groove's depth: the ridge thrown up between two pins, and what a wheel presses down.
constexpr double groove_depth = 100, ridge_height = 60;
constexpr std::int8_t wheel_depth = -25;
/// Samples between questions whether to stop.
constexpr std::size_t report_every = 2048;

/// Cross section of a groove: a valley under the pin's middle, ridges where it meets its neighbour.
std::int8_t profile(double pitches) {
    const double across = pitches - std::floor(pitches);  // 0 and 1: between two pins
    const double valley = (1 - std::cos(2 * pi * across)) / 2;
    return static_cast<std::int8_t>(ridge_height - (ridge_height + groove_depth) * valley);
}

Point in_field(Pose pose, Point body) {
    const Point forward = unit(pose.heading);
    return pose.at + body.x * forward + body.y * left_normal(forward);
}

/// Calls what(tile, place, i, j) with each cell whose centre lies in the convex polygon.
template <class What>
void for_cells(Surface& surface, std::span<const Point> convex, What what) {
    const CellRun rows = rows_in(surface, convex);
    for (int j = rows.first; j < rows.end; ++j) {
        const CellRun row = row_in(surface, convex, j);
        for (int i = row.first; i < row.end; ++i)
            what(surface.tile_at(i, j), Surface::place_in_tile(i, j), i, j);
    }
}

}  // namespace

double cell_for(const Robot& robot) {
    constexpr double centimetre = 0.01, cells_a_pin = 6;
    return std::min(centimetre, robot.pin_pitch / cells_a_pin);
}

void Surface::mark(std::span<const Point> convex, unsigned bits) {
    for_cells(*this, convex, [&](Tile& tile, std::size_t place, int, int) {
        tile.bits[place] = static_cast<std::uint8_t>(tile.bits[place] | bits);
    });
}
void Surface::mark(const std::vector<RowRun>& runs, unsigned bits) {
    for (const auto& [row, first, end] : runs)
        for (int i = first; i < end; ++i) {
            std::uint8_t& cell = tile_at(i, row).bits[place_in_tile(i, row)];
            cell = static_cast<std::uint8_t>(cell | bits);
        }
}
double Surface::area_of(unsigned mask, unsigned value) const {
    std::size_t cells = 0;
    visit_cells([&](int, int, const Tile& tile, std::size_t place) {
        cells += (tile.bits[place] & mask) == value ? 1 : 0;
    });
    return static_cast<double>(cells) * cell_size() * cell_size();
}

Layer::Layer(const Drive& drive, const Options& options)
    : drive_(drive), options_(options), surface_(options.cell) {}

void Layer::lay_to(std::size_t sample) {
    const std::vector<Sample>& samples = drive_.samples;
    for (; next_ + 1 < samples.size() && next_ < sample; ++next_) {
        const Sample &a = samples[next_], &b = samples[next_ + 1];
        const bool inside = options_.within.empty() ||
                            (contains(options_.within, a.pose.at) && contains(options_.within, b.pose.at));
        if (!inside || distance(a.pose.at, b.pose.at) > longest_step) continue;
        roll(a, b);
        if (a.mask == 0) continue;
        const int element = next_ < drive_.elements.size() ? drive_.elements[next_] : -1;
        rake(a, b,
             element >= 0 && static_cast<std::size_t>(element) < options_.fills.size() &&
                 options_.fills[static_cast<std::size_t>(element)]);
    }
}

void Layer::roll(const Sample& a, const Sample& b) {
    if (a.pose == b.pose) return;
    const float now = static_cast<float>(a.t);
    for (const Wheel& wheel : drive_.robot.wheels) {
        const Point left{wheel.at.x, wheel.at.y + wheel.width / 2};
        const Point right{wheel.at.x, wheel.at.y - wheel.width / 2};
        const Bar track = swept_bar(in_field(a.pose, left), in_field(a.pose, right), in_field(b.pose, left),
                                    in_field(b.pose, right));
        for_cells(surface_, track.outline(), [&](Tile& tile, std::size_t place, int, int) {
            tile.bits[place] = static_cast<std::uint8_t>(tile.bits[place] | rolled);
            tile.touched[place] = now;
            tile.height[place] = wheel_depth;
        });
    }
}

void Layer::rake(const Sample& a, const Sample& b, bool fills) {
    const float now = static_cast<float>(a.t);
    const Robot& robot = drive_.robot;
    const Point left0 = left_normal(unit(a.pose.heading)), left1 = left_normal(unit(b.pose.heading));
    const Point middle = between(a.rake, b.rake, 0.5), across = normalized(left0 + left1);
    const double pitches = 1 / robot.pin_pitch, half = robot.pins / 2.0;
    for (const pins::Comb& comb : pins::combs_of(robot, a.mask)) {
        const Bar swath = swept_bar(a.rake + comb.left * left0, a.rake + comb.right * left0,
                                    b.rake + comb.left * left1, b.rake + comb.right * left1);
        for_cells(surface_, swath.outline(), [&](Tile& tile, std::size_t place, int i, int j) {
            unsigned bits = (tile.bits[place] | raked) & ~static_cast<unsigned>(rolled | filled);
            if (fills) bits |= filled;
            tile.bits[place] = static_cast<std::uint8_t>(bits);
            tile.touched[place] = now;
            tile.height[place] = profile(half + pitches * dot(surface_.centre(i, j) - middle, across));
        });
    }
}

Surface laid(const Drive& drive, const Options& options, const Progress& progress) {
    Layer layer(drive, options);
    const std::size_t all = drive.samples.size();
    for (std::size_t done = 0; done < all && !progress.stopped(); done += report_every) {
        progress.report("sand", static_cast<double>(done) / static_cast<double>(all));
        layer.lay_to(done + report_every);
    }
    return layer.take();
}

double intersection_over_union(const Surface& a, const Surface& b) {
    std::size_t both = 0, of_a = 0, of_b = 0;
    a.visit_cells([&](int i, int j, const Tile& tile, std::size_t place) {
        if ((tile.bits[place] & raked) == 0) return;
        ++of_a;
        both += (b.bits(i, j) & raked) != 0 ? 1 : 0;
    });
    b.visit_cells([&](int, int, const Tile& tile, std::size_t place) {
        of_b += (tile.bits[place] & raked) != 0 ? 1 : 0;
    });
    const std::size_t either = of_a + of_b - both;
    return either == 0 ? 1 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace strandline::surface
