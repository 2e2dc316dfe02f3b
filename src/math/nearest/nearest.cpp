#include "math/nearest/nearest.hpp"

#include <algorithm>
#include <cmath>

namespace strandline {
namespace {

/// Segments in a leaf: below this a scan is quicker than more boxes.
constexpr std::size_t leaf = 4;
constexpr std::size_t most_bands = 512;

double squared(Point v) { return dot(v, v); }
double squared_distance(const Box& box, Point p) {
    const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
    const double dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
    return dx * dx + dy * dy;
}

Box build(const SegmentTree::Segments& segments, std::vector<Box>& boxes, std::size_t node, std::size_t first,
          std::size_t last) {
    if (boxes.size() <= node) boxes.resize(node + 1);
    Box box;
    if (last - first <= leaf) {
        for (std::size_t k = first; k < last; ++k)
            box = including(including(box, segments[k].first), segments[k].second);
    } else {
        const std::size_t middle = (first + last) / 2;
        box = build(segments, boxes, 2 * node + 1, first, middle);
        box = united(box, build(segments, boxes, 2 * node + 2, middle, last));
    }
    boxes[node] = box;
    return box;
}

}  // namespace

SegmentTree::SegmentTree(Segments segments) : segments_(std::move(segments)) {
    if (!segments_.empty()) build(segments_, boxes_, 0, 0, segments_.size());
}

double SegmentTree::distance(Point p) const {
    if (segments_.empty()) return std::numeric_limits<double>::infinity();
    const auto& [a, b] = segments_[latest_];
    double best = squared(p - nearest_on_segment(p, a, b));
    search(0, 0, segments_.size(), p, best);
    return std::sqrt(best);
}

void SegmentTree::search(std::size_t node, std::size_t first, std::size_t last, Point p,
                         double& best_squared) const {
    if (squared_distance(boxes_[node], p) >= best_squared) return;
    if (last - first <= leaf) {
        for (std::size_t k = first; k < last; ++k) {
            const double d = squared(p - nearest_on_segment(p, segments_[k].first, segments_[k].second));
            if (d >= best_squared) continue;
            best_squared = d;
            latest_ = k;
        }
        return;
    }
    const std::size_t middle = (first + last) / 2;
    const bool right_first =
        squared_distance(boxes_[2 * node + 2], p) < squared_distance(boxes_[2 * node + 1], p);
    if (right_first) search(2 * node + 2, middle, last, p, best_squared);
    search(2 * node + 1, first, middle, p, best_squared);
    if (!right_first) search(2 * node + 2, middle, last, p, best_squared);
}

SegmentTree::Segments segments_of(const Polyline& line, bool closed) {
    SegmentTree::Segments segments;
    for (std::size_t k = 1; k < line.size(); ++k) segments.emplace_back(line[k - 1], line[k]);
    if (closed && line.size() > 1) segments.emplace_back(line.back(), line.front());
    return segments;
}

BandedRegion::BandedRegion(const Region& region) : box_(bounds(region)) {
    SegmentTree::Segments edges = segments_of(region.outer, true);
    for (const Polygon& hole : region.holes)
        for (const auto& edge : segments_of(hole, true)) edges.push_back(edge);
    bands_.resize(std::clamp<std::size_t>(edges.size() / 4, 1, most_bands));
    if (box_.empty()) return;
    const auto band = [&](double y) {
        const double share = box_.height() > 0 ? (y - box_.low.y) / box_.height() : 0;
        return std::min(bands_.size() - 1,
                        static_cast<std::size_t>(std::max(0.0, share * static_cast<double>(bands_.size()))));
    };
    for (const auto& edge : edges) {
        const auto [low, high] = std::minmax(edge.first.y, edge.second.y);
        for (std::size_t k = band(low); k <= band(high); ++k) bands_[k].push_back(edge);
    }
}

bool BandedRegion::contains(Point p) const {
    if (box_.empty() || !strandline::contains(box_, p)) return false;
    const double share = box_.height() > 0 ? (p.y - box_.low.y) / box_.height() : 0;
    const auto band =
        std::min(bands_.size() - 1, static_cast<std::size_t>(share * static_cast<double>(bands_.size())));
    bool inside = false;
    for (const auto& [a, b] : bands_[band])
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    return inside;
}

}  // namespace strandline
