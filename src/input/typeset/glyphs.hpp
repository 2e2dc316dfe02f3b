#pragma once
// Private to the room: one piece of text in one font -> its glyphs' outlines, and what was used for them.
#include <pango/pango.h>

#include <string>
#include <vector>

#include "input/svg/svg.hpp"
#include "math/curve/curve.hpp"

namespace strandline::typeset {

struct Piece {
    std::vector<Path> outlines;         ///< user units, y down, from the origin of the first glyph on
    double advance = 0;                 ///< user units to where the next piece goes on
    std::vector<std::string> families;  ///< used, each once
    std::vector<std::string> missing;   ///< characters without an outline in any font
};

/// `text` without line breaks, in the font of `span`; `families` as Pango takes them.
Piece piece_of(PangoContext* context, const std::string& text, const std::string& families,
               const svg::TextSpan& span);

}  // namespace strandline::typeset
