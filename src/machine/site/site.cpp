#include "machine/site/site.hpp"

#include <GeographicLib/LocalCartesian.hpp>

namespace strandline {
namespace {

GeographicLib::LocalCartesian plane_of(const Site& site) {
    return {site.place.latitude, site.place.longitude, site.altitude};
}

}  // namespace

Point to_local(const Site& site, Point canvas) {
    const Point across = unit(-site.heading), up = left_normal(across);
    return Point{site.x, site.y} + canvas.x * across + canvas.y * up;
}

Point from_local(const Site& site, Point local) {
    const Point across = unit(-site.heading), up = left_normal(across);
    const Point from_corner = local - Point{site.x, site.y};
    return {dot(from_corner, across), dot(from_corner, up)};
}

double local_heading(const Site& site, double canvas_heading) {
    return wrap_angle(canvas_heading - site.heading);
}

Geographic to_geographic(const Site& site, Point canvas) {
    const auto plane = plane_of(site);
    const Point local = to_local(site, canvas);
    // The plane rises above the ground with the distance: a point straight below it is meant, so the height
    // found is taken off until none is left. Each pass gains five digits.
    Geographic found;
    double z = 0;
    for (int pass = 0; pass < 3; ++pass) {
        double height = 0;
        plane.Reverse(local.x, local.y, z, found.latitude, found.longitude, height);
        z -= height - site.altitude;
    }
    return found;
}

Point to_canvas(const Site& site, Geographic place) {
    double x = 0, y = 0, z = 0;
    plane_of(site).Forward(place.latitude, place.longitude, site.altitude, x, y, z);
    return from_local(site, {x, y});
}

Polygon pole_outline(Point at, double radius) {
    constexpr int corners = 16;  // 2 % beyond the circle
    const double reach = radius / std::cos(pi / corners);
    Polygon outline;
    for (int k = 0; k < corners; ++k) outline.push_back(at + reach * unit(2 * pi * k / corners));
    return outline;
}

}  // namespace strandline
