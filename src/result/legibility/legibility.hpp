#pragma once
// Details of a drawing that are finer than the rake, and the smallest canvas on which all survive.
#include <vector>

#include "input/drawing/drawing.hpp"

namespace strandline::legibility {

/// What cannot be seen in the sand as it was drawn.
struct Detail {
    enum class Kind { narrow, hole, loop, horn, gap } kind;
    int element = -1;
    Point at;
    /// Metres: of the part where it is narrowest, of the hole, of the closed line, of a horn at a third of
    /// its length, from line or outline to line or outline of a gap.
    double width = 0;
    double needed = 0;  ///< metres: a pin; and what grooves take of a closed line's inside and of a gap
    int other = -1;     ///< the element beyond a gap
};
const char* meaning_of(Detail::Kind kind);
struct Report {
    std::vector<Detail> details;  ///< by what they lack, worst first
    /// The drawing would have to be so many times as large: 1 where nothing is lost.
    double factor = 1;
    bool whole = true;  ///< false: so many lines lie so near that not all gaps between them were looked at
};
/// Parts of areas that are narrower than a pin, evenly, for at least a pin, holes of areas, closed lines
/// whose groove covers their inside, horns of areas that are lost for a third of their length, and gaps
/// between elements that lie side by side for at least a pin. Widths of areas are those of their medial axis.
/// O(n log n) of the outlines' edges; gaps besides O(length / pin) times what is near, up to a bound.
Report report(const Drawing& drawing, const Robot& robot);

}  // namespace strandline::legibility
