#pragma once
// Private to the room: what may be seen of shapes, and cutting them to it. Root user units.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "math/curve/curve.hpp"
#include "math/region/region.hpp"

namespace strandline::svg {

/// Curves are flattened to this share of the diagonal of what is cut, and of the clip's own box: a 100,000th,
/// so 0.1 mm of a drawing of 10 m.
inline constexpr double clip_tolerance = 1e-5;

/// An area, and the same a tolerance larger for lines, so that those along its outline are in it.
struct Clip {
    Regions regions;
    AreaIndex index;
    std::optional<AreaIndex> for_lines = {};  ///< made when first asked
};
std::shared_ptr<Clip> make_clip(Regions regions);
/// What both leave; `a` may be absent (all).
std::shared_ptr<Clip> both(const std::shared_ptr<Clip>& a, const std::shared_ptr<Clip>& b);

/// clipPath elements are worked out once for each place they are used at.
struct ClipKey {
    std::size_t node = 0;
    std::array<double, 10> map_and_box{};
    auto operator<=>(const ClipKey&) const = default;
};

/// The closed outlines of what is left of an area; empty when nothing is.
std::vector<Path> clipped_area(const std::vector<Path>& outline, strandline::FillRule rule, const Clip& clip);
/// The pieces of the paths that may be seen, exact.
std::vector<Path> clipped_lines(const std::vector<Path>& lines, Clip& clip);
Box bounds_of(const std::vector<Path>& paths);
/// As closed chains; open paths are closed, as filling does.
void append_polygons(const std::vector<Path>& paths, std::vector<Polygon>& polygons);

}  // namespace strandline::svg
