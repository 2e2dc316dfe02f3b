#pragma once
// Private to the room: lines as they were drawn, and what a drive of unknown origin draws.
#include "result/fidelity/fidelity.hpp"

namespace strandline::fidelity {

/// Fills the figures of lines: lateral errors from the drive, widths and what is undrawn from the sand.
void measure_lines(const Drawing& drawing, const surface::Drive& drive, const surface::Surface& sand,
                   Report& report);

}  // namespace strandline::fidelity
