#include <algorithm>
#include <cmath>
#include <utility>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

// Flattening takes its part of the tolerance at both curves; half of it remains for true differences.
constexpr double flattening_share = 0.25;
// Of the length: neighbouring pieces of a finely chopped curve differ by a whole length, and are not each
// other's copy.
constexpr double length_share = 0.1;

/// A chain by share of its length, 0..1; a closed one runs on beyond both.
struct Measured {
    std::vector<Point> points;
    std::vector<double> shares;
    bool closed = false;

    Measured(std::vector<Point> chain, bool ring) : points(std::move(chain)), closed(ring) {
        if (closed && !points.empty()) points.push_back(points.front());
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) sum += distance(points[i - 1], points[i]);
            shares.push_back(sum);
        }
        total = sum;
        for (double& share : shares) share = sum > 0 ? share / sum : 0;
    }
    Point at(double share) const {
        share = closed ? share - std::floor(share) : std::clamp(share, 0.0, 1.0);
        const auto above = std::ranges::lower_bound(shares, share);
        const auto i = static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(above - shares.begin(), 1, std::ssize(shares) - 1));
        const double step = shares[i] - shares[i - 1];
        return between(points[i - 1], points[i], step > 0 ? (share - shares[i - 1]) / step : 0);
    }
    double nearest_share(Point p) const {
        double best = std::numeric_limits<double>::infinity(), share = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point q = nearest_on_segment(p, points[i - 1], points[i]);
            if (const double d = distance(p, q); d < best) {
                const double whole = distance(points[i - 1], points[i]);
                best = d;
                share = shares[i - 1] +
                        (whole > 0 ? distance(points[i - 1], q) / whole : 0) * (shares[i] - shares[i - 1]);
            }
        }
        return share;
    }
    double total = 0;
};

/// Point by point at equal shares, b run from `offset` in the sense `sense`: largest at a corner of either
/// chain, so only those are looked at.
bool runs_along(const Measured& a, const Measured& b, double offset, double sense, double tolerance) {
    for (std::size_t i = 0; i < a.points.size(); ++i)
        if (distance(a.points[i], b.at(offset + sense * a.shares[i])) > tolerance) return false;
    for (std::size_t i = 0; i < b.points.size(); ++i)
        if (distance(b.points[i], a.at(sense * (b.shares[i] - offset))) > tolerance) return false;
    return true;
}

bool same_chain(const Measured& a, const Measured& b, double tolerance) {
    tolerance = std::min(tolerance, length_share * std::min(a.total, b.total));
    if (a.closed != b.closed || a.points.size() < 2 || b.points.size() < 2) return false;
    const double offset = a.closed ? b.nearest_share(a.points.front()) : 0;
    return runs_along(a, b, offset, 1, tolerance) || runs_along(a, b, a.closed ? offset : 1, -1, tolerance);
}

Measured measured(const Element& element, double tolerance) {
    if (const auto* line = std::get_if<LineElement>(&element.what)) {
        const Box box = bounds(line->path);
        const double extent = box.width() + box.height();
        const double chord_error = extent > 0 ? std::min(tolerance, length_share * extent) : tolerance;
        return {flattened(line->path, flattening_share * chord_error), line->path.closed};
    }
    return {std::get<RegionElement>(element.what).region.outer, true};
}

bool same_holes(const Region& a, const Region& b, double tolerance) {
    return a.holes.size() == b.holes.size() && std::ranges::all_of(a.holes, [&](const Polygon& hole) {
               return std::ranges::any_of(b.holes, [&](const Polygon& other) {
                   return same_chain({hole, true}, {other, true}, tolerance);
               });
           });
}

bool same(const Element& a, const Element& b, double tolerance) {
    if (is_region(a) != is_region(b)) return false;
    if (!same_chain(measured(a, tolerance), measured(b, tolerance), tolerance)) return false;
    return !is_region(a) || same_holes(std::get<RegionElement>(a.what).region,
                                       std::get<RegionElement>(b.what).region, tolerance);
}

}  // namespace

void drop_duplicates(std::vector<Element>& elements, double tolerance, DrawingCounts& counts) {
    if (!(tolerance > 0)) return;
    std::vector<Box> boxes;
    std::vector<Point> corners;
    for (const Element& element : elements) boxes.push_back(bounds(element));
    for (const Box& box : boxes) corners.push_back(box.low);
    // Equal within the tolerance: box corners within its diagonal.
    const NearIndex index(corners, 2 * tolerance);
    std::vector<bool> dropped(elements.size(), false);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (dropped[i]) continue;
        index.visit_near(corners[i], [&](int other) {
            const auto j = static_cast<std::size_t>(other);
            if (j <= i || dropped[j] || distance(boxes[i].high, boxes[j].high) > 2 * tolerance) return true;
            if (!same(elements[i], elements[j], tolerance)) return true;
            dropped[j] = true;
            ++counts.duplicates;
            if (auto* kept = std::get_if<LineElement>(&elements[i].what))
                kept->pins = std::max(kept->pins, std::get<LineElement>(elements[j].what).pins);
            return true;
        });
    }
    std::size_t at = 0;
    std::erase_if(elements, [&](const Element&) { return dropped[at++]; });
}

}  // namespace strandline::drawing_parts
