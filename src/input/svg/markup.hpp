#pragma once
// Private to the room: bytes -> XML tree with places. The only header here that includes pugixml.
#include <cstddef>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/svg/svg.hpp"

namespace strandline::svg {

/// A parsed file. `text` is the buffer that the tree points into: the Markup may be moved, never copied.
struct Markup {
    std::string text;  ///< UTF-8, changed by the parser in place
    std::vector<std::size_t> line_starts;
    pugi::xml_document tree;
    Warnings warnings;
    bool by_illustrator = false;  ///< its opening comment names Adobe Illustrator
};

/// UTF-8 (with or without mark), UTF-16, UTF-32 and Latin-1 by mark, pattern or declaration; what is not
/// valid UTF-8 is read as Latin-1 with a warning. Internal entities are put in.
/// Errors: see svg::read.
Outcome<std::unique_ptr<Markup>> parse_markup(std::string_view bytes, const Limits& limits);

struct Spot {
    int line = 1, column = 1;  ///< 1-based; columns count bytes
};
Spot spot_of(const Markup& markup, pugi::xml_node node);
/// "line 12, <path> #eye".
std::string place_of(const Markup& markup, pugi::xml_node node);
/// The same text, or, where it is not UTF-8 (a character reference to half a surrogate), each byte as a
/// character.
std::string well_formed(std::string_view text);
/// At most `longest` bytes of it, cut between characters; well formed.
std::string clipped(std::string_view text, std::size_t longest = 60);
/// What follows the prefix: "path" of "svg:path".
std::string_view local_name(std::string_view name);
/// Puts the values of the DOCTYPE's own entities where the text behind it names them; lines are kept. Error:
/// an entity bomb.
Outcome<void> expand_entities(std::string& text);

}  // namespace strandline::svg
