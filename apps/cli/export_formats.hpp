#pragma once
// The table of what a plan can be exported to: `export` writes by it, `formats` lists it.
#include <functional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "plan/model/model.hpp"

namespace strandline::cli {

struct ExportFormat {
    std::string name, what;
    /// Empty for the format that is a pair of files.
    std::function<std::string(const Plan&, const ExportArguments&)> write;
};
const std::vector<ExportFormat>& export_formats();

}  // namespace strandline::cli
