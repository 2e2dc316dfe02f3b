#include "path/fill/precedence.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace strandline::fill {
namespace {

// In widths, between middles: swaths that meet are one apart, and in a bend the bar stands skew.
constexpr double reach = 1.25, step = 0.25;

using Cell = std::pair<long, long>;

}  // namespace

std::vector<std::pair<int, int>> precedence(const std::vector<Stroke>& strokes, double width) {
    const int count = static_cast<int>(strokes.size());
    if (count < 2) return {};
    const auto cell_of = [&](Point p) {
        return Cell{std::lround(std::floor(p.x / (reach * width))),
                    std::lround(std::floor(p.y / (reach * width)))};
    };
    struct Place {
        Point at;
        int stroke;
    };
    std::map<Cell, std::vector<Place>> raked;
    std::set<std::pair<int, int>> pairs;
    for (int k = 0; k < count; ++k) {
        std::vector<Point> points;
        for (const Curve& curve : strokes[static_cast<std::size_t>(k)].rake_path)
            for (const CurvePoint& point : sampled(curve, step * width)) points.push_back(point.pose.at);
        for (const Point at : points) {
            const auto [x, y] = cell_of(at);
            for (long i = x - 1; i <= x + 1; ++i)
                for (long j = y - 1; j <= y + 1; ++j) {
                    const auto cell = raked.find({i, j});
                    if (cell == raked.end()) continue;
                    for (const Place& place : cell->second)
                        if (distance(place.at, at) < reach * width) pairs.emplace(place.stroke, k);
                }
        }
        for (const Point at : points) raked[cell_of(at)].push_back({at, k});
        if (k + 1 < count) pairs.emplace(k, count - 1);
    }
    return {pairs.begin(), pairs.end()};
}

}  // namespace strandline::fill
