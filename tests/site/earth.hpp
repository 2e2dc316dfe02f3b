#pragma once
// Latitude and longitude -> metres by the textbook's formula, without the library that the program uses.
#include <array>
#include <cmath>

#include "machine/site/site.hpp"

namespace strandline::testing {

/// Metres in the Cartesian system of the earth's centre (WGS 84), on the ellipsoid.
inline std::array<double, 3> earth_centred(Geographic at, double height = 0) {
    constexpr double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f);
    const double phi = at.latitude * pi / 180, lambda = at.longitude * pi / 180;
    const double n = a / std::sqrt(1 - e2 * std::sin(phi) * std::sin(phi));
    return {(n + height) * std::cos(phi) * std::cos(lambda), (n + height) * std::cos(phi) * std::sin(lambda),
            (n * (1 - e2) + height) * std::sin(phi)};
}
inline double chord(Geographic a, Geographic b) {
    const auto p = earth_centred(a), q = earth_centred(b);
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                     (p[2] - q[2]) * (p[2] - q[2]));
}
/// Metres east and north of the site's place, turned onto the canvas.
inline Point read_back(const Site& site, Geographic at) {
    const auto o = earth_centred(site.place, site.altitude), p = earth_centred(at, site.altitude);
    const double phi = site.place.latitude * pi / 180, lambda = site.place.longitude * pi / 180;
    const double x = p[0] - o[0], y = p[1] - o[1], z = p[2] - o[2];
    const double east = -std::sin(lambda) * x + std::cos(lambda) * y;
    const double north = -std::sin(phi) * (std::cos(lambda) * x + std::sin(lambda) * y) + std::cos(phi) * z;
    const double c = std::cos(site.heading), s = std::sin(site.heading);
    return {c * (east - site.x) - s * (north - site.y), s * (east - site.x) + c * (north - site.y)};
}

}  // namespace strandline::testing
