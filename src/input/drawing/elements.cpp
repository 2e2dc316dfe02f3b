#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

double sliver(double tolerance) { return tolerance * tolerance; }

Cap cap_of(svg::LineCap cap) {
    switch (cap) {
        case svg::LineCap::butt:
            return Cap::flat;
        case svg::LineCap::round:
            return Cap::round;
        case svg::LineCap::square:
            return Cap::square;
    }
    return Cap::round;
}

/// Where the outlines of an area touch or cross: its fill rule decides there what is inside.
std::vector<Contact> doubtful_places(const std::vector<Path>& paths, double tolerance) {
    constexpr double same_place = 1e-9;  // of the extent
    std::vector<Polygon> outlines;
    Box box;
    for (const Path& path : paths)
        if (Polygon outline = without_duplicate_corners(flattened(path, tolerance)); outline.size() >= 3) {
            box = united(box, bounds(outline));
            outlines.push_back(std::move(outline));
        }
    return contacts(outlines, same_place * std::max(box.width(), box.height()));
}

Regions filled(const std::vector<Path>& paths, svg::FillRule rule, double tolerance) {
    std::vector<Polygon> outlines;
    for (const Path& path : paths)
        if (Polygon outline = flattened(path, tolerance); outline.size() >= 3)
            outlines.push_back(std::move(outline));
    return resolved(outlines, rule == svg::FillRule::nonzero ? FillRule::nonzero : FillRule::even_odd);
}

/// Joins come out round: what a rake can follow.
Regions stroked(const std::vector<Path>& paths, const svg::Shape& shape, double radius, double tolerance) {
    std::vector<Polyline> open, closed;
    for (const Path& path : paths) (path.closed ? closed : open).push_back(flattened(path, tolerance));
    const Regions lines = open.empty() ? Regions{} : swept(open, false, radius, cap_of(shape.cap));
    const Regions rings = closed.empty() ? Regions{} : swept(closed, true, radius);
    return lines.empty() ? rings : rings.empty() ? lines : united(lines, rings);
}

/// The area with its stroke. Growing is several times as fast as sweeping and uniting, but knows only the
/// area's own outline: not where a subpath is open, nor a whisker without area.
Regions grown_by_stroke(const Regions& area, const std::vector<Path>& paths, const svg::Shape& shape,
                        double radius, double tolerance) {
    double outline = 0, drawn = 0;
    bool closed = true;
    for (const Region& region : area) {
        outline += perimeter(region.outer);
        for (const Polygon& hole : region.holes) outline += perimeter(hole);
    }
    for (const Path& path : paths) {
        drawn += perimeter(flattened(path, tolerance));
        closed = closed && path.closed;
    }
    constexpr double same_outline = 1e-3;
    if (closed && std::abs(outline - drawn) <= same_outline * drawn) return inset(area, -radius, tolerance);
    return united(area, stroked(paths, shape, radius, tolerance));
}

/// On the canvas, whose y axis is the other way up.
Regions moved(const Regions& regions, const Affine& map) {
    std::vector<Polygon> outlines;
    const auto add = [&](Polygon polygon) {
        for (Point& p : polygon) p = apply(map, p);
        outlines.push_back(std::move(polygon));
    };
    for (const Region& region : regions) {
        add(region.outer);
        for (const Polygon& hole : region.holes) add(hole);
    }
    return resolved(outlines, FillRule::even_odd);
}

class Ids {
  public:
    /// `id` for the first piece, "id/2", "id/3" ... for the next: the number of the piece, so that an id
    /// outlives a dropped sibling.
    std::string next(const std::string& id, std::size_t piece) {
        std::string name = piece == 0 ? id : fmt::format("{}/{}", id, piece + 1);
        // The same id twice in a file is against the rules, and common.
        if (!used_.insert(name).second) {
            int& number = last_[id];
            number = std::max(number, static_cast<int>(piece) + 1);
            do name = fmt::format("{}/{}", id, ++number);
            while (!used_.insert(name).second);
        }
        return name;
    }

  private:
    std::set<std::string> used_;
    std::map<std::string, int> last_;
};

