#pragma once
// Text, piece by piece, as writers of JSON and of tables want it: no locale, the same bytes everywhere.
#include <concepts>
#include <string>
#include <string_view>

namespace strandline {

/// Text that grows: a plan has some 100,000 numbers, so it is handed on by moving only.
using Text = std::string;

void add(Text& text, std::string_view piece);
/// Shortest digits that read back to the same double; -0.0 keeps its sign; what is not finite becomes null,
/// as JSON has no word for it.
void add_number(Text& text, double value);
void add_number(Text& text, long long value);
/// Quoted and escaped. Bytes that are not UTF-8 become U+FFFD: a file that nothing can read helps nobody.
void add_string(Text& text, std::string_view value);

/// As the text of an XML element or attribute; XML 1.0 has no control characters, so they become blanks.
void add_xml(Text& text, std::string_view value);

/// "0.123000" with that many decimals, 9 at most, zero never negative: "-0.000000" is another text than
/// "0.000000" to a diff.
void add_fixed(Text& text, double value, int decimals);

/// "1 element", "0 elements", "2 elements"; a plural that is not made by an s alone is given: counted(n,
/// "thing is", "things are").
template <std::integral Count>
std::string counted(Count count, const std::string& one, const std::string& many = "") {
    return std::to_string(count) + ' ' + (count == 1 ? one : many.empty() ? one + 's' : many);
}

}  // namespace strandline
