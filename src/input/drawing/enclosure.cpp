#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

constexpr double flattening_share = 0.25;  // of the tolerance within which outlines touch

/// A closed outline with its edges in rows, so that a ray meets few of them, and the rows in cells, so that a
/// place does. About sqrt(n) of each: even a comb of n tall edges keeps to n^1.5 entries.
struct Outline {
    using Edges = std::vector<std::size_t>;  ///< edge i: points[i] to the next
    Polygon points;
    Box box;
    std::size_t count = 1;
    Point cell;  ///< size
    std::vector<Edges> rows, cells;

    explicit Outline(Polygon polygon) : points(std::move(polygon)), box(bounds(points)) {
        count = static_cast<std::size_t>(std::sqrt(static_cast<double>(points.size()))) + 1;
        const double least = std::numeric_limits<double>::min();
        cell = {std::max(box.width() / static_cast<double>(count), least),
                std::max(box.height() / static_cast<double>(count), least)};
        rows.resize(count);
        cells.resize(count * count);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto [low, high] = std::minmax({points[i].y, next(i).y});
            for (std::size_t r = row(low); r <= row(high); ++r) rows[r].push_back(i);
            visit_cells(points[i], next(i), 0, [&](std::size_t c) {
                cells[c].push_back(i);
                return true;
            });
        }
    }
    Point next(std::size_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
    std::size_t row(double y) const { return step((y - box.low.y) / cell.y); }
    std::size_t column(double x) const { return step((x - box.low.x) / cell.x); }

    /// visit(cell) for the cells within `margin` of segment ab (and perhaps a few more), until it says false;
    /// says whether it went through.
    template <class Visit>
    bool visit_cells(Point a, Point b, double margin, Visit visit) const {
        if (a.y > b.y) std::swap(a, b);
        const auto x_at = [&](double y) {
            return b.y > a.y ? between(a, b, std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0)).x : a.x;
        };
        const std::size_t first = row(a.y - margin), last = row(b.y + margin);
        for (std::size_t r = first; r <= last; ++r) {
            // The outer rows also stand for what lies beyond the box.
            const double bottom = r == first ? a.y : box.low.y + static_cast<double>(r) * cell.y - margin;
            const double top = r == last ? b.y : box.low.y + static_cast<double>(r + 1) * cell.y + margin;
            auto [left, right] = std::minmax({x_at(bottom), x_at(top)});
            if (a.y == b.y) std::tie(left, right) = std::minmax({a.x, b.x});
            for (std::size_t c = column(left - margin); c <= column(right + margin); ++c)
                if (!visit(r * count + c)) return false;
        }
        return true;
    }

  private:
    std::size_t step(double v) const {
        return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(count - 1)));
    }
};

/// Winding number not zero: one cannot get out without crossing the outline, whatever crossings it has of its
/// own.
bool winds_round(const Outline& outline, Point p) {
    if (!contains(outline.box, p)) return false;
    int winding = 0;
    for (const std::size_t i : outline.rows[outline.row(p.y)]) {
        const Point a = outline.points[i], b = outline.next(i);
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) winding += b.y > a.y ? 1 : -1;
    }
    return winding != 0;
}

bool is_near(const Outline& outline, Point p, double tolerance) {
    return !outline.visit_cells(p, p, tolerance, [&](std::size_t cell) {
        return std::ranges::none_of(outline.cells[cell], [&](std::size_t i) {
            return distance_to_segment(p, outline.points[i], outline.next(i)) <= tolerance;
        });
    });
}

/// Where the outline crosses or touches segment ab, as shares, with both ends.
std::vector<double> meetings(const Outline& outline, Point a, Point b, double tolerance) {
    std::vector<double> shares{0, 1};
    const Point along = b - a;
    const double n = dot(along, along);
    outline.visit_cells(a, b, tolerance, [&](std::size_t cell) {
        for (const std::size_t i : outline.cells[cell]) {
            const Point c = outline.points[i], d = outline.next(i);
            if (const auto hit = crossing(a, b, c, d)) shares.push_back(hit->s);
            if (n > 0 && distance_to_segment(c, a, b) <= tolerance)
                shares.push_back(std::clamp(dot(c - a, along) / n, 0.0, 1.0));
        }
        return true;
    });
    std::ranges::sort(shares);
    return shares;
}

