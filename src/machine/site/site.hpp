#pragma once
// Where on earth the canvas lies: canvas <-> metres east and north of a place <-> latitude and longitude
// (WGS 84), and the fit of the canvas to flags that were measured on the ground.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline {

/// Degrees on the ellipsoid of WGS 84.
struct Geographic {
    double latitude = 0, longitude = 0;
    bool operator==(const Geographic&) const = default;
};

/// The canvas on the ground. Local metres count east (x) and north (y) from `place`, on the plane that
/// touches the ground there; a robot's own map may be such metres as well.
struct Site {
    Geographic place;
    double altitude = 0;  ///< metres of the ground above the ellipsoid (not above the sea)
    double x = 0, y = 0;  ///< local metres of the canvas's lower left corner
    double heading = 0;   ///< radians from true north, clockwise: where the canvas's y axis looks
    bool operator==(const Site&) const = default;
};

/// Canvas -> local metres, and back. Exact.
Point to_local(const Site& site, Point canvas);
Point from_local(const Site& site, Point local);
/// A heading on the canvas (from x, counter-clockwise) as one of the local metres (from east).
double local_heading(const Site& site, double canvas_heading);
/// Canvas -> latitude and longitude, by the Cartesian system that stands on the ellipsoid at `place`
/// (GeographicLib::LocalCartesian; Karney 2011, arXiv:1102.1215). There and back is exact to nanometres; what
/// the plane misses of the ground's curve is 4 um at 1 km, 0.5 mm at 5 km. 1 us.
Geographic to_geographic(const Site& site, Point canvas);
/// What lies above or below the plane is projected on it. A place at the other end of the earth gives a point
/// far away.
Point to_canvas(const Site& site, Geographic place);

/// A flag or pole that was measured on the ground.
struct Marker {
    std::string name;
    std::optional<Point> canvas;  ///< where it is on the canvas; absent: that follows from the fit
    std::variant<Geographic, Point> measured;  ///< Point: local metres east and north
    double radius = 0;                         ///< metres, > 0: a pole, to be kept out of
    bool operator==(const Marker&) const = default;
};
/// CSV with a first line of names: name, x, y, latitude, longitude, radius; or east, north for local metres.
/// x, y are lengths on the canvas, empty where unknown; radius is empty or 0 for flags; other columns are
/// passed over. Error: the line, and what is wrong with it.
Outcome<std::vector<Marker>> read_markers(const std::string& csv, const std::string& place);

/// A marker after the fit.
struct PlacedMarker {
    Marker marker;
    Point at;                   ///< where on the canvas it was measured
    std::optional<double> off;  ///< metres from where it should be; absent where that is unknown
};
struct Located {
    Site site;
    std::vector<PlacedMarker> markers;  ///< in the order given
    double rms = 0, largest = 0;        ///< of `off`, metres
    double scale = 1;       ///< how much farther apart the markers were measured than they are on the canvas
    bool mirrored = false;  ///< a mirrored canvas would fit far better: coordinates were swapped
};
/// The rigid motion of the canvas with the least sum of squared distances to the measured markers (Umeyama,
/// IEEE PAMI 1991, in the plane without scale). Geographic markers give a site whose place is the canvas's
/// corner; local ones keep the place and altitude of `base`. Error: fewer than two markers known on both
/// sides, all at one place, geographic and local ones mixed, markers that allow no direction. O(markers).
Outcome<Located> located(const std::vector<Marker>& markers, const Site& base = {});

/// The outline of a pole: corners round its circle, none of it outside.
Polygon pole_outline(Point at, double radius);

}  // namespace strandline
