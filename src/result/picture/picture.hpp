#pragma once
// Pictures of a plan by cairo, as bytes. The only room that includes cairo.
#include <string>

#include "base/outcome/outcome.hpp"
#include "plan/model/model.hpp"
#include "result/shade/shade.hpp"

namespace strandline::picture {

struct Look {
    int pixels = 1200;   ///< of the longer side
    bool arrows = true;  ///< on connections
    bool legend = true;
};
/// PNG bytes: rake down black at true width, rake up red with arrows, start dot, legend with a metre rule.
Outcome<std::string> png(const Plan& plan, const Look& look = {});

/// PDF bytes: the same as lines on one page, to the largest round scale (1:1, 1:2, 1:5, 1:10 ...) at which
/// the page is no longer than A3; the caption names it. Sand has no grains there. Of Look, pixels says
/// nothing.
Outcome<std::string> pdf(const Plan& plan, const Look& look = {});

/// PNG bytes of an image.
Outcome<std::string> image_png(const shade::Image& image);
/// PNG bytes: the sand after a drive, seen from above (shade::sand).
Outcome<std::string> sand_png(const surface::Surface& surface, const shade::View& view);
/// PNG bytes: each flaw in its colour, with the key below (shade::flaws).
Outcome<std::string> flaws_png(const surface::Surface& surface, const shade::View& view);

}  // namespace strandline::picture
