#pragma once
// Texts that people write for quantities -> SI numbers. Nothing outside this room parses a unit.
#include <string>
#include <string_view>

#include "base/outcome/outcome.hpp"

namespace strandline {

/// "0.4m", "16cm", "5mm", "3ft", "2in", "1.5" (bare: metres) -> metres. Error.place is `place`.
Outcome<double> parse_length(std::string_view text, const std::string& place);
/// "45deg", "0.5rad", "30" (bare: degrees) -> radians.
Outcome<double> parse_angle(std::string_view text, const std::string& place);
/// "40min", "90s", "1.5h", bare: seconds.
Outcome<double> parse_duration(std::string_view text, const std::string& place);
/// A finite decimal number and nothing else.
Outcome<double> parse_number(std::string_view text, const std::string& place);
/// Shortest text that reads back to the same double.
std::string number_text(double value);

}  // namespace strandline
