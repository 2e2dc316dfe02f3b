#pragma once
// What a plan file must hold together besides having the right keys: no index points at nothing.
#include <optional>
#include <string>

#include "plan/model/model.hpp"

namespace strandline::formats {

/// The first thing wrong, by the JSON pointer of its place in a plan file.
struct Flaw {
    std::string pointer, reason;
};
/// Indices in range, one entry a stroke, a robot within the ranges of its profile. Whether the plan can be
/// driven is for `check` to say. O(plan).
std::optional<Flaw> first_flaw(const Plan& plan);

}  // namespace strandline::formats
