#pragma once
// Private to the room: what the names of SVG's elements mean to us.
#include <string_view>

namespace strandline::svg {

/// `silent` never draw by themselves, `symbol` only through <use>; `left_out` would draw (or change what is
/// drawn), and we say so.
enum class Kind {
    unknown,
    group,
    nested_svg,
    choice,
    use,
    symbol,
    text,
    path,
    rect,
    circle,
    ellipse,
    line,
    polyline,
    polygon,
    silent,
    left_out
};
struct NamedKind {
    std::string_view name;
    Kind kind;
    std::string_view reason;  ///< for what is left out
};
/// `unknown` when SVG has no such element.
NamedKind kind_named(std::string_view local_name);

}  // namespace strandline::svg
