#pragma once
// Plans in parts: what plan --split and split share.
#include <string>

#include "plan/parts/parts.hpp"

namespace strandline::cli {

/// "30min", "90s" or "1h": a time; "200m": metres. Error: neither.
Outcome<parts::Limit> read_limit(const std::string& text, const std::string& place);
/// NAME.json gives NAME-1.json, NAME-2.json ...: all or none.
Outcome<void> write_parts(const Plan& plan, const parts::Limit& limit, const std::string& output, bool quiet);

}  // namespace strandline::cli
