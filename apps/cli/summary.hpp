#pragma once
// The table a person reads after planning.
#include <string>

#include "plan/model/model.hpp"
#include "result/check/check.hpp"

namespace strandline::cli {

/// Lines of text, each ended: scale, elements, lengths, time, what fell short.
std::string summary(const Plan& plan, const check::Report& report);
/// What no stroke of an area rakes, a line each.
std::string bare_places(const Plan& plan);
/// The check's findings, a line each; "" when there are none.
std::string findings(const check::Report& report, bool all);

}  // namespace strandline::cli
