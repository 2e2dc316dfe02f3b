#include "path/fill/profiles.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::fill {

Portions portions_of(const Regions& regions, const Bands& bands) {
    Portions all(bands.count);
    const auto ring = [&](const Polygon& polygon) {
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            Point a = polygon[j], b = polygon[i];
            if (a.y == b.y) continue;
            const bool opens = a.y > b.y;  // areas lie left of their outlines
            if (opens) std::swap(a, b);
            const double slope = (b.x - a.x) / (b.y - a.y);
            const auto first = std::floor((a.y - bands.low - bands.height) / bands.pitch);
            const auto last = std::ceil((b.y - bands.low) / bands.pitch);
            for (int k = std::max(0, static_cast<int>(first)); k <= std::min(bands.count - 1.0, last); ++k) {
                const double low = bands.low + k * bands.pitch, high = low + bands.height;
                if (b.y <= low || a.y >= high) continue;
                const Point from = a.y < low ? Point{a.x + slope * (low - a.y), low} : a;
                const Point to = b.y > high ? Point{a.x + slope * (high - a.y), high} : b;
                all[k].push_back({from, to, opens});
            }
        }
    };
    for (const Region& region : regions) {
        ring(region.outer);
        for (const Polygon& hole : region.holes) ring(hole);
    }
    return all;
}

std::vector<Knot> profile_of(const std::vector<Portion>& portions) {
    struct Change {
        double x, slope, step;
    };
    std::vector<Change> changes;
    for (const Portion& p : portions) {
        const double from = std::min(p.a.x, p.b.x), to = std::max(p.a.x, p.b.x);
        const double rise = (p.opens ? 1 : -1) * (p.b.y - p.a.y);
        if (to - from < 1e-9 * (1 + std::abs(to))) {
            changes.push_back({from, 0, rise});
        } else {
            changes.push_back({from, rise / (to - from), 0});
            changes.push_back({to, -rise / (to - from), 0});
        }
    }
    std::ranges::sort(changes, {}, [](const Change& c) { return std::tuple(c.x, c.step, c.slope); });
    std::vector<Knot> knots;
    double height = 0, slope = 0, x = changes.empty() ? 0 : changes.front().x;
    for (const Change& change : changes) {
        if (change.x > x) {
            height += slope * (change.x - x);
            x = change.x;
            knots.push_back({x, height});
        } else if (knots.empty()) {
            knots.push_back({x, height});
        }
        slope += change.slope;
        if (change.step != 0) {
            height += change.step;
            knots.push_back({x, height});
        }
    }
    return knots;
}

std::vector<Interval> above(const std::vector<Knot>& profile, double height) {
    std::vector<Interval> intervals;
    bool open = false;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Knot here = profile[i];
        if ((here.height >= height) == open) continue;
        double x = here.x;
        if (i > 0 && profile[i - 1].x < x) {
            const Knot last = profile[i - 1];
            x = last.x + (height - last.height) / (here.height - last.height) * (here.x - last.x);
        }
        if (open)
            intervals.back().to = x;
        else
            intervals.push_back({x, x});
        open = !open;
    }
    if (open) intervals.back().to = profile.back().x;
    return intervals;
}

double integral(const std::vector<Knot>& profile, double from, double to) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const Knot a = profile[i], b = profile[i + 1];
        const double low = std::max(from, a.x), high = std::min(to, b.x);
        if (high <= low) continue;
        const double mid = a.height + ((low + high) / 2 - a.x) / (b.x - a.x) * (b.height - a.height);
        sum += mid * (high - low);
    }
    return sum;
}
double highest(const std::vector<Knot>& profile, const Interval& within) {
    double most = 0;
    for (const Knot& knot : profile)
        if (knot.x >= within.from && knot.x <= within.to) most = std::max(most, knot.height);
    return most;
}

double slant_at(const std::vector<Portion>& portions, double x, double y, double h) {
    double found[2];
    for (int side : {0, 1}) {
        const double height = y + (side == 0 ? -h : h) / 4;
        double nearest = 1.5 * h;
        found[side] = std::numeric_limits<double>::infinity();
        for (const Portion& p : portions) {
            if (height < p.a.y || height >= p.b.y) continue;
            const double at = p.a.x + (height - p.a.y) / (p.b.y - p.a.y) * (p.b.x - p.a.x);
            if (std::abs(at - x) < nearest) {
                nearest = std::abs(at - x);
                found[side] = at;
            }
        }
        if (!std::isfinite(found[side])) return 0;
    }
    return (found[1] - found[0]) / (h / 2);
}

}  // namespace strandline::fill
