#include <algorithm>
#include <cmath>

#include "math/nearest/nearest.hpp"

namespace strandline {

SegmentSquares::SegmentSquares(SegmentTree::Segments segments, double square)
    : segments_(std::move(segments)), square_(square) {
    for (std::size_t number = 0; number < segments_.size(); ++number) {
        const auto& [a, b] = segments_[number];
        // Cut into pieces no longer than a square, so that a slanted segment is in few squares.
        const double pieces = std::max(1.0, std::ceil(strandline::distance(a, b) / square));
        for (double k = 0; k < pieces; ++k) {
            const Point from = between(a, b, k / pieces), to = between(a, b, (k + 1) / pieces);
            for (int i = place(std::min(from.x, to.x)); i <= place(std::max(from.x, to.x)); ++i)
                for (int j = place(std::min(from.y, to.y)); j <= place(std::max(from.y, to.y)); ++j) {
                    std::vector<std::size_t>& here = squares_[key(i, j)];
                    if (here.empty() || here.back() != number) here.push_back(number);
                }
        }
    }
}

std::vector<SegmentSquares::Near> SegmentSquares::near(Point p, double reach) const {
    std::vector<Near> found;
    for (int i = place(p.x - reach); i <= place(p.x + reach); ++i)
        for (int j = place(p.y - reach); j <= place(p.y + reach); ++j) {
            const auto square = squares_.find(key(i, j));
            if (square == squares_.end()) continue;
            for (const std::size_t number : square->second) {
                const auto& [a, b] = segments_[number];
                const Point at = nearest_on_segment(p, a, b);
                const double d = strandline::distance(p, at);
                if (d <= reach) found.push_back({number, at, d});
            }
        }
    std::ranges::sort(found, {}, &Near::number);
    const auto again = std::ranges::unique(found, {}, &Near::number);
    found.erase(again.begin(), again.end());
    return found;
}

int SegmentSquares::place(double coordinate) const {
    return static_cast<int>(std::floor(coordinate / square_));
}

std::uint64_t SegmentSquares::key(int i, int j) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) | static_cast<std::uint32_t>(j);
}

}  // namespace strandline
