#include "input/svg/clip.hpp"

#include <algorithm>

namespace strandline::svg {

namespace {

double diagonal(const Box& box) { return box.empty() ? 0 : distance(box.low, box.high); }
/// Above zero even where all is one point.
double tolerance_for(const Box& box) { return std::max(clip_tolerance * diagonal(box), 1e-12); }

}  // namespace

std::shared_ptr<Clip> make_clip(Regions regions) {
    AreaIndex index(regions);
    return std::make_shared<Clip>(Clip{std::move(regions), std::move(index)});
}

std::shared_ptr<Clip> both(const std::shared_ptr<Clip>& a, const std::shared_ptr<Clip>& b) {
    if (!a || b->regions.empty()) return b;
    using Cover = AreaIndex::Cover;
    const auto a_covers = a->index.cover_of(b->index.bounds());
    if (a_covers == Cover::inside) return b;
    if (a_covers == Cover::outside) return make_clip({});
    if (b->index.cover_of(a->index.bounds()) == Cover::inside) return a;
    return make_clip(intersected(a->regions, b->regions));
}

Box bounds_of(const std::vector<Path>& paths) {
    Box box;
    for (const auto& path : paths) box = united(box, bounds(path));
    return box;
}

void append_polygons(const std::vector<Path>& paths, std::vector<Polygon>& polygons) {
    const double tolerance = tolerance_for(bounds_of(paths));
    for (const auto& path : paths)
        if (auto polygon = flattened(path, tolerance); polygon.size() >= 3)
            polygons.push_back(std::move(polygon));
}

std::vector<Path> clipped_area(const std::vector<Path>& outline, strandline::FillRule rule,
                               const Clip& clip) {
    std::vector<Polygon> polygons;
    append_polygons(outline, polygons);
    const auto left = resolved_within(polygons, rule, clip.regions);
    std::vector<Path> paths;
    for (const auto& [outer, holes] : left) {
        paths.push_back(path_through(outer, true));
        for (const auto& hole : holes) paths.push_back(path_through(hole, true));
    }
    return paths;
}

std::vector<Path> clipped_lines(const std::vector<Path>& lines, Clip& clip) {
    if (!clip.for_lines) clip.for_lines.emplace(inset(clip.regions, -2 * tolerance_for(clip.index.bounds())));
    std::vector<Path> left;
    for (const auto& line : lines) {
        const Box box = bounds(line);
        const auto cover = clip.for_lines->cover_of(box);
        if (cover == AreaIndex::Cover::inside) left.push_back(line);
        if (cover != AreaIndex::Cover::crossed) continue;
        auto parts = clip.for_lines->parted(line, tolerance_for(box));
        std::ranges::move(parts.inside, std::back_inserter(left));
    }
    return left;
}

}  // namespace strandline::svg
