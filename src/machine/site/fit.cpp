// The canvas fitted to markers.
#include <fmt/format.h>

#include <algorithm>

#include "machine/site/site.hpp"

namespace strandline {
namespace {

constexpr double least_spread = 0.01;  // m: markers nearer than this say nothing about a direction

/// A place on the canvas, and where it was measured, in local metres.
struct Pair {
    Point canvas, local;
};

Point mean(const std::vector<Pair>& pairs, Point Pair::*side) {
    Point sum;
    for (const Pair& pair : pairs) sum = sum + pair.*side;
    return (1.0 / static_cast<double>(pairs.size())) * sum;
}

/// Sums over both sides, counted from their means.
struct Moments {
    Point canvas_mean, local_mean;
    double canvas = 0, local = 0;  ///< of squared distances
    double along = 0, across = 0;  ///< of dot and cross products
    double mirrored = 0;           ///< what hypot(along, across) is when the canvas is mirrored
    double turned() const { return std::hypot(along, across); }
};
Moments moments_of(const std::vector<Pair>& pairs) {
    Moments m{mean(pairs, &Pair::canvas), mean(pairs, &Pair::local)};
    Point mirrored;
    for (const Pair& pair : pairs) {
        const Point c = pair.canvas - m.canvas_mean, l = pair.local - m.local_mean;
        m.canvas += dot(c, c);
        m.local += dot(l, l);
        m.along += dot(c, l);
        m.across += cross(c, l);
        mirrored = mirrored + Point{c.x * l.x - c.y * l.y, c.x * l.y + c.y * l.x};
    }
    m.mirrored = length(mirrored);
    return m;
}

/// x, y and heading of the site that puts the canvas on what was measured.
Site turned_onto(const Moments& m, Site site) {
    site.heading = wrap_angle(-std::atan2(m.across, m.along));
    site.x = site.y = 0;
    const Point corner = m.local_mean - to_local(site, m.canvas_mean);
    site.x = corner.x;
    site.y = corner.y;
    return site;
}

Outcome<void> directed(const Moments& m, double count) {
    if (std::sqrt(m.canvas / count) < least_spread)
        return fail("markers", "are all at one place on the canvas", "use two that are far apart");
    if (std::sqrt(m.local / count) < least_spread)
        return fail("markers", "were all measured at one place", "use two that are far apart");
    if (m.turned() < 1e-6 * std::sqrt(m.canvas * m.local))
        return fail("markers", "allow no direction: where they were measured does not go with the canvas",
                    "check that each flag has its own coordinates, x before y, latitude before longitude");
    return {};
}

/// Where a marker was measured, in the site's local metres.
Point local_of(const Site& site, const Marker& marker) {
    if (const Point* local = std::get_if<Point>(&marker.measured)) return *local;
    Site plain = site;
    plain.x = plain.y = plain.heading = 0;
    return to_canvas(plain, std::get<Geographic>(marker.measured));
}

std::vector<Pair> pairs_of(const Site& site, const std::vector<Marker>& markers) {
    std::vector<Pair> pairs;
    for (const Marker& marker : markers)
        if (marker.canvas) pairs.push_back({*marker.canvas, local_of(site, marker)});
    return pairs;
}

}  // namespace

Outcome<Located> located(const std::vector<Marker>& markers, const Site& base) {
    const auto known = std::ranges::count_if(markers, [](const Marker& m) { return m.canvas.has_value(); });
    if (known < 2)
        return fail("markers",
                    fmt::format("{} with a place on the canvas and one on the ground",
                                known == 0 ? "there is none" : "there is only one"),
                    "measure two flags or more, far apart");
    const bool geographic = std::holds_alternative<Geographic>(markers.front().measured);
    for (const Marker& marker : markers)
        if (std::holds_alternative<Geographic>(marker.measured) != geographic)
            return fail("markers", "some are geographic and some in local metres", "measure all one way");

    Located result;
    result.site = base;
    if (geographic) result.site.place = std::get<Geographic>(markers.front().measured);
    Moments m;
    // North turns with the place: the canvas's corner is found from the first marker, then from itself.
    constexpr int passes = 4;
    for (int pass = 0; pass < (geographic ? passes : 1); ++pass) {
        m = moments_of(pairs_of(result.site, markers));
        if (const auto fine = directed(m, static_cast<double>(known)); !fine)
            return tl::unexpected(fine.error());
        result.site = turned_onto(m, result.site);
        if (!geographic) break;
        result.site.place = to_geographic(result.site, {0, 0});
        result.site.x = result.site.y = 0;
    }
    double sum = 0;
    for (const Marker& marker : markers) {
        PlacedMarker placed{marker, from_local(result.site, local_of(result.site, marker)), {}};
        if (marker.canvas) {
            placed.off = distance(placed.at, *marker.canvas);
            sum += *placed.off * *placed.off;
            result.largest = std::max(result.largest, *placed.off);
        }
        result.markers.push_back(std::move(placed));
    }
    result.rms = std::sqrt(sum / static_cast<double>(known));
    result.scale = std::sqrt(m.local / m.canvas);
    // The squares that are left are canvas + local - 2 turned; a mirrored canvas leaves the same with its own
    // sum. Two markers fit both ways.
    const double left = m.canvas + m.local - 2 * m.turned(), other = m.canvas + m.local - 2 * m.mirrored;
    result.mirrored = known > 2 && other < left / 4 && left > 1e-3 * m.canvas;
    return result;
}

}  // namespace strandline
