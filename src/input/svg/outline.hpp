#pragma once
// Private to the room: path data and basic shapes -> subpaths, in the element's own user units.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "input/svg/scan.hpp"
#include "math/curve/curve.hpp"

namespace strandline::svg {

/// `state` malformed: `subpaths` is what stood before the error (SVG 2, 9.5.4), `message` says what and
/// where. refused: a number that is not finite or beyond largest_number.
struct Outline {
    ValueState state = ValueState::good;
    std::vector<Path> subpaths;
    std::string message;
    std::size_t segments = 0;
    bool over_limit = false;  ///< more than max_segments
};

Outline read_path(std::string_view d, std::size_t max_segments);
/// The points attribute of polyline and polygon. An odd number at the end is malformed and dropped.
Outline read_points(std::string_view points, bool closed, std::size_t max_segments);

/// Appends the elliptic arc of SVG 2, 9.3.8 and appendix B.2 to `path`: nothing when the ends are equal, a
/// line when a radius is zero (or 1e-12 of the chord), radii scaled up when they are too small.
void append_arc(Path& path, Point from, double rx, double ry, double degrees, bool large, bool positive,
                Point to);

/// rx, ry already resolved and clamped; zero: square corners.
Path rectangle(double x, double y, double width, double height, double rx, double ry);
/// Four quarter arcs from the point at angle 0, in the sense of growing angles (SVG 2, 10.3 and 10.4).
Path ellipse(Point center, double rx, double ry);

}  // namespace strandline::svg
