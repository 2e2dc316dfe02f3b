#pragma once
// Text in the fonts of this machine -> filled outlines, by Pango (fonts, shaping) and HarfBuzz (outlines).
// The result depends on the fonts that are installed: docs/typeset.md.
#include <memory>
#include <string>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/svg/svg.hpp"
#include "math/curve/curve.hpp"

namespace strandline::typeset {

struct Options {
    bool substitutes = true;  ///< false: a text of which a font is absent is an Error
};

struct Outlines {
    std::vector<std::vector<Path>> spans;  ///< of each span of the text; closed, to be filled by nonzero
    /// Fonts that were wanted and those used instead; characters that no font has.
    Warnings warnings;
};

/// Fonts are found once and kept: one Typesetter serves all texts of a drawing. Not for two threads at once.
class Typesetter {
  public:
    Typesetter();
    ~Typesetter();
    Typesetter(Typesetter&&) noexcept;
    Typesetter& operator=(Typesetter&&) noexcept;

    /// Outlines in the text's own user units, y down, the first span's base line at y. Placed as SVG 2, 11.8:
    /// an x or y begins a chunk, which is anchored as a whole; dx, dy shift what follows; rotate turns each
    /// glyph. Error: a span that is not UTF-8 or that may be over 32,000 em long; with substitutes off, a
    /// font that is absent. About 0.1 ms a word, and 50 ms for the first.
    Outcome<Outlines> outlines(const svg::Text& text, const Options& options = {}) const;

  private:
    struct Fonts;
    std::unique_ptr<Fonts> fonts_;
};

}  // namespace strandline::typeset
