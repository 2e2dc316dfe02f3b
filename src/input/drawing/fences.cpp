// The field's border and keep-outs, as shapes of the drawing.
#include <algorithm>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {

void place_fences(Drawing& drawing, const std::vector<Fence>& fences, const Placement& placement,
                  double tolerance) {
    for (const Fence& fence : fences) {
        const svg::Shape& shape = *fence.shape;
        std::vector<Polygon> outlines;
        std::vector<Polyline> open, closed;
        for (const Path& path : shape.subpaths) {
            Polyline points = flattened(transformed(path, placement.to_canvas), tolerance);
            (path.closed ? closed : open).push_back(points);
            if (points.size() >= 3) outlines.push_back(std::move(points));
        }
        // A line is a rope or a wall as wide as it is drawn; a line that is filled bounds an area.
        Regions area;
        if (shape.fill || !closed.empty())
            area = resolved(
                outlines, shape.fill_rule == svg::FillRule::nonzero ? FillRule::nonzero : FillRule::even_odd);
        if (!fence.border && shape.stroke) {
            const double radius = std::max(tolerance, shape.stroke_width * placement.scale / 2);
            if (!open.empty()) area = united(area, swept(open, false, radius));
            if (!closed.empty()) area = united(area, swept(closed, true, radius));
        }
        if (area.empty()) {
            drawing.warnings.push_back({shape.place, fence.border ? "the border bounds no area: passed over"
                                                                  : "a keep-out without area: passed over"});
        } else if (!fence.border) {
            drawing.keep_out.insert(drawing.keep_out.end(), area.begin(), area.end());
        } else if (drawing.border || area.size() > 1) {
            drawing.warnings.push_back({shape.place, "a second border is passed over"});
            if (!drawing.border) drawing.border = area.front();
        } else {
            drawing.border = area.front();
        }
    }
}

}  // namespace strandline::drawing_parts
