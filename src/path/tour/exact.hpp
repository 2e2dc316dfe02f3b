#pragma once
// Proven optimal tours of small problems.
#include <optional>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

/// Pieces at most: sets of them are 64-bit masks, and beyond this the work limit is nearly always met first.
inline constexpr int most_exact_pieces = 40;

/// The optimum, by shortest() of programme.hpp against `upper`, the length of `known` (`known` itself when
/// nothing is shorter), or nothing when `work` legs did not suffice. All rules are kept.
std::optional<std::vector<Visit>> prove(const Model& model, const std::vector<Visit>& known, double upper,
                                        std::uint64_t work, const Progress& progress);

}  // namespace strandline::tour
