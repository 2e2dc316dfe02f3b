#pragma once
// The Hershey fonts of this machine, and text lettered in them.
#include <string>
#include <vector>

#include "commands.hpp"
#include "input/lettering/lettering.hpp"

namespace strandline::cli {

struct FontEntry {
    std::string name, what;  ///< `what` is empty for a font that Debian's package does not have
};
/// Those in the folder of hershey-fonts-data, or in $STRANDLINE_FONTS, by name. Error: the folder is not
/// there, or holds none.
Outcome<std::vector<FontEntry>> installed_fonts();
/// One of those, or a .jhf file. Error: it is not there, or is no font.
Outcome<lettering::Font> font_named(const std::string& name);
/// The drawing that the arguments ask for. Error: the font is not there, the text is not understood, a wrong
/// option.
Outcome<svg::Document> lettered(const LetteringArguments& arguments);
/// Whose fault an Error of lettered() is: the call's where its place is an option, else the input's.
Exit fault_of(const Error& error);

}  // namespace strandline::cli
