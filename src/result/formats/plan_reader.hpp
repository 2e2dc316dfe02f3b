#pragma once
// Private to this room: a parsed plan file -> the plan.
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "plan/model/model.hpp"
#include "result/formats/plan_check.hpp"

namespace strandline::formats {

/// Fills `plan` from the file's JSON; the first key that is missing, unknown or of the wrong kind otherwise.
std::optional<Flaw> take_apart(const nlohmann::json& json, Plan& plan);
/// The same for a list of edits alone.
std::optional<Flaw> take_apart(const nlohmann::json& json, std::vector<Edit>& edits);

}  // namespace strandline::formats
