// The area as a coarse raster.
#include "path/fill/lattice.hpp"

#include <algorithm>
#include <queue>

#include "math/raster/raster.hpp"

namespace strandline::fill {
namespace {

constexpr int cells_a_width = 4, coarse_cells = 2;
constexpr double most_cells = 3e7;     // some 300 MB
constexpr double owned_within = 0.75;  // of the width: past half of it lie the gaps between rings
constexpr int least_contact = 3;       // cell edges: less is a touch of two corners
constexpr float raked_price = 15, edge_price = 3,
                outer_price = 60;  // ways over a cell, as multiples of a free one

int column(const Lattice& l, double x) {
    return std::clamp(static_cast<int>((x - l.origin.x) / l.cell), 0, l.columns - 1);
}
int row(const Lattice& l, double y) {
    return std::clamp(static_cast<int>((y - l.origin.y) / l.cell), 0, l.rows - 1);
}
int index(const Lattice& l, Point p) { return row(l, p.y) * l.columns + column(l, p.x); }
Point centre(const Lattice& l, int i) {
    return {l.origin.x + (i % l.columns + 0.5) * l.cell, l.origin.y + (i / l.columns + 0.5) * l.cell};
}

/// Calls visit(cell, squared distance) for the cells whose centres are within `reach` of the segment.
template <class Visit>
void near_segment(const Lattice& l, Point a, Point b, double reach, Visit visit) {
    const int from = row(l, std::min(a.y, b.y) - reach), to = row(l, std::max(a.y, b.y) + reach);
    const Point u = b - a;
    const double uu = dot(u, u);
    for (int j = from; j <= to; ++j) {
        const double y = l.origin.y + (j + 0.5) * l.cell;
        // The part of the segment within reach of this row bounds the columns.
        double low = 0, high = 1;
        if (std::abs(u.y) > 1e-12 * l.cell) {
            const double s = (y - reach - a.y) / u.y, t = (y + reach - a.y) / u.y;
            low = std::clamp(std::min(s, t), 0.0, 1.0);
            high = std::clamp(std::max(s, t), 0.0, 1.0);
        }
        const double x0 = a.x + low * u.x, x1 = a.x + high * u.x;
        const int first = column(l, std::min(x0, x1) - reach), last = column(l, std::max(x0, x1) + reach);
        for (int i = first; i <= last; ++i) {
            const Point v{l.origin.x + (i + 0.5) * l.cell - a.x, y - a.y};
            const double t = uu > 0 ? std::clamp(dot(v, u) / uu, 0.0, 1.0) : 0;
            const Point d = v - t * u;
            if (const double dd = dot(d, d); dd < reach * reach) visit(j * l.columns + i, dd);
        }
    }
}

float price(const Lattice& l, int cell) {
    const auto c = static_cast<std::size_t>(cell);
    return !l.inside[c] ? outer_price : l.raked[c] == 2 ? raked_price : l.raked[c] == 1 ? edge_price : 1;
}

/// What a straight way costs, cell by cell.
float straight_cost(const Lattice& l, Point a, Point b) {
    const double d = distance(a, b);
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * d / l.cell)));
    float cost = 0;
    for (int k = 0; k < steps; ++k) cost += price(l, index(l, between(a, b, (k + 0.5) / steps)));
    return cost * static_cast<float>(d / steps / l.cell);
}

}  // namespace

Lattice lattice_of(const Region& region, const std::vector<Ring>& rings, const std::string& place,
                   const Options& options, Fill& account) {
    const Box box = bounds(region);
    Lattice l;
    const double widths = box.width() * box.height() / (options.width * options.width);
    l.cell = options.width / (widths > largest_fine ? coarse_cells : cells_a_width);
    if (widths * coarse_cells * coarse_cells > most_cells) {
        account.warnings.push_back(
            {place,
             "is so large for so narrow a rake that ways between its rings are straight "
             "and may cross raked sand; a smaller canvas or a wider rake avoids that"});
        return {};
    }
    l.origin = box.low - Point{l.cell, l.cell};
    l.columns = static_cast<int>(box.width() / l.cell) + 3;
    l.rows = static_cast<int>(box.height() / l.cell) + 3;
    const auto cells = static_cast<std::size_t>(l.columns) * static_cast<std::size_t>(l.rows);
    l.inside.assign(cells, 0);
    l.raked.assign(cells, 0);
    l.owner.assign(cells, -1);
    const Raster raster{l.origin, l.cell, l.columns, l.rows};
    for (const Run& run : runs_inside(raster, {region}))
        std::fill(l.inside.begin() + static_cast<std::ptrdiff_t>(raster.index(run.first, run.row)),
                  l.inside.begin() + static_cast<std::ptrdiff_t>(raster.index(run.end, run.row)), 1);
    std::vector<float> nearest_yet(cells, std::numeric_limits<float>::infinity());
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const auto own = [&](Point a, Point b) {
            near_segment(l, a, b, owned_within * options.width, [&](int cell, double dd) {
                const auto c = static_cast<std::size_t>(cell);
                if (l.inside[c] && static_cast<float>(dd) < nearest_yet[c]) {
                    nearest_yet[c] = static_cast<float>(dd);
                    l.owner[c] = static_cast<int>(r);
                }
            });
        };
        const Polyline& line = rings[r].line;
        for (const Polyline& tooth : rings[r].teeth) own(tooth.front(), tooth.back());
        if (!rings[r].teeth.empty()) continue;
        for (std::size_t i = rings[r].closed ? 0 : 1, j = rings[r].closed ? line.size() - 1 : 0;
             i < line.size(); j = i++)
            own(line[j], line[i]);
    }
    return l;
}

