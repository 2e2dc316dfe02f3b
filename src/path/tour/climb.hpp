#pragma once
// One tour made better by itself: kicks that are kept or taken back.
#include "path/tour/descent.hpp"

namespace strandline::tour {

/// Kicks and repairs at a falling heat: a loss of `heat` mean legs is kept with chance 1/e at first, then
/// less, and none in the last tenth of the span (Kirkpatrick, Gelatt, Vecchi, Science 220, 1983, over kicks).
/// Ends where it is then.
void anneal(Search& search, Descent& descent, Budget& budget, Span span, double heat);
/// Another tour of about the same length: kicks all over, then a wide descent.
void diverge(Search& search, Descent& descent);

}  // namespace strandline::tour
