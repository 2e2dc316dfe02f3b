// The man page and the page of docs/: prose, tables of options, examples.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "manual.hpp"

namespace strandline::cli {
namespace {

/// Calls `line` for each line of a footer, with whether it is an example (indented).
template <class F>
void each_line(const std::string& footer, F&& line) {
    std::size_t begin = 0;
    while (begin < footer.size()) {
        const std::size_t end = std::min(footer.find('\n', begin), footer.size());
        const std::string text = footer.substr(begin, end - begin);
        const bool example = text.starts_with("  ");
        line(example ? text.substr(2) : text, example);
        begin = end + 1;
    }
}

std::string usage(const CommandText& command) {
    std::string text = "strandline " + command.name;
    for (const OptionText& option : command.options)
        if (option.names.empty())
            text += (option.required ? " " : " [") + written(option) + (option.required ? "" : "]");
        else if (option.required)
            text += " " + option.names.back() + " " + option.value;
    return text + " [options]";
}

/// Text of roff: nothing in it is a command, and hyphens can be copied into a shell.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else if (c == '`')
            out += "\\(ga";
        else if (c == '^')
            out += "\\(ha";
        else if (c == '~')
            out += "\\(ti";
        else
            out += c;
    }
    return out.starts_with('.') ? "\\&" + out : out;
}

std::string roff_options(const std::vector<OptionText>& options) {
    std::string text;
    for (const OptionText& option : options)
        text += fmt::format(".TP\n.B {}\n{}\n", roff(written(option)), roff(told(option)));
    return text;
}

std::string roff_footer(const std::string& footer) {
    std::string text;
    std::optional<bool> before;  // whether the line before was an example
    each_line(footer, [&](const std::string& line, bool example) {
        if (before && *before && !example) text += ".EE\n";
        if (example != before) text += example ? ".PP\n.EX\n" : ".PP\n";
        before = example;
        text += roff(line) + "\n";
    });
    return text + (before && *before ? ".EE\n" : "");
}

/// Text in a table of Markdown.
std::string cell(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '|' || c == '*' || c == '<' || c == '\\' || c == '[') out += '\\';
        out += c;
    }
    return out;
}

std::string table(const std::vector<OptionText>& options) {
    std::string text = "| option | what |\n| --- | --- |\n";
    for (const OptionText& option : options) {
        std::string name;
        for (const char c : written(option)) name += c == '|' ? "\\|" : std::string(1, c);
        text += fmt::format("| `{}` | {} |\n", name, cell(told(option)));
    }
    return text;
}

std::string markdown_footer(const std::string& footer) {
    std::string text;
    std::optional<bool> before;
    each_line(footer, [&](const std::string& line, bool example) {
        if (example != before) text += "\n";
        before = example;
        text += example ? "    " + line + "\n" : cell(line) + "\n";
    });
    return text;
}

}  // namespace

std::string man_page(const ProgramText& program) {
    std::string text = ".TH STRANDLINE 1 \"\" \"strandline " STRANDLINE_VERSION "\" \"User Commands\"\n";
    text += ".SH NAME\nstrandline \\- " + roff(program.what.substr(program.what.find(": ") + 2)) + "\n";
    text += ".SH SYNOPSIS\n.B strandline\n.I command\n[options]\n";
    text += ".SH OPTIONS OF EVERY COMMAND\n" + roff_options(program.options);
    text += ".SH COMMANDS\n";
    for (const CommandText& command : program.commands) {
        text += fmt::format(".SS {}\n.B {}\n.PP\n{}\n", roff(command.name), roff(usage(command)),
                            roff(command.what));
        text += roff_options(command.options) + roff_footer(command.footer);
    }
    return text + ".SH NOTES\n" + roff_footer(program.footer);
}

std::string commands_page(const ProgramText& program) {
    std::string text = "# The command line\n\n" + program.what +
                       ".\n\nThis page is what `strandline manual markdown` prints; "
                       "`strandline COMMAND --help` says the same of one command.\n";
    text += markdown_footer(program.footer);
    text += "\n## Options of every command\n" + table(program.options);
    for (const CommandText& command : program.commands)
        text += fmt::format("\n## {}\n{}\n\n    {}\n\n{}{}", command.name, cell(command.what), usage(command),
                            table(command.options), markdown_footer(command.footer));
    return text;
}

}  // namespace strandline::cli
