#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

constexpr double flattening_share = 0.25;  // of the tolerance within which outlines touch

/// A closed outline with its edges in horizontal bands, so that a point meets few of them.
struct Outline {
    Polygon points;
    Box box;
    double low = 0, band_height = 1;
    std::vector<std::vector<std::size_t>> bands;  ///< edge i: points[i] to the next

    explicit Outline(Polygon polygon) : points(std::move(polygon)), box(bounds(points)) {
        // sqrt(n) bands: even a comb of n tall edges keeps to n^1.5 entries.
        const auto count = static_cast<std::size_t>(std::sqrt(static_cast<double>(points.size()))) + 1;
        low = box.low.y;
        band_height = std::max(box.height() / static_cast<double>(count), std::numeric_limits<double>::min());
        bands.resize(count);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto [first, last] = std::minmax({points[i].y, next(i).y});
            for (std::size_t b = band(first); b <= band(last); ++b) bands[b].push_back(i);
        }
    }
    Point next(std::size_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
    std::size_t band(double y) const {
        return static_cast<std::size_t>(
            std::clamp((y - low) / band_height, 0.0, static_cast<double>(bands.size() - 1)));
    }
};

/// Winding number not zero: one cannot get out without crossing the outline, whatever crossings it has of its
/// own.
bool winds_round(const Outline& outline, Point p) {
    if (!contains(outline.box, p)) return false;
    int winding = 0;
    for (const std::size_t i : outline.bands[outline.band(p.y)]) {
        const Point a = outline.points[i], b = outline.next(i);
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) winding += b.y > a.y ? 1 : -1;
    }
    return winding != 0;
}

bool is_near(const Outline& outline, Point p, double tolerance) {
    for (std::size_t b = outline.band(p.y - tolerance); b <= outline.band(p.y + tolerance); ++b)
        for (const std::size_t i : outline.bands[b])
            if (distance_to_segment(p, outline.points[i], outline.next(i)) <= tolerance) return true;
    return false;
}

/// Where the outline crosses or touches segment ab, as shares.
std::vector<double> meetings(const Outline& outline, Point a, Point b, double tolerance) {
    std::vector<double> shares{0, 1};
    const Point along = b - a;
    const double n = dot(along, along);
    const auto [first, last] = std::minmax({a.y, b.y});
    const Box reach = grown(including(including(Box{}, a), b), tolerance);
    for (std::size_t k = outline.band(first - tolerance); k <= outline.band(last + tolerance); ++k)
        for (const std::size_t i : outline.bands[k]) {
            const Point c = outline.points[i], d = outline.next(i);
            if (!overlaps(reach, including(including(Box{}, c), d))) continue;
            if (const auto hit = crossing(a, b, c, d)) shares.push_back(hit->s);
            if (n > 0 && distance_to_segment(c, a, b) <= tolerance)
                shares.push_back(std::clamp(dot(c - a, along) / n, 0.0, 1.0));
        }
    std::ranges::sort(shares);
    return shares;
}

/// No part of the chain leaves the outline by more than the tolerance.
bool encloses(const Outline& outline, const std::vector<Point>& chain, bool closed, double tolerance) {
    const auto within = [&](Point p) { return winds_round(outline, p) || is_near(outline, p, tolerance); };
    if (!std::ranges::all_of(chain, within)) return false;
    const std::size_t edges = closed ? chain.size() : chain.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
        const Point a = chain[i], b = chain[i + 1 == chain.size() ? 0 : i + 1];
        const std::vector<double> shares = meetings(outline, a, b, tolerance);
        for (std::size_t k = 1; k < shares.size(); ++k)
            if (!within(between(a, b, (shares[k - 1] + shares[k]) / 2))) return false;
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
