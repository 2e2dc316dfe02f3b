#pragma once
// Files, messages and progress for every command: the only place of the program that reads or writes them.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "commands.hpp"

namespace strandline::cli {

/// The whole of a file; "-" is stdin.
Outcome<std::string> read_input(const std::string& path);
/// Written under a temporary name beside it, then renamed, so that nothing half-written is left; links are
/// followed and rights kept.
/// "-" is stdout; devices and pipes are written to as they are.
Outcome<void> write_output(const std::string& path, std::string_view bytes);
/// All of them or none: every file is written whole before the first is put in its place.
Outcome<void> write_outputs(const std::vector<std::pair<std::string, std::string_view>>& files);
/// Whether two names mean one file that exists.
bool same_file(const std::string& a, const std::string& b);
/// "strandline: place: reason; remedy" on stderr. Gives `exit` back: what the command returns.
int complain(const Error& error, Exit exit);
void warn(const Warnings& warnings, bool quiet);
/// A bar on stderr where that is a terminal, else nothing; share 1 wipes it away.
void show_bar(const std::string& what, double share);
/// Draws a progress bar on stderr when that is a terminal; stops on Ctrl-C (first time: the best so far;
/// second time: at once).
Progress console_progress(bool quiet);
/// That stops also when so many seconds of processor time have been used, 0: as it is: of the thread that
/// calls this, or of the whole program where the search has `threads` of its own.
Progress limited(Progress progress, double seconds, int threads = 1);

}  // namespace strandline::cli