/// No part of the chain leaves the outline by more than the tolerance.
bool encloses(const Outline& outline, const std::vector<Point>& chain, bool closed, double tolerance) {
    const auto within = [&](Point p) { return is_near(outline, p, tolerance) || winds_round(outline, p); };
    if (!within(chain.front())) return false;
    const std::size_t edges = closed ? chain.size() : chain.size() - 1;
    // Where nothing is met, the next point lies where this one does: unless this one is only near, and
    // outside.
    bool certain = !is_near(outline, chain.front(), tolerance);
    for (std::size_t i = 0; i < edges; ++i) {
        const Point a = chain[i], b = chain[i + 1 == chain.size() ? 0 : i + 1];
        const std::vector<double> shares = meetings(outline, a, b, tolerance);
        if (shares.size() == 2 && certain) continue;
        for (std::size_t k = 1; k < shares.size(); ++k) {
            // A short piece between two places on the outline cannot go far.
            const bool tied = k > 1 && k + 1 < shares.size() &&
                              (shares[k] - shares[k - 1]) * distance(a, b) <= 2 * tolerance;
            if (!tied && !within(between(a, b, (shares[k - 1] + shares[k]) / 2))) return false;
        }
        if (!within(b)) return false;
        certain = !is_near(outline, b, tolerance);
    }
    return true;
}

struct Chain {
    std::vector<Point> points;
    bool closed = false;
    Box box;
    double rank = 0;  ///< area, rounded so that equal outlines are equal; 0: encloses nothing
};

/// Six digits: outlines that differ by less are one outline, and the order of the file decides.
double rounded_area(double area) {
    if (!(area > 0)) return 0;
    const double digit = std::pow(10, std::floor(std::log10(area)) - 5);
    return std::round(area / digit) * digit;
}

/// Boxes by width, in powers of two, each class sorted by left side: a box that holds another is found in a
/// window as wide as its class.
class BoxesByWidth {
  public:
    explicit BoxesByWidth(const std::vector<Chain>& chains) {
        for (std::size_t i = 0; i < chains.size(); ++i)
            if (chains[i].rank > 0) classes_[width_class(chains[i].box)].push_back({chains[i].box.low.x, i});
        for (auto& [exponent, boxes] : classes_) std::ranges::sort(boxes);
    }
    template <class Visit>
    void visit_holders(Box box, double tolerance, Visit visit) const {
        for (const auto& [exponent, boxes] : classes_) {
            const double widest = std::ldexp(1.0, exponent);
            if (widest + 2 * tolerance < box.width()) continue;
            const std::pair<double, std::size_t> from{box.high.x - tolerance - widest, 0};
            for (auto at = std::ranges::lower_bound(boxes, from);
                 at != boxes.end() && at->first <= box.low.x + tolerance; ++at)
                visit(at->second);
        }
    }

  private:
    static int width_class(Box box) {
        int exponent = 0;
        std::frexp(std::max(box.width(), std::numeric_limits<double>::min()), &exponent);
        return exponent;  // width < 2^exponent
    }
    std::map<int, std::vector<std::pair<double, std::size_t>>> classes_;
};

Chain chain_of(const Element& element, double tolerance) {
    Chain chain;
    if (const auto* line = std::get_if<LineElement>(&element.what)) {
        chain.points = flattened(line->path, tolerance * flattening_share);
        chain.closed = line->path.closed;
    } else {
        chain.points = std::get<RegionElement>(element.what).region.outer;
        chain.closed = true;
    }
    chain.box = bounds(chain.points);
    if (chain.closed && chain.points.size() >= 3) {
        // The area of the box where an outline crosses itself so that its lobes cancel out.
        const double net = area(chain.points);
        chain.rank = rounded_area(net > 0 ? net : chain.box.width() * chain.box.height());
    }
    return chain;
}

}  // namespace

void find_enclosures(std::vector<Element>& elements, double tolerance) {
    // Where nothing may touch, rounding still does.
    tolerance = std::max(tolerance, 1e-6);
    std::vector<Chain> chains;
    for (const Element& element : elements) chains.push_back(chain_of(element, tolerance));
    std::map<std::size_t, Outline> outlines;  // made when first asked
    const auto outline = [&](std::size_t i) -> const Outline& {
        return outlines.try_emplace(i, chains[i].points).first->second;
    };
    const BoxesByWidth index(chains);

    for (std::size_t i = 0; i < elements.size(); ++i) {
        elements[i].inside = -1;
        std::vector<std::size_t> holders;
        index.visit_holders(chains[i].box, tolerance, [&](std::size_t j) {
            // A total order, so that nobody ends up inside himself: larger first, of equal ones the earlier.
            if (j == i || std::pair(-chains[j].rank, j) > std::pair(-chains[i].rank, i)) return;
            const Box room = grown(chains[j].box, tolerance);
            if (contains(room, chains[i].box.low) && contains(room, chains[i].box.high)) holders.push_back(j);
        });
        std::ranges::sort(holders, [&](std::size_t a, std::size_t b) {
            return std::pair(chains[a].rank, b) < std::pair(chains[b].rank, a);
        });
        for (const std::size_t j : holders)
            if (encloses(outline(j), chains[i].points, chains[i].closed, tolerance)) {
                elements[i].inside = static_cast<int>(j);
                break;
            }
    }
}

}  // namespace strandline::drawing_parts
