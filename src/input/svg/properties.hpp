#pragma once
// Private to the room: the properties that change a drawing, one row each.
#include <string_view>

#include "input/svg/style.hpp"

namespace strandline::svg {

/// Where declarations of one element are put.
struct Setter {
    pugi::xml_node node;
    const Style& parent;
    Style& style;
    StyleContext& context;
};
/// Sets one property; one that draws nothing is passed over, a value that is not understood is noted.
void set_property(Setter& setter, std::string_view name, std::string_view value);
/// font-size and the size of the font shorthand: set before all others, whose em refer to it.
bool sets_font_size(std::string_view name);

}  // namespace strandline::svg
