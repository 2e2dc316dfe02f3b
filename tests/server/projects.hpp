#pragma once
// Folders and projects that tests begin with.
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "result/formats/formats.hpp"
#include "server/api.hpp"

namespace strandline::serve {

/// A folder of its own, gone with it.
struct TempFolder {
    std::filesystem::path path;
    TempFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "strandline-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;
    ~TempFolder() { std::filesystem::remove_all(path); }
};

/// A line, a ring and a square that is filled.
inline const std::string small_drawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">
<path id="line" d="M10 10 L90 10" fill="none" stroke="#000" stroke-width="1"/>
<circle id="ring" cx="30" cy="60" r="15" fill="none" stroke="#000" stroke-width="1"/>
<rect id="square" x="60" y="50" width="30" height="30" fill="#000"/></svg>)";

inline Setup small_setup() {
    Setup setup{"strandline test",
                {{"plan", "the plan", "_plan.json", "application/json",
                  [](const Plan& plan) -> Outcome<Exported> {
                      return Exported{formats::write_plan(plan), {}};
                  }}},
                {},
                [](const Lettering&) -> Outcome<svg::Document> { return fail("font", "none here"); }};
    return setup;
}

}  // namespace strandline::serve
