#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

// Ends nearer than this are one point for any drawing: rounding of transforms, in metres.
constexpr double rounding = 1e-6;
// A line shorter than this many tolerances is a piece of a curve, not a ring.
constexpr double ring_lengths = 3;
constexpr int nobody = -1;

bool move_start(Path& path, Point to) {
    if (path.segments.empty() || std::holds_alternative<ArcSegment>(path.segments.front())) return false;
    if (auto* cubic = std::get_if<CubicSegment>(&path.segments.front()))
        cubic->control1 = cubic->control1 + (to - path.start);
    path.start = to;
    return true;
}

bool move_end(Path& path, Point to) {
    if (path.segments.empty()) return false;
    if (auto* line = std::get_if<LineSegment>(&path.segments.back())) {
        line->to = to;
        return true;
    }
    if (auto* cubic = std::get_if<CubicSegment>(&path.segments.back())) {
        cubic->control2 = cubic->control2 + (to - cubic->to);
        cubic->to = to;
        return true;
    }
    return false;  // an arc's end follows from its ellipse
}

void append(Path& path, Path next) {
    const Point end = end_of(path);
    // A shifted end keeps the drawing's directions; a tiny bridge would be two corners. Only between two arcs
    // is there no other way.
    if (end != next.start && !move_start(next, end) && !move_end(path, next.start))
        path.segments.push_back(LineSegment{next.start});
    path.segments.insert(path.segments.end(), next.segments.begin(), next.segments.end());
}

void close(Path& path) {
    const Point end = end_of(path);
    if (end != path.start && !move_end(path, path.start) && !move_start(path, end))
        path.segments.push_back(LineSegment{path.start});
    path.closed = true;
}

LineElement* open_line(Element& element) {
    auto* line = std::get_if<LineElement>(&element.what);
    return line && !line->path.closed && !line->path.segments.empty() ? line : nullptr;
}

/// What two lines must share to become one.
using Kin = std::tuple<std::string, int, int, std::vector<std::pair<std::string, std::string>>>;
Kin kin_of(const Element& element) {
    Kin kin{element.layer, std::get<LineElement>(element.what).pins, element.section, {}};
    for (const svg::Hint& hint : element.hints) std::get<3>(kin).emplace_back(hint.name, hint.value);
    return kin;
}

/// End 2 i is the start of lines[i], 2 i + 1 its end. partner[e]: the only other end near e of the same pins,
/// layer and hints, if e is also its only one.
std::vector<int> partners(const std::vector<Element*>& lines, double tolerance) {
    std::map<Kin, std::vector<int>> groups;
    std::vector<Point> at(2 * lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LineElement& line = std::get<LineElement>(lines[i]->what);
        at[2 * i] = line.path.start;
        at[2 * i + 1] = end_of(line.path);
        auto& group = groups[kin_of(*lines[i])];
        group.push_back(static_cast<int>(2 * i));
        group.push_back(static_cast<int>(2 * i + 1));
    }
    std::vector<int> only(at.size(), nobody);
    for (const auto& [key, ends] : groups) {
        std::vector<Point> points;
        for (const int end : ends) points.push_back(at[static_cast<std::size_t>(end)]);
        const NearIndex index(points, tolerance);
        for (std::size_t k = 0; k < ends.size(); ++k) {
            int found = nobody, others = 0;
            index.visit_near(points[k], [&](int other) {
                if (other == static_cast<int>(k)) return true;
                found = other;
                return ++others < 2;
            });
            if (others == 1) only[static_cast<std::size_t>(ends[k])] = ends[static_cast<std::size_t>(found)];
        }
    }
    std::vector<int> partner(at.size(), nobody);
    for (std::size_t e = 0; e < at.size(); ++e)
        if (only[e] != nobody && only[static_cast<std::size_t>(only[e])] == static_cast<int>(e))
            partner[e] = only[e];
    return partner;
}

void close_rings(std::vector<Element>& elements, double tolerance) {
    for (Element& element : elements)
        if (LineElement* line = open_line(element);
            line && distance(line->path.start, end_of(line->path)) <= tolerance &&
            length(line->path) > ring_lengths * tolerance)
            close(line->path);
}

void join_within(std::vector<Element>& elements, double tolerance, DrawingCounts& counts) {
    close_rings(elements, tolerance);
    std::vector<Element*> lines;
    for (Element& element : elements)
        if (open_line(element)) lines.push_back(&element);
    const std::vector<int> partner = partners(lines, tolerance);

    std::vector<bool> used(lines.size(), false);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (used[i]) continue;
        // Back to the chain's first piece, seen in the sense of lines[i], its earliest; a ring leads back to
        // lines[i] itself.
        std::size_t front = 2 * i;  // the end at which the walk enters the present piece
        bool ring = false;
        while (partner[front] != nobody && !ring) {
            const std::size_t before = static_cast<std::size_t>(partner[front]);
            if (before / 2 == front / 2) break;  // its own two ends: too short to be a ring
            front = before ^ 1u;
            ring = front / 2 == i;
        }
        if (ring) front = 2 * i;
        Path chain;
        for (std::size_t enter = front; !used[enter / 2];) {
            LineElement& piece = std::get<LineElement>(lines[enter / 2]->what);
            used[enter / 2] = true;
            Path next = enter % 2 == 0 ? piece.path : reversed(piece.path);
            if (enter == front)
                chain = std::move(next);
            else {
                append(chain, std::move(next));
                ++counts.joined;
            }
            if (enter / 2 != i) piece.path.segments.clear();  // taken up; erased below
            if (partner[enter ^ 1u] == nobody) break;
            enter = static_cast<std::size_t>(partner[enter ^ 1u]);
        }
        if (ring) {
            close(chain);
            ++counts.joined;
        }
        std::get<LineElement>(lines[i]->what).path = std::move(chain);
    }
    std::erase_if(elements, [](const Element& element) {
        const auto* line = std::get_if<LineElement>(&element.what);
        return line && line->path.segments.empty();
    });
}

}  // namespace

NearIndex::NearIndex(const std::vector<Point>& points, double tolerance)
    : points_(points), tolerance_(tolerance) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        Cell of = cell(points_[i]);
        of.point = static_cast<int>(i);
        cells_.push_back(of);
    }
    std::ranges::sort(cells_);
}
NearIndex::Cell NearIndex::cell(Point p) const {
    // Coordinates in metres on a canvas: far below the 9e18 cells of an integer, but a wild one must not be
    // undefined.
    const auto index = [&](double v) {
        return static_cast<long long>(std::clamp(std::floor(v / tolerance_), -4e18, 4e18));
    };
    return {index(p.x), index(p.y), nobody};
}
std::vector<NearIndex::Cell>::const_iterator NearIndex::lower(const Cell& wanted) const {
    return std::ranges::lower_bound(cells_, wanted);
}

void join_lines(std::vector<Element>& elements, double tolerance, DrawingCounts& counts) {
    // A ring is a ring, whatever touches it where it closes.
    close_rings(elements, tolerance);
    // Then what truly meets: a curve made of many short pieces has more than two ends within the wide
    // tolerance everywhere.
    join_within(elements, std::min(rounding, tolerance > 0 ? tolerance : rounding), counts);
    if (tolerance > rounding) join_within(elements, tolerance, counts);
}

}  // namespace strandline::drawing_parts
