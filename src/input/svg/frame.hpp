#pragma once
// Private to the room: what the root and nested <svg> elements set up: page, units, view boxes.
#include <optional>
#include <string_view>

#include "base/outcome/outcome.hpp"
#include "input/svg/notes.hpp"
#include "input/svg/scan.hpp"

namespace strandline::svg {

struct Frame {
    std::optional<Box> view;  ///< viewBox, or 0 0 width height; nothing when the file tells neither
    std::optional<Point> size_metres;
    Viewport viewport{300, 150};  ///< for percentages; CSS's size of a page that has none
    bool percent_known = false;   ///< the viewport is the file's own
    double pixels_per_unit = 1;   ///< of the page as the file would be shown
    Affine map;                   ///< user units made square, where the page stretches them
    bool size_in_px = false;      ///< the physical size rests on px
};
/// viewBox, width and height of the root. What is degenerate counts as absent, with a note. Error: numbers
/// that are not finite or too large.
Outcome<Frame> root_frame(pugi::xml_node root, double dpi, Notes& notes);

/// The viewBox attribute; nothing when absent or degenerate (noted).
Outcome<std::optional<Box>> view_box_of(pugi::xml_node node, Notes& notes);
/// SVG 2, 8.2: the map from `view` to `port` that preserveAspectRatio asks for (default xMidYMid meet).
Affine view_box_map(const Box& view, const Box& port, std::string_view preserve_aspect_ratio);
/// Numbers with spaces or commas between. Error.place is `place`.
Outcome<std::vector<double>> number_list(std::string_view text, const std::string& place,
                                         std::string_view what);

}  // namespace strandline::svg
