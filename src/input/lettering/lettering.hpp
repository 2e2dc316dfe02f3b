#pragma once
// Text -> single lines, as a plotter writes: the Hershey fonts. A font is a text of glyphs (JHF) that the
// caller has read; what comes out is a drawing of open lines in millimetres, y down.
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/svg/svg.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline::lettering {

/// Font units, y DOWN. The glyph stands between `left` and `right`: its width is right - left.
struct Glyph {
    double left = 0, right = 0;
    std::vector<Polyline> strokes;  ///< each of at least two points, no two neighbours equal; none: a space
};

/// glyphs[i] stands for character 32 + i. cap_line < base_line: the medians of the tops and of the bottoms of
/// the glyphs at A to Z.
struct Font {
    std::string name;
    std::vector<Glyph> glyphs;
    double cap_line = 0, base_line = 0;
};

/// JHF, James Hurt's form of Hershey's data: a glyph is its number (5 columns), its count of pairs (3
/// columns), its left and right bound, then pairs of letters, each its distance from R; " R" lifts the pen.
/// Glyphs may run over several lines. Error: not JHF (with the line), no glyph at A to Z. O(bytes).
Outcome<Font> read_font(std::string_view jhf, const std::string& name);

enum class Align { left, centre, right };
struct Options {
    double height = 1;          ///< metres from base line to cap line, > 0
    Align align = Align::left;  ///< of the lines, by their widths
    double line_spacing = 1.6;  ///< from base line to base line, in heights
    /// Millimetres: which pins draw it follows from this as in any drawing. 0: 1, or height / 12 when
    /// thinner.
    double stroke_width = 0;
    double letter_spacing = 0;  ///< metres added behind each glyph
};

/// `text` is UTF-8; lines end at a newline. A shape a stroke of a glyph, with the id "t.LINE.COLUMN.GLYPH.N"
/// counted from 1, where GLYPH is the letter or digit itself, else "uHEX". The page is the box of the ink,
/// grown by half the stroke width, at its true size. Coordinates are rounded to a micrometre. Characters that
/// the font does not have are left out and named in one warning. Error: no text, not UTF-8, no glyph that
/// draws, more than 100,000 characters, an option out of range. O(strokes).
Outcome<svg::Document> lettered(std::string_view text, const Font& font, const Options& options);

}  // namespace strandline::lettering
