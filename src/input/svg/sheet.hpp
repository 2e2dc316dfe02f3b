#pragma once
// Private to the room: CSS style sheets -> rules, and which of them an element meets. What of CSS is read is
// listed in docs/svg.md.
#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/svg/notes.hpp"

namespace strandline::svg {

/// The views of declarations and rules point into the document and into `Sheet::texts`.
struct Declaration {
    std::string_view name, value;  ///< the name in lower case
    bool important = false;
};
using Declarations = std::vector<Declaration>;

/// One element of a selector: all that is named must hold.
struct Compound {
    std::string_view type, id;  ///< empty: any
    std::vector<std::string_view> classes;
    bool child = false;  ///< the compound to the left is its parent, not any ancestor
};
struct Rule {
    std::vector<Compound> compounds;  ///< from the element outwards, at least one
    long specificity = 0;
    std::size_t block = 0;
};

struct Sheet {
    std::deque<std::string> texts;
    std::vector<Declarations> blocks;
    std::vector<Rule> rules;  ///< in source order
    /// Rules by what their first compound asks for, the rarest first: id, class, type, or nothing.
    std::map<std::string_view, std::vector<std::size_t>> by_id, by_class, by_type;
    std::vector<std::size_t> others;
    /// Style attributes that had to be copied, by where they stand: an element may be drawn many times.
    std::map<const char*, Declarations> copied_attributes;
    std::size_t steps = 0, most_steps = 0;  ///< comparisons so far, and when to give up: see Limits
};

/// Appends the rules of a <style> element. At-rules and selectors that are not read are noted.
void add_style_element(Sheet& sheet, pugi::xml_node style, Notes& notes);

/// The declarations of a style attribute or a block. Comments are passed over; `texts` takes copies where the
/// text cannot be pointed at as it is.
Declarations read_declarations(std::string_view css, std::deque<std::string>& texts);

/// The declarations that the sheets have for the element, weakest first (specificity, then source order).
/// `found` is filled anew. O(rules that share its id, a class or its name x depth).
void matching_declarations(Sheet& sheet, pugi::xml_node node, std::vector<const Declarations*>& found);

}  // namespace strandline::svg
