#pragma once
// Private to the room: warnings, one a kind. A file that is wrong in 10,000 places says so once, with the
// first place and the count.
#include <string>
#include <string_view>
#include <vector>

#include "input/svg/markup.hpp"

namespace strandline::svg {

/// `kind` is one of a fixed set of phrases, so there are few notes.
struct Note {
    std::string_view kind;
    std::string place, detail;  ///< of the first
    std::size_t count = 1;
};
struct Notes {
    const Markup& markup;
    std::vector<Note> list;
    bool silent = false;  ///< while something is only measured
};
/// `kind` must outlive the notes (a literal). `detail`, what is particular to the first case, may be empty.
void note(Notes& notes, std::string_view kind, pugi::xml_node node, std::string_view detail = {});
/// As note, but every detail is one of its own, up to 20 of a kind.
void note_each(Notes& notes, std::string_view kind, pugi::xml_node node, std::string_view detail);
/// "kind: detail (17 times, first here)", in the order of their first places.
Warnings as_warnings(const Notes& notes);

}  // namespace strandline::svg