std::vector<Contact> contacts(const Lattice& l) {
    std::vector<std::pair<int, int>> pairs;
    const auto meet = [&](int a, int b) {
        if (a >= 0 && b >= 0 && a != b) pairs.push_back(std::minmax(a, b));
    };
    for (int r = 0; r < l.rows; ++r)
        for (int c = 0; c < l.columns; ++c) {
            const int here = l.owner[static_cast<std::size_t>(r * l.columns + c)];
            if (c + 1 < l.columns) meet(here, l.owner[static_cast<std::size_t>(r * l.columns + c + 1)]);
            if (r + 1 < l.rows) meet(here, l.owner[static_cast<std::size_t>((r + 1) * l.columns + c)]);
        }
    std::ranges::sort(pairs);
    std::vector<Contact> found;
    for (std::size_t i = 0, j = 0; i < pairs.size(); i = j) {
        while (j < pairs.size() && pairs[j] == pairs[i]) ++j;
        if (j - i >= least_contact)
            found.push_back({pairs[i].first, pairs[i].second, static_cast<int>(j - i)});
    }
    return found;
}

void rake(Lattice& l, const Polyline& line, const Options& options) {
    if (l.inside.empty()) return;
    const double half = options.width / 2;
    // Where pins lift, sand that is raked in part is as good as bare.
    const double reach = options.masked ? half : half + l.cell / 2;
    for (std::size_t i = 1; i < line.size(); ++i)
        near_segment(l, line[i - 1], line[i], reach, [&](int cell, double dd) {
            char& raked = l.raked[static_cast<std::size_t>(cell)];
            raked = std::max<char>(raked, dd < half * half ? 2 : 1);
        });
}

bool is_raked(const Lattice& l, Point p) {
    return !l.raked.empty() && l.raked[static_cast<std::size_t>(index(l, p))] == 2;
}

bool is_free(const Lattice& l, Point p) { return l.raked.empty() || price(l, index(l, p)) < raked_price; }

Polyline way(const Lattice& l, Point from, Point to) {
    if (l.inside.empty()) return {};
    const double straight = distance(from, to);
    if (straight_cost(l, from, to) <= 1.001 * straight / l.cell) return {};
    const int start = index(l, from), goal = index(l, to);
    std::vector<float> cost(l.owner.size(), std::numeric_limits<float>::infinity());
    std::vector<int> came(l.owner.size(), -1);
    const auto left = [&](int cell) {
        return static_cast<float>(distance(centre(l, cell), centre(l, goal)) / l.cell);
    };
    using Open = std::pair<float, int>;  // estimate, cell
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    cost[static_cast<std::size_t>(start)] = 0;
    open.emplace(left(start), start);
    std::vector<char> done(l.owner.size(), 0);
    while (!open.empty()) {
        const int here = open.top().second;
        open.pop();
        if (done[static_cast<std::size_t>(here)]) continue;
        done[static_cast<std::size_t>(here)] = 1;
        if (here == goal) break;
        const int c = here % l.columns, r = here / l.columns;
        for (int dr = -1; dr <= 1; ++dr)
            for (int dc = -1; dc <= 1; ++dc) {
                if ((dr == 0 && dc == 0) || c + dc < 0 || c + dc >= l.columns || r + dr < 0 ||
                    r + dr >= l.rows)
                    continue;
                const int next = here + dr * l.columns + dc;
                const float step = dr != 0 && dc != 0 ? std::numbers::sqrt2_v<float> : 1.0F;
                const float total =
                    cost[static_cast<std::size_t>(here)] + step * (price(l, here) + price(l, next)) / 2;
                if (total < cost[static_cast<std::size_t>(next)]) {
                    cost[static_cast<std::size_t>(next)] = total;
                    came[static_cast<std::size_t>(next)] = here;
                    open.emplace(total + left(next), next);
                }
            }
    }
    Polyline cells{to};
    for (int at = came[static_cast<std::size_t>(goal)]; at >= 0 && at != start;
         at = came[static_cast<std::size_t>(at)])
        cells.push_back(centre(l, at));
    cells.push_back(from);
    std::ranges::reverse(cells);
    // Pulled tight: as far on as a straight way is no dearer than the cells.
    std::vector<float> sum{0};
    for (std::size_t i = 1; i < cells.size(); ++i)
        sum.push_back(sum.back() + straight_cost(l, cells[i - 1], cells[i]));
    Polyline tight;
    for (std::size_t i = 0; i + 1 < cells.size();) {
        std::size_t next = i + 1;
        for (std::size_t reach = 2; i + reach < cells.size() + reach / 2; reach *= 2) {
            const std::size_t j = std::min(i + reach, cells.size() - 1);
            if (straight_cost(l, cells[i], cells[j]) <= 1.001F * (sum[j] - sum[i])) next = j;
            if (j + 1 == cells.size()) break;
        }
        i = next;
        if (i + 1 < cells.size()) tight.push_back(cells[i]);
    }
    return tight;
}

}  // namespace strandline::fill
