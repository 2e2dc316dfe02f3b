#pragma once
// Proven optimal tours of small problems.
#include <optional>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

/// Pieces at most: sets of them are 64-bit masks, and beyond this the work limit is always met first.
inline constexpr int most_exact_pieces = 40;

/// Dynamic programming over sets (Bellman; Held and Karp, both 1962) in layers: state = (set passed, last
/// option), cut by the bound of bound.hpp against `upper`, the length of `known`. Returns the optimum
/// (`known` itself when nothing is shorter), or nothing when `work` transitions did not suffice. All rules
/// are kept.
std::optional<std::vector<Visit>> prove(const Model& model, const std::vector<Visit>& known, double upper,
                                        std::uint64_t work, const Progress& progress);

}  // namespace strandline::tour
