#pragma once
// RFC 4648, section 4.
#include <optional>
#include <string>
#include <string_view>

namespace strandline::serve {

std::string base64_of(std::string_view bytes);
/// Nothing: letters that are none, a wrong length, padding elsewhere than at the end.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace strandline::serve
