#pragma once
// The table of what a plan can be exported to: `export` writes by it, `formats` lists it, the editor and the
// Python module offer it.
#include <string>
#include <vector>

#include "result/exports/exports.hpp"

namespace strandline::cli {

/// Those of result/exports, and pictures where the program was built with them.
const std::vector<exports::Format>& export_formats();

/// Settings files first, then texts key=value, both over the plan's own options.
Outcome<void> set_options(Options& options, const std::vector<std::string>& configs,
                          const std::vector<std::string>& settings);
/// One file as `output`; a pair NAME.txt as NAME_robot.txt and NAME_rake.txt. All or none; their names.
Outcome<std::vector<std::string>> write_files(const std::vector<exports::File>& files,
                                              const std::string& output);

}  // namespace strandline::cli
