#pragma once
// Projects and changes <-> JSON text: the project file (docs/editor.md) and the body of an edit.
#include <string>
#include <string_view>

#include "project.hpp"

namespace strandline::serve {

std::string write_project(const Project& project);
/// Error: not a project, another version, a step that cannot be taken; with its place in the file.
Outcome<Project> read_project(std::string_view text, const std::string& place);

/// What a client asks for: {"revision", "what", "changes": [...]}.
struct Asked {
    long long revision = 0;
    Step step;
};
/// Error: not JSON, a change that is none. `place` names the text in errors.
Outcome<Asked> read_asked(std::string_view text, const std::string& place);

}  // namespace strandline::serve
