#pragma once
// Details of a drawing that are finer than the rake, and the smallest canvas on which all survive.
#include <vector>

#include "input/drawing/drawing.hpp"

namespace strandline::legibility {

/// What cannot be seen in the sand as it was drawn.
struct Detail {
    enum class Kind { narrow, hole, loop } kind;
    int element = -1;
    Point at;
    double width = 0;   ///< metres: of the part where it is narrowest, of the hole, of the closed line
    double needed = 0;  ///< metres: a pin; the groove for a closed line
};
const char* meaning_of(Detail::Kind kind);
struct Report {
    std::vector<Detail> details;  ///< by what they lack, worst first
    /// The drawing would have to be so many times as large: 1 where nothing is lost.
    double factor = 1;
};
/// Parts of areas that are narrower than a pin, evenly, for at least a pin (tips are none), holes of areas,
/// and closed lines whose groove covers their inside. Widths of areas are those of their medial axis. O(n log
/// n) of the outlines' edges.
Report report(const Drawing& drawing, const Robot& robot);

}  // namespace strandline::legibility
