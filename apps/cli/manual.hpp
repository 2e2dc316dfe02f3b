#pragma once
// What can be written on the command line, as data, and the pages made from it: one source for --help, the
// man page, docs/commands.md and completion.
#include <functional>
#include <string>
#include <vector>

#include "commands.hpp"

namespace CLI {
class App;
}

namespace strandline::cli {

struct OptionText {
    std::vector<std::string> names;  ///< "-o", "--output"; none for a positional one
    std::string label;               ///< of a positional one: "input"
    std::string value;               ///< "TEXT", "NUMBER", "left|centre|right"; "" for flags
    std::string range;               ///< "0 to 1000", "above 0"; "" for others
    std::string fallback;            ///< what holds when it is not given; "" where what says it
    std::string what;
    std::vector<std::string> choices;  ///< that complete it, as far as they are known here
    bool required = false, repeated = false, optional_value = false;
};
struct CommandText {
    std::string name, what;
    std::string footer;  ///< prose, and examples on indented lines
    std::vector<OptionText> options;
};
struct ProgramText {
    std::string what, footer;
    std::vector<OptionText> options;  ///< of every command
    std::vector<CommandText> commands;
};
ProgramText program_text(const CLI::App& app);

/// "-o, --output TEXT", "input ...": how an option is written, without markup.
std::string written(const OptionText& option);
/// "left, centre or right (default: left)": all that is said of an option.
std::string told(const OptionText& option);

/// roff with the macros of man(7).
std::string man_page(const ProgramText& program);
/// The page docs/commands.md.
std::string commands_page(const ProgramText& program);
/// A script for bash: commands, options, choices, robots, formats, settings and their choices; else files.
std::string bash_completion(const ProgramText& program);

/// The command `manual`, which prints them.
void add_manual(CLI::App& app, std::string& kind, std::function<int()>& chosen);

}  // namespace strandline::cli
