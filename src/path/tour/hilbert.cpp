#include "path/tour/hilbert.hpp"

#include <algorithm>
#include <cstdint>

namespace strandline::tour {
namespace {

constexpr int levels = 16;

/// Place of a cell on the curve: quadrant by quadrant, turned so that the curve goes on within each.
std::uint64_t place_of(std::uint32_t x, std::uint32_t y) {
    std::uint64_t place = 0;
    for (int level = levels - 1; level >= 0; --level) {
        const std::uint32_t right = x >> level & 1U, up = y >> level & 1U;
        place = place << 2U | ((3U * right) ^ up);
        if (up != 0) continue;
        if (right != 0) {
            x = ~x;
            y = ~y;
        }
        std::swap(x, y);
    }
    return place;
}

}  // namespace

std::vector<int> along_hilbert_curve(const std::vector<Point>& points) {
    Box box;
    for (const Point p : points) box = including(box, p);
    const double wide = std::max(box.width(), box.height());
    const double cells = wide > 0 ? ((1U << levels) - 1) / wide : 0;
    std::vector<std::pair<std::uint64_t, int>> places;
    places.reserve(points.size());
    for (const Point p : points)
        places.emplace_back(place_of(static_cast<std::uint32_t>((p.x - box.low.x) * cells),
                                     static_cast<std::uint32_t>((p.y - box.low.y) * cells)),
                            static_cast<int>(places.size()));
    std::sort(places.begin(), places.end());
    std::vector<int> order;
    order.reserve(points.size());
    for (const auto& [place, index] : places) order.push_back(index);
    return order;
}

}  // namespace strandline::tour
