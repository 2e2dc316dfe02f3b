// The obstacles' edges in square cells, each with its distance from them: the room round a point is read off
// its cell where it is far from all, and measured where it is near.
#include <algorithm>
#include <cmath>
#include <limits>

#include "path/route/route.hpp"

namespace strandline::route {
namespace {

// All in least radii.
constexpr double finest_cell = 0.25;
/// Distances are known up to the clearance and this.
constexpr double far_reach = 1;
/// Points nearer to an edge than the clearance and this have it measured.
constexpr double near_reach = 0.12;
/// Strings are drawn round outlines thinned by this, that much farther out.
constexpr double string_tolerance = 0.04;
/// Outlines are thinned by this for checking, and kept that much farther from.
constexpr double outline_tolerance = 0.002;
/// Curves keep this much more than the clearance, so that proofs end: steps are at least as long.
constexpr double margin = 0.002;
/// Strings are drawn this much farther out than that, so that steps along them are longer.
constexpr double string_margin = 0.012;
/// Blemishes are measured by steps of this.
constexpr double blemish_step = 0.02;
/// Those of straight parts of strings, which are only weighed against each other, by longer ones.
constexpr double weighed_step = 0.1;

/// Cells are made larger where there would be more of them.
constexpr double most_cells = 4e6;
/// A corner turns by more than this, radians.
constexpr double least_corner = 0.001;

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

Ground::Ground(GroundOptions options) : options_(options), cell_size_(finest_cell * options.radius) {}

double Ground::reach() const { return options_.clearance + share(far_reach); }
double Ground::exact_within() const { return options_.clearance + share(near_reach); }
double Ground::string_offset() const {
    return options_.clearance + share(string_tolerance + outline_tolerance + margin + string_margin);
}

std::size_t Ground::cell_of(Point p) const {
    const auto at = [&](double along, std::size_t count) {
        return along > 0 ? std::min(static_cast<std::size_t>(along / cell_size_), count - 1) : 0;
    };
    return at(p.y - box_.low.y, rows_) * columns_ + at(p.x - box_.low.x, columns_);
}

Point Ground::middle_of(std::size_t cell) const {
    return box_.low + cell_size_ * Point{static_cast<double>(cell % columns_) + 0.5,
                                         static_cast<double>(cell / columns_) + 0.5};
}

void Ground::grow_to(Box box) {
    if (!cells_.empty() && contains(box_, box.low) && contains(box_, box.high)) return;
    if (!cells_.empty()) {  // half as much again on each side: so that growing is rare
        box = united(box_, box);
        box = grown(box, std::max(box.width(), box.height()) / 2);
    }
    lay_cells(box);
    for (std::size_t i = 0; i < edges_.size(); ++i) list_edge(i);
}

void Ground::lay_cells(Box box) {
    while ((box.width() / cell_size_ + 1) * (box.height() / cell_size_ + 1) > most_cells) cell_size_ *= 2;
    columns_ = static_cast<std::size_t>(box.width() / cell_size_) + 1;
    rows_ = static_cast<std::size_t>(box.height() / cell_size_) + 1;
    box_ = {box.low, box.low + cell_size_ * Point{static_cast<double>(columns_), static_cast<double>(rows_)}};
    cells_.assign(columns_ * rows_, Cell{reach(), {}});
}

void Ground::add_ring(const Polygon& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        edges_.push_back({ring[j], ring[i]});
        list_edge(edges_.size() - 1);
    }
}

void Ground::list_edge(std::size_t number) {
    const Edge& edge = edges_[number];
    const double listed = exact_within() + cell_size_ / std::numbers::sqrt2;
    const Box near = grown(including(including(Box{}, edge.a), edge.b), std::max(reach(), listed));
    const std::size_t first = cell_of(near.low), last = cell_of(near.high);
    for (std::size_t row = first / columns_; row <= last / columns_; ++row)
        for (std::size_t column = first % columns_; column <= last % columns_; ++column) {
            const Point middle = middle_of(row * columns_ + column);
            Cell& cell = cells_[row * columns_ + column];
            const double d = distance_to_segment(middle, edge.a, edge.b);
            cell.distance = std::min(cell.distance, d);
            if (d < listed) cell.edges.push_back(static_cast<int>(number));
        }
}

void Ground::add_outline(const Region& region, bool obstacle_inside) {
    grow_to(grown(strandline::bounds(region), reach() + cell_size_));
    const auto take = [&](const Polygon& ring, bool inside) {
        const Polygon turned = without_area_on_right(ring, inside);
        add_ring(thinned_outline(turned, share(outline_tolerance)));
        append_corners(corners_, thinned_outline(turned, share(string_tolerance)));
    };
    take(region.outer, obstacle_inside);
    for (const Polygon& hole : region.holes) take(hole, !obstacle_inside);
}

void Ground::add(const Region& obstacle) {
    add_outline(obstacle, true);
    obstacles_.push_back(obstacle);
    boxes_.push_back(strandline::bounds(obstacle));
    added_.push_back(grown(boxes_.back(), string_offset()));
}

void Ground::add(const Regions& obstacles) {
    for (const Region& obstacle : obstacles) add(obstacle);
}

void Ground::add_field(const Region& field) {
    add_outline(field, false);
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
    const double kept = options_.clearance + share(outline_tolerance);
    if (cells_.empty() || !contains(box_, p)) return reach() - kept;
    const std::size_t at = cell_of(p);
    const Cell& cell = cells_[at];
    const double by_cell = cell.distance - distance(middle_of(at), p);
    if (by_cell >= exact_within()) return by_cell - kept;
    double least = exact_within();
    for (const int number : cell.edges) {
        const Edge& edge = edges_[static_cast<std::size_t>(number)];
        least = std::min(least, distance_to_segment(p, edge.a, edge.b));
    }
    return least - kept;
}

bool Ground::clear(Point p) const { return room_at(p) >= share(margin) && !forbidden(p); }

/// Once the start is allowed, the rest is: nothing forbidden is reached without coming near an edge.
template <class At>
double Ground::traced_length(double length, At&& at) const {
    for (double s = 0;;) {
        const double room = room_at(at(s));
        if (room < share(margin)) return s;
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
        if (room >= share(margin) && near) inside = forbidden(p);  // an edge may have been crossed
        near = room < share(margin);
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
           room_at(end_pose(curve).at) >= share(margin);
}
double Ground::clear_length(const Curve& curve) const {
    return forbidden(curve.start.at) ? 0 : traced_length(length(curve), Along{curve});
}
bool Ground::clear(Point from, Point to) const {
    const double whole = distance(from, to);
    const Point ahead = normalized(to - from);
    return room_at(to) >= share(margin) &&
           traced_length(whole, [&](double s) { return from + s * ahead; }) >= whole;
}
double Ground::blemish(const Curve& curve) const {
    return traced_blemish(length(curve), share(blemish_step), Along{curve});
}
double Ground::blemish(Point from, Point to) const {
    const double whole = distance(from, to);
    const Point ahead = normalized(to - from);
    return traced_blemish(whole, share(weighed_step), [&](double s) { return from + s * ahead; });
}

}  // namespace strandline::route
