// The obstacles' edges in square cells, each with its distance from them: the room round a point is read off
// its cell where it is far from all, and measured where it is near.
#include <algorithm>
#include <cmath>
#include <limits>

#include "path/route/route.hpp"

namespace strandline::route {
namespace {

constexpr double cell_size = 0.125;
/// Distances are known up to the clearance and this.
constexpr double far_reach = 0.5;
/// Points nearer to an edge than the clearance and this have it measured.
constexpr double near_reach = 0.06;
/// Outlines are thinned by this for checking, and kept that much farther from.
constexpr double outline_tolerance = 0.001;
/// Curves keep this much more than the clearance, so that proofs end: steps are at least as long.
constexpr double margin = 0.001;
/// Strings are drawn this much farther out than that, so that steps along them are longer.
constexpr double string_margin = 0.006;
/// Blemishes are measured by steps of this.
constexpr double blemish_step = 0.01;
/// Those of straight parts of strings, which are only weighed against each other, by longer ones.
constexpr double weighed_step = 0.05;
/// A corner turns by more than this, radians.
constexpr double least_corner = 0.001;

const double half_diagonal = cell_size / std::numbers::sqrt2;

Polygon without_area_on_right(Polygon ring, bool obstacle_inside) {
    if ((signed_area(ring) > 0) != obstacle_inside) std::ranges::reverse(ring);
    return ring;
}

/// The corners of an outline that has the obstacle on its left.
void append_corners(std::vector<Corner>& corners, const Polygon& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point in = normalized(ring[i] - ring[(i + n - 1) % n]);
        const Point out = normalized(ring[(i + 1) % n] - ring[i]);
        if (std::atan2(cross(in, out), dot(in, out)) > least_corner)
            corners.push_back({ring[i], -left_normal(in), -left_normal(out)});
    }
}

}  // namespace

Ground::Ground(GroundOptions options) : options_(options) {}

double Ground::reach() const { return options_.clearance + far_reach; }
double Ground::exact_within() const { return options_.clearance + near_reach; }
double Ground::string_offset() const {
    return options_.clearance + options_.detail + outline_tolerance + margin + string_margin;
}

std::size_t Ground::cell_of(Point p) const {
    const auto column = static_cast<std::size_t>((p.x - box_.low.x) / cell_size);
    const auto row = static_cast<std::size_t>((p.y - box_.low.y) / cell_size);
    return std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1);
}

void Ground::grow_to(Box box) {
    if (!cells_.empty() && contains(box_, box.low) && contains(box_, box.high)) return;
    // half as much again on each side: so that growing is rare
    const Box whole = united(box_, box);
    const double spare = std::max(whole.width(), whole.height()) / 2;
    Box next = cells_.empty() ? box : grown(whole, spare);
    // whole cells from the old ones' corner
    const Point anchor = cells_.empty() ? box.low : box_.low;
    const auto snapped = [](double x, double from) {
        return from + std::floor((x - from) / cell_size) * cell_size;
    };
    next.low = {snapped(next.low.x, anchor.x), snapped(next.low.y, anchor.y)};
    const auto columns = static_cast<std::size_t>(next.width() / cell_size) + 1;
    const auto rows = static_cast<std::size_t>(next.height() / cell_size) + 1;
    std::vector<Cell> cells(columns * rows, Cell{reach(), {}});
    const auto left = static_cast<std::size_t>(std::lround((anchor.x - next.low.x) / cell_size));
    const auto below = static_cast<std::size_t>(std::lround((anchor.y - next.low.y) / cell_size));
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column)
            cells[(row + below) * columns + column + left] = std::move(cells_[row * columns_ + column]);
    next.high = next.low + cell_size * Point{static_cast<double>(columns), static_cast<double>(rows)};
    box_ = next;
    columns_ = columns;
    rows_ = rows;
    cells_ = std::move(cells);
}

void Ground::add_ring(const Polygon& ring) {
    const double listed = exact_within() + half_diagonal;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Edge edge{ring[j], ring[i]};
        const int number = static_cast<int>(edges_.size());
        edges_.push_back(edge);
        const Box near = grown(including(including(Box{}, edge.a), edge.b), reach());
        const std::size_t first = cell_of(near.low), last = cell_of(near.high);
        for (std::size_t row = first / columns_; row <= last / columns_; ++row)
            for (std::size_t column = first % columns_; column <= last % columns_; ++column) {
                const Point middle = box_.low + cell_size * Point{static_cast<double>(column) + 0.5,
                                                                  static_cast<double>(row) + 0.5};
                Cell& cell = cells_[row * columns_ + column];
                const double d = distance_to_segment(middle, edge.a, edge.b);
                cell.distance = std::min(cell.distance, d);
                if (d < listed) cell.edges.push_back(number);
            }
    }
}

