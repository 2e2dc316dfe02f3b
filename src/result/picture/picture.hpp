#pragma once
// Pictures of a plan by cairo, as bytes. The only room that includes cairo.
#include <string>

#include "base/outcome/outcome.hpp"
#include "plan/model/model.hpp"

namespace strandline::picture {

struct Look {
    int pixels = 1200;   ///< of the longer side
    bool arrows = true;  ///< on connections
    bool legend = true;
};
/// PNG bytes: rake down black at true width, rake up red with arrows, start dot, legend with a metre rule.
Outcome<std::string> png(const Plan& plan, const Look& look = {});

}  // namespace strandline::picture
