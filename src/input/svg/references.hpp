#pragma once
// Private to the room: what elements name: url(#id), href="#id".
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "input/svg/markup.hpp"

namespace strandline::svg {

/// The elements of a document by id, sorted; the first of each id. Made when first asked.
struct References {
    const Markup& markup;
    bool indexed = false;
    std::vector<std::pair<std::string_view, pugi::xml_node>> by_id;
};
/// An empty node when the document has no such id.
pugi::xml_node element_of(References& references, std::string_view id);

/// `url(#id) rest`, quoted or not. Nothing when the text is no url().
struct Url {
    std::string_view id;    ///< empty: it points outside the file
    std::string_view rest;  ///< what follows the bracket
};
std::optional<Url> read_url(std::string_view value);
/// The value of href or of a prefixed one such as xlink:href; the plain one wins (SVG 2, 16.1.5).
std::string_view href_of(pugi::xml_node node);

/// The next element or text in document order, without recursion.
pugi::xml_node next_in_document(pugi::xml_node node);

}  // namespace strandline::svg
