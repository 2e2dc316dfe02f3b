#pragma once
// The table of what a plan can be exported to: `export` writes by it, `formats` lists it, the editor offers
// it.
#include <vector>

#include "result/exports/exports.hpp"

namespace strandline::cli {

/// Those of result/exports, and pictures where the program was built with them.
const std::vector<exports::Format>& export_formats();

}  // namespace strandline::cli
