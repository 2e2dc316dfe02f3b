#include "math/region/grid.hpp"

#include <algorithm>

namespace strandline::grid {
namespace {

constexpr double half_range =
    536870912.0;  // 2^29: half of what Clipper's fast path holds, the rest is headroom

Polygon polygon_of(const ClipperLib::Path& path, const Grid& grid) {
    Polygon polygon;
    polygon.reserve(path.size());
    for (const ClipperLib::IntPoint& p : path)
        polygon.push_back({grid.origin.x + static_cast<double>(p.X) / grid.scale,
                           grid.origin.y + static_cast<double>(p.Y) / grid.scale});
    return polygon;
}

void collect(const ClipperLib::PolyNode& outer, const Grid& grid, Regions& regions) {
    Region region{polygon_of(outer.Contour, grid), {}};
    if (signed_area(region.outer) < 0) region.outer = reversed(std::move(region.outer));
    for (const ClipperLib::PolyNode* hole : outer.Childs) {
        Polygon polygon = polygon_of(hole->Contour, grid);
        if (signed_area(polygon) > 0) polygon = reversed(std::move(polygon));
        if (polygon.size() >= 3) region.holes.push_back(std::move(polygon));
    }
    if (region.outer.size() >= 3) regions.push_back(std::move(region));
    for (const ClipperLib::PolyNode* hole : outer.Childs)
        for (const ClipperLib::PolyNode* island : hole->Childs) collect(*island, grid, regions);
}

}  // namespace

Grid fitted_to(Box box) {
    if (box.empty()) return {};
    const double half = std::max({box.width() / 2, box.height() / 2, std::numeric_limits<double>::min()});
    const double scale = std::exp2(std::clamp(std::floor(std::log2(half_range / half)), -900.0, 900.0));
    const auto to_step = [&](double x) { return std::round(x * scale) / scale; };
    return {{to_step((box.low.x + box.high.x) / 2), to_step((box.low.y + box.high.y) / 2)}, scale};
}

ClipperLib::Path on(const Grid& grid, const std::vector<Point>& points) {
    ClipperLib::Path path;
    path.reserve(points.size());
    for (Point p : points)
        path.emplace_back(std::llround((p.x - grid.origin.x) * grid.scale),
                          std::llround((p.y - grid.origin.y) * grid.scale));
    return path;
}

void add(ClipperLib::Paths& paths, const Grid& grid, const Regions& regions) {
    for (const Region& region : regions) {
        paths.push_back(on(grid, region.outer));
        for (const Polygon& hole : region.holes) paths.push_back(on(grid, hole));
    }
}

Regions regions_of(const ClipperLib::PolyTree& tree, const Grid& grid) {
    Regions regions;
    for (const ClipperLib::PolyNode* outer : tree.Childs) collect(*outer, grid, regions);
    return regions;
}

}  // namespace strandline::grid
