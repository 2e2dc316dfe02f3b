// The account of a fill: its moves painted on a raster in their order.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "math/raster/raster.hpp"
#include "path/rake/gaps.hpp"
#include "path/rake/track.hpp"

namespace strandline::rake {
namespace {

// In widths. A new pass is more than this much travel after the last one, so that the inside of a corner is
// none; sand is finished, for a path that enters it, after a little more: a step to the next ring is half
// one.
constexpr double pass_lag = 1.0, finished_lag = 1.5, least_stay = 0.75;
constexpr Point off_centres{3e-3, 5e-3};  // cells
constexpr double same_place = 1e-3, crisp = 0.1, outline_step = 0.1;
constexpr float never = -std::numeric_limits<float>::infinity();

struct Painted {
    std::vector<float> first, last;  // arc length in cells at which a cell was raked
    std::vector<std::uint8_t> passes;
    explicit Painted(std::size_t cells) : first(cells), last(cells, never), passes(cells, 0) {}
};

/// `s`: arc length at the first cell, `slope`: how it grows from cell to cell.
void paint(Painted& sand, std::size_t begin, std::size_t end, float s, float slope, float lag) {
    for (std::size_t i = begin; i < end; ++i, s += slope) {
        const float last = sand.last[i];
        if (last < s - lag) {
            if (sand.passes[i] == 0) sand.first[i] = s;
            if (sand.passes[i] < std::numeric_limits<std::uint8_t>::max()) ++sand.passes[i];
        }
        if (last < s) sand.last[i] = s;
    }
}

/// All moves onto the sand; gives back the raked length x share of the pins down, in metres.
double rake(Painted& sand, const Raster& raster, const std::vector<Move>& moves,
            const AccountOptions& options) {
    const auto lag = static_cast<float>(pass_lag * options.width / raster.cell);
    double arc = 0, raked = 0;
    std::optional<Point> before;  // the way ahead on the last chord, rake down
    for (const Move& move : moves) {
        const std::vector<Bar> bars = bars_of(move.mask, options.pins, options.width);
        double share = 0;
        for (const Bar& bar : bars) share += (bar.left + bar.right) / options.width;
        if (move.mask == 0) before = {};
        for (std::size_t i = 1; i < move.line.size(); ++i) {
            const Point from = raster.in_cells(move.line[i - 1]);
            const Point chord = raster.in_cells(move.line[i]) - from;
            const double long_ = length(chord);
            if (!(long_ > 0)) continue;
            const Point ahead = 1 / long_ * chord;
            const auto straight = [&](const Run& run) {
                const double along =
                    dot(Point{static_cast<double>(run.first), static_cast<double>(run.row)} - from, ahead);
                paint(sand, raster.index(run.first, run.row), raster.index(run.end, run.row),
                      static_cast<float>(arc + along), static_cast<float>(ahead.x), lag);
            };
            const auto turned = [&](const Run& run) {
                paint(sand, raster.index(run.first, run.row), raster.index(run.end, run.row),
                      static_cast<float>(arc), 0, lag);
            };
            for (const Bar& bar : bars) {
                const double left = bar.left / raster.cell, right = bar.right / raster.cell;
                if (before && turns(*before, ahead)) {
                    const Wedge wedge = wedge_of(from, *before, ahead, left, right);
                    if (wedge.outer > wedge.inner) for_runs_in(raster, wedge, turned);
                }
                for_runs_in(raster, Swath{from, ahead, long_, left, right}, straight);
            }
            if (move.mask != 0) before = ahead;
            raked += long_ * share * raster.cell;
            arc += long_;
        }
    }
    return raked;
}

void count_lifts(Account& account, const std::vector<Move>& moves, double width) {
    double up = 0;
    for (const Move& move : moves) {
        if (move.mask == 0) {
            up += length(move.line);
            continue;
        }
        if (up > same_place * width) {
            account.hops_length += up;
            ++(up > (1 + same_place) * width ? account.hops : account.pivots);
        }
        up = 0;
    }
}

void count_drives_over(Account& account, const Painted& sand, const Raster& raster,
                       const std::vector<Move>& moves, double width) {
    const double lag = finished_lag * width / raster.cell;
    double arc = 0, entered = 0, latest = 0;
    bool over = false;
    const auto leave = [&](double s) {
        if (over && (s - entered) * raster.cell > least_stay * width) ++account.drives_over;
        over = false;
    };
    for (const Move& move : moves)
        for (std::size_t i = 1; i < move.line.size(); ++i) {
            const Point from = raster.in_cells(move.line[i - 1]), to = raster.in_cells(move.line[i]);
            const double long_ = distance(from, to);
            const double steps = std::max(1.0, std::ceil(long_));
            for (double k = 0.5; k < steps; ++k) {
                const Point p = between(from, to, k / steps);
                const double s = arc + long_ * k / steps;
                const int column = ceiled(p.x - 0.5, raster.columns), row = ceiled(p.y - 0.5, raster.rows);
                bool finished = false;
                if (column < raster.columns && row < raster.rows) {
                    const std::size_t cell = raster.index(column, row);
                    finished = sand.passes[cell] > 0 && static_cast<double>(sand.first[cell]) < s - lag;
                }
                if (finished) {
                    account.driven_over += (s - latest) * raster.cell;
                    if (!over) entered = s;
                    over = true;
                } else {
                    leave(s);
                }
                latest = s;
            }
            arc += long_;
        }
    leave(latest);
}

double crisp_edge(const Regions& regions, const Painted& sand, const Raster& raster, double width) {
    // Within reach of the place there are both raked and bare cells.
    const double reach = crisp * width / raster.cell + 0.2;
    const auto raked = [&](Point p) {
        const int column = ceiled(p.x - 0.5, raster.columns), row = ceiled(p.y - 0.5, raster.rows);
        return column < raster.columns && row < raster.rows && sand.passes[raster.index(column, row)] > 0;
    };
    constexpr int looks = 16;
    std::array<Point, looks> around;
    for (int k = 0; k < looks; ++k) around[static_cast<std::size_t>(k)] = reach * unit(2 * pi * k / looks);
    double good = 0, all = 0;
    const auto walk = [&](const Polygon& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            const double steps = std::max(1.0, std::ceil(distance(a, b) / (outline_step * width)));
            const double step = distance(a, b) / steps;
            for (double k = 0.5; k < steps; ++k) {
                const Point p = raster.in_cells(between(a, b, k / steps));
                const bool here = raked(p);
                const bool edge = std::ranges::any_of(around, [&](Point d) { return raked(p + d) != here; });
                all += step;
                if (edge) good += step;
            }
        }
    };
    for (const Region& region : regions) {
        walk(region.outer);
        for (const Polygon& hole : region.holes) walk(hole);
    }
    return all > 0 ? good / all : 0;
}

double distance_to_outlines(const Regions& regions, Point p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Region& region : regions) {
        nearest = std::min(nearest, distance_to_outline(region.outer, p));
        for (const Polygon& hole : region.holes) nearest = std::min(nearest, distance_to_outline(hole, p));
    }
    return nearest;
}

}  // namespace