/// The shape on the canvas, by itself.
Painted painted(const Inked& inked, const Placement& placement, const Robot& robot,
                const DrawingOptions& options, DrawingCounts& counts, Warnings& doubts) {
    const svg::Shape& shape = *inked.shape;
    Painted result{.shape = &shape, .pins = inked.pins, .hints = inked.hints, .section = inked.section};
    std::vector<Path> paths;
    for (const Path& path : shape.subpaths) paths.push_back(transformed(path, placement.to_canvas));
    std::vector<Path> lines = shape.lines ? std::vector<Path>{} : paths;  // what the stroke follows
    if (shape.lines)
        for (const Path& path : *shape.lines) lines.push_back(transformed(path, placement.to_canvas));
    const double width = shape.stroke_width * placement.scale;

    if (inked.fill) {
        if (const auto places = doubtful_places(paths, options.tolerance); !places.empty())
            doubts.push_back(
                {shape.place,
                 fmt::format(
                     "its outline touches or crosses itself at {} place{}, one of them ({:.2f}, {:.2f}) m: "
                     "filled by the {} rule",
                     places.size(), places.size() == 1 ? "" : "s", places[0].at.x, places[0].at.y,
                     shape.fill_rule == svg::FillRule::nonzero ? "nonzero" : "even-odd")});
        result.area = filled(paths, shape.fill_rule, options.tolerance);
        // Areas below the flattening's own error are what rounding left of a fill without area.
        const auto slivers = std::erase_if(
            result.area, [&](const Region& region) { return area(region) < sliver(options.tolerance); });
        if (!inked.stroke) counts.too_small += static_cast<int>(slivers);
    }
    const bool had_fill = !result.area.empty();
    Inked rest = inked;
    rest.fill = had_fill;
    if (stroke_is_area(rest, robot, placement.scale)) {
        result.area = had_fill ? grown_by_stroke(result.area, lines, shape, width / 2, options.tolerance)
                               : stroked(lines, shape, width / 2, options.tolerance);
        if (shape.stroke_clip)
            result.area = intersected(result.area, moved(*shape.stroke_clip, placement.to_canvas));
        if (!had_fill) ++counts.wide_strokes;
    }
    if (had_fill && inked.stroke) ++counts.merged;

    if (inked.fill_hides) result.hides = filled(paths, shape.fill_rule, options.tolerance);
    // A bare stroke narrower than one groove is no gap that sand could show.
    if (inked.stroke_hides && width >= robot.pin_pitch) {
        Regions band = stroked(lines, shape, width / 2, options.tolerance);
        if (shape.stroke_clip) band = intersected(band, moved(*shape.stroke_clip, placement.to_canvas));
        if (!result.area.empty()) result.area = subtracted(result.area, band);
        result.hides = result.hides.empty() ? band : united(result.hides, band);
    }
    if (result.area.empty() && inked.stroke)
        for (std::size_t k = 0; k < lines.size(); ++k) result.lines.push_back({k, std::move(lines[k])});
    return result;
}

}  // namespace

std::vector<Element> elements_of(const std::vector<Inked>& shapes, const Placement& placement,
                                 const Robot& robot, const DrawingOptions& options, DrawingCounts& counts,
                                 Warnings& warnings, const Progress& progress) {
    constexpr std::size_t most_named = 5;  // clip art has hundreds
    Warnings doubts;
    std::vector<Painted> sheets;
    for (const Inked& inked : shapes) {
        progress.report("drawing", static_cast<double>(sheets.size()) / static_cast<double>(shapes.size()));
        sheets.push_back(painted(inked, placement, robot, options, counts, doubts));
    }
    if (doubts.size() > most_named) {
        const std::size_t more = doubts.size() - most_named;
        doubts.resize(most_named);
        doubts.push_back({"areas", fmt::format("{} more outlines touch or cross themselves", more)});
    }
    warnings.insert(warnings.end(), doubts.begin(), doubts.end());
    if (options.occlusion) occlude(sheets, options.tolerance, counts, progress);

    std::vector<Element> elements;
    Ids ids;
    for (Painted& sheet : sheets) {
        const svg::Shape& shape = *sheet.shape;
        for (std::size_t piece = 0; piece < sheet.area.size(); ++piece) {
            if (area(sheet.area[piece]) < std::max(sliver(options.tolerance), options.min_area)) {
                ++counts.too_small;
                continue;
            }
            elements.push_back({ids.next(shape.id, piece), shape.layer,
                                RegionElement{std::move(sheet.area[piece])}, -1, sheet.hints, sheet.section});
        }
        // The first part of each subpath keeps its number, further ones come after all of them.
        std::set<std::size_t> met;
        std::size_t next = svg::stroked_paths(shape).size();
        for (InkLine& line : sheet.lines) {
            const std::size_t number = met.insert(line.subpath).second ? line.subpath : next++;
            elements.push_back({ids.next(shape.id, number), shape.layer,
                                LineElement{std::move(line.path), sheet.pins}, -1, sheet.hints,
                                sheet.section});
        }
    }
    return elements;
}

void drop_short(std::vector<Element>& elements, double min_length, DrawingCounts& counts) {
    counts.too_short += static_cast<int>(std::erase_if(elements, [&](const Element& element) {
        // A path of no length at all goes even where every length is welcome: nobody can drive it.
        constexpr double no_length = 1e-9;
        return !is_region(element) && length(element) < std::max(min_length, no_length);
    }));
}

}  // namespace strandline::drawing_parts
