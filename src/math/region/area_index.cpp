// Edges of an area in level bands, and exact paths cut at them.
#include <algorithm>
#include <cmath>

#include "math/region/region.hpp"

namespace strandline {

namespace {

/// Do the closed segment and the closed box meet? Separating axes: x, y, and the segment's normal.
bool meets(Point a, Point b, const Box& box) {
    if (std::max(a.x, b.x) < box.low.x || std::min(a.x, b.x) > box.high.x || std::max(a.y, b.y) < box.low.y ||
        std::min(a.y, b.y) > box.high.y)
        return false;
    const Point normal = left_normal(b - a), middle = between(box.low, box.high, 0.5);
    const double reach = (std::abs(normal.x) * box.width() + std::abs(normal.y) * box.height()) / 2;
    return std::abs(dot(normal, middle - a)) <= reach;
}

/// Where between t0 and t1 of its segment the path crosses the line through a and b, whose sides it is on
/// there: halving to rounding.
double crossing_place(const Path& path, double low, double high, Point a, Point b) {
    const auto side = [&](double place) { return cross(b - a, point_at(path, place) - a); };
    const bool rising = side(low) < 0;
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        ((side(middle) < 0) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// `next` continues `path`.
void append(Path& path, Path next) {
    path.segments.insert(path.segments.end(), std::make_move_iterator(next.segments.begin()),
                         std::make_move_iterator(next.segments.end()));
}

}  // namespace

AreaIndex::AreaIndex(const Regions& regions) : box_(strandline::bounds(regions)) {
    const auto add = [&](const Polygon& polygon) {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            edges_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    };
    for (const Region& region : regions) {
        add(region.outer);
        std::ranges::for_each(region.holes, add);
    }
    constexpr double most_bands = 1024;
    const double bands =
        std::clamp(std::floor(2 * std::sqrt(static_cast<double>(edges_.size()))), 1.0, most_bands);
    band_height_ = edges_.empty() ? 0 : box_.height() / bands;
    band_starts_.assign(static_cast<std::size_t>(bands) + 1, 0);
    const auto each_band = [&](const Edge& edge, auto use) {
        const auto last = band_of(std::max(edge.a.y, edge.b.y));
        for (auto band = band_of(std::min(edge.a.y, edge.b.y)); band <= last; ++band) use(band);
    };
    for (const Edge& edge : edges_) each_band(edge, [&](std::size_t band) { ++band_starts_[band + 1]; });
    for (std::size_t band = 1; band < band_starts_.size(); ++band)
        band_starts_[band] += band_starts_[band - 1];
    band_edges_.resize(band_starts_.back());
    auto fill = band_starts_;
    for (std::size_t i = 0; i < edges_.size(); ++i)
        each_band(edges_[i], [&](std::size_t band) { band_edges_[fill[band]++] = i; });
}

std::size_t AreaIndex::band_of(double y) const {
    const double band = band_height_ > 0 ? (y - box_.low.y) / band_height_ : 0;
    return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(band_starts_.size() - 2)));
}

bool AreaIndex::contains(Point p) const {
    if (!strandline::contains(box_, p)) return false;
    bool inside = false;
    const auto band = band_of(p.y);
    for (auto i = band_starts_[band]; i < band_starts_[band + 1]; ++i) {
        const auto& [a, b] = edges_[band_edges_[i]];
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

AreaIndex::Cover AreaIndex::cover_of(Box box) const {
    if (!overlaps(box_, box)) return Cover::outside;
    const auto last = band_of(box.high.y);
    for (auto i = band_starts_[band_of(box.low.y)]; i < band_starts_[last + 1]; ++i) {
        const auto& [a, b] = edges_[band_edges_[i]];
        if (meets(a, b, box)) return Cover::crossed;
    }
    return contains(between(box.low, box.high, 0.5)) ? Cover::inside : Cover::outside;
}

PathParts AreaIndex::parted(const Path& path, double tolerance) const {
    PathParts parts;
    std::vector<double> places;
    Point from = path.start;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        const Path one{from, {path.segments[i]}, false};
        const auto points = flattened(one, tolerance);
        const auto chords = static_cast<double>(points.size() - 1);
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const Point p = points[k], q = points[k + 1];
            const Box box = including(including(Box{}, p), q);
            if (!overlaps(box_, box)) continue;
            const auto last = band_of(box.high.y);
            for (auto at = band_starts_[band_of(box.low.y)]; at < band_starts_[last + 1]; ++at) {
                const auto& [a, b] = edges_[band_edges_[at]];
                const double p_side = cross(b - a, p - a), q_side = cross(b - a, q - a);
                if ((p_side < 0) == (q_side < 0)) continue;
                if ((cross(q - p, a - p) < 0) == (cross(q - p, b - p) < 0)) continue;
                const double low = static_cast<double>(k) / chords,
                             high = static_cast<double>(k + 1) / chords;
                places.push_back(static_cast<double>(i) + crossing_place(one, low, high, a, b));
            }
        }
        from = end_of(path.segments[i]);
    }
    std::ranges::sort(places);  // an edge of several bands gives its place several times
    places.erase(std::unique(places.begin(), places.end()), places.end());

    const auto side_of = [&](double low, double high) { return contains(point_at(path, (low + high) / 2)); };
    const auto end = static_cast<double>(path.segments.size());
    if (places.empty()) {
        (side_of(0, std::min(1.0, end)) ? parts.inside : parts.outside).push_back(path);
        return parts;
    }
    auto pieces = split(path, places);
    std::vector<std::pair<bool, Path>> runs;  // neighbours on the same side made one
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].segments.empty()) continue;
        const bool in = side_of(i == 0 ? 0 : places[i - 1], i < places.size() ? places[i] : end);
        if (!runs.empty() && runs.back().first == in)
            append(runs.back().second, std::move(pieces[i]));
        else
            runs.emplace_back(in, std::move(pieces[i]));
    }
    if (runs.size() == 1) runs.front().second.closed = path.closed;
    if (path.closed && runs.size() > 2 && runs.front().first == runs.back().first) {
        append(runs.back().second, std::move(runs.front().second));
        runs.erase(runs.begin());
    }
    for (auto& [in, piece] : runs) (in ? parts.inside : parts.outside).push_back(std::move(piece));
    return parts;
}

}  // namespace strandline