Account account_of(const Regions& regions, const std::vector<Move>& moves, const AccountOptions& options) {
    Account account;
    account.area = area(regions);
    if (!(account.area > 0)) return account;
    Box box = bounds(regions);
    for (const Move& move : moves)
        if (move.mask != 0) box = united(box, grown(bounds(move.line), options.width / 2));
    // A little off, so that edges a whole number of cells apart do not lie on centres: where the rake's edge
    // is the outline, a centre is on the same side of both.
    const double cell = options.width * options.cell_share;
    box = grown(box, options.width);
    box.low = box.low - cell * off_centres;
    const Raster raster = raster_over(box, cell);
    account.cell = raster.cell;

    Painted sand(raster.size());
    account.ratio = rake(sand, raster, moves, options) * options.width / account.area;
    const std::vector<Run> inside = runs_inside(raster, regions);
    double covered = 0, bare = 0, raked = 0, again = 0;
    for (const std::uint8_t passes : sand.passes) {
        raked += passes > 0 ? 1 : 0;
        again += passes > 1 ? passes - 1 : 0;
    }
    for (const Run& run : inside)
        for (std::size_t i = raster.index(run.first, run.row); i < raster.index(run.end, run.row); ++i)
            ++(sand.passes[i] > 0 ? covered : bare);
    const double cell_area = raster.cell * raster.cell;
    account.coverage = std::max(0.0, 1 - bare * cell_area / account.area);
    account.overdraw = again * cell_area / account.area;
    account.spill = (raked - covered) * cell_area / account.area;
    if (!options.details) return account;
    count_lifts(account, moves, options.width);
    count_drives_over(account, sand, raster, moves, options.width);
    if (!moves.empty())
        account.end_off_border = distance_to_outlines(regions, moves.back().line.back()) - options.width / 2;
    if (raked > covered) account.spill_reach = raster.cell * farthest_outside(raster, inside, sand.passes);
    account.crisp_edge = crisp_edge(regions, sand, raster, options.width);
    account.gaps = gaps_of(raster, inside, sand.passes, options.least_gap * options.width);
    return account;
}

Account joined(Account a, const Account& b) {
    if (!(b.area > 0)) return a;
    if (!(a.area > 0)) return b;
    const double whole = a.area + b.area;
    const auto mean = [&](double& x, double y) { x = (x * a.area + y * b.area) / whole; };
    mean(a.coverage, b.coverage);
    mean(a.overdraw, b.overdraw);
    mean(a.spill, b.spill);
    mean(a.ratio, b.ratio);
    mean(a.crisp_edge, b.crisp_edge);
    a.spill_reach = std::max(a.spill_reach, b.spill_reach);
    a.hops += b.hops;
    a.pivots += b.pivots;
    a.hops_length += b.hops_length;
    a.drives_over += b.drives_over;
    a.driven_over += b.driven_over;
    a.end_off_border = std::max(a.end_off_border, b.end_off_border);
    a.gaps.insert(a.gaps.end(), b.gaps.begin(), b.gaps.end());
    std::ranges::stable_sort(a.gaps, std::greater{}, &Gap::area);
    a.cell = std::max(a.cell, b.cell);
    a.area = whole;
    return a;
}

}  // namespace strandline::rake