void Ground::add(const Region& obstacle) {
    grow_to(grown(strandline::bounds(obstacle), reach() + cell_size));
    const auto take = [&](const Polygon& ring, bool inside) {
        const Polygon turned = without_area_on_right(ring, inside);
        add_ring(thinned_outline(turned, outline_tolerance));
        append_corners(corners_, thinned_outline(turned, options_.detail));
    };
    take(obstacle.outer, true);
    for (const Polygon& hole : obstacle.holes) take(hole, false);
    obstacles_.push_back(obstacle);
    boxes_.push_back(strandline::bounds(obstacle));
    added_.push_back(grown(boxes_.back(), string_offset()));
}

void Ground::add(const Regions& obstacles) {
    for (const Region& obstacle : obstacles) add(obstacle);
}

void Ground::add_field(const Region& field) {
    grow_to(grown(strandline::bounds(field), reach() + cell_size));
    const auto take = [&](const Polygon& ring, bool inside) {
        const Polygon turned = without_area_on_right(ring, inside);
        add_ring(thinned_outline(turned, outline_tolerance));
        append_corners(corners_, thinned_outline(turned, options_.detail));
    };
    take(field.outer, false);
    for (const Polygon& hole : field.holes) take(hole, true);
    fields_.push_back(field);
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    added_.push_back({{-everywhere, -everywhere}, {everywhere, everywhere}});
}

bool Ground::forbidden(Point p) const {
    for (std::size_t i = 0; i < obstacles_.size(); ++i)
        if (contains(boxes_[i], p) && contains(obstacles_[i], p)) return true;
    return std::ranges::any_of(fields_, [&](const Region& r) { return !contains(r, p); });
}

/// At most the distance to the nearest edge, less what is to be kept; that exactly where it is small.
double Ground::room_at(Point p) const {
    const double kept = options_.clearance + outline_tolerance;
    if (cells_.empty() || !contains(box_, p)) return reach() - kept;
    const std::size_t at = cell_of(p);
    const Cell& cell = cells_[at];
    const Point middle = box_.low + cell_size * Point{static_cast<double>(at % columns_) + 0.5,
                                                      static_cast<double>(at / columns_) + 0.5};
    const double by_cell = cell.distance - distance(middle, p);
    if (by_cell >= exact_within()) return by_cell - kept;
    double least = exact_within();
    for (const int number : cell.edges) {
        const Edge& edge = edges_[static_cast<std::size_t>(number)];
        least = std::min(least, distance_to_segment(p, edge.a, edge.b));
    }
    return least - kept;
}

bool Ground::clear(Point p) const { return room_at(p) >= margin && !forbidden(p); }

/// Once the start is allowed, the rest is: nothing forbidden is reached without coming near an edge.
template <class At>
double Ground::traced_length(double length, At&& at) const {
    for (double s = 0;;) {
        const double room = room_at(at(s));
        if (room < margin) return s;
        if (s >= length) return length;
        s = std::min(s + room, length);
    }
}

template <class At>
double Ground::traced_blemish(double length, double least_step, At&& at) const {
    double sum = 0;
    bool inside = forbidden(at(0)), near = false;
    for (double s = 0; s < length;) {
        const Point p = at(s);
        const double room = room_at(p);
        if (room >= margin && near) inside = forbidden(p);  // an edge may have been crossed
        near = room < margin;
        const double step = std::min(std::max(room, least_step), length - s);
        if (near || inside) sum += step;
        s += step;
    }
    return sum;
}

namespace {

/// Positions along a curve at growing arc lengths.
struct Along {
    const Curve& curve;
    Pose start = curve.start;
    std::size_t piece = 0;
    double before = 0;
    Point operator()(double s) {
        while (piece + 1 < curve.pieces.size() && s - before > curve.pieces[piece].length) {
            start = advanced(start, curve.pieces[piece], curve.pieces[piece].length);
            before += curve.pieces[piece++].length;
        }
        if (curve.pieces.empty()) return start.at;
        return advanced(start, curve.pieces[piece], std::min(s - before, curve.pieces[piece].length)).at;
    }
};

}  // namespace

bool Ground::clear(const Curve& curve) const {
    const double whole = length(curve);
    return !forbidden(curve.start.at) && traced_length(whole, Along{curve}) >= whole &&
           room_at(end_pose(curve).at) >= margin;
}
double Ground::clear_length(const Curve& curve) const {
    return forbidden(curve.start.at) ? 0 : traced_length(length(curve), Along{curve});
}
bool Ground::clear(Point from, Point to) const {
    const double whole = distance(from, to);
    const Point ahead = normalized(to - from);
    return room_at(to) >= margin && traced_length(whole, [&](double s) { return from + s * ahead; }) >= whole;
}
double Ground::blemish(const Curve& curve) const {
    return traced_blemish(length(curve), blemish_step, Along{curve});
}
double Ground::blemish(Point from, Point to) const {
    const double whole = distance(from, to);
    const Point ahead = normalized(to - from);
    return traced_blemish(whole, weighed_step, [&](double s) { return from + s * ahead; });
}

}  // namespace strandline::route
