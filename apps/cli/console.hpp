#pragma once
// Files, messages and progress for every command: the only place of the program that reads or writes them.
#include <string>
#include <string_view>

#include "base/outcome/outcome.hpp"

namespace strandline::cli {

/// The whole of a file; "-" is stdin.
Outcome<std::string> read_input(const std::string& path);
/// Written under a temporary name beside it, then renamed, so that nothing half-written is left; "-" is
/// stdout.
Outcome<void> write_output(const std::string& path, std::string_view bytes);
/// "strandline: place: reason; remedy" on stderr.
void complain(const Error& error);
void warn(const Warnings& warnings, bool quiet);
/// Draws a progress bar on stderr when that is a terminal; stops on Ctrl-C (first time: the best so far;
/// second time: at once).
Progress console_progress(bool quiet);

}  // namespace strandline::cli
