// The completion script for bash. It holds all that it knows, so that pressing a key starts no program.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "export_formats.hpp"
#include "machine/robot/robot.hpp"
#include "manual.hpp"
#include "plan/model/model.hpp"

namespace strandline::cli {
namespace {

std::string words(const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, " ")); }

std::vector<std::string> format_names() {
    std::vector<std::string> names;
    for (const exports::Format& format : export_formats()) names.push_back(format.name);
    return names;
}

std::vector<std::string> setting_keys() {
    std::vector<std::string> keys;
    for (const Setting& setting : settings()) keys.push_back(setting.key + "=");
    return keys;
}

/// What an option's value can be completed to; empty: file names.
std::vector<std::string> values_of(const std::string& command, const OptionText& option) {
    const auto is = [&](const char* name) { return std::ranges::count(option.names, name) > 0; };
    if (is("--robot") || (command == "robots" && option.names.empty())) return builtin_robots();
    if (is("--format")) return format_names();
    return option.choices;
}

/// `case` lines: a command and an option of it, and what may follow.
std::string value_cases(const ProgramText& program) {
    std::string text;
    for (const CommandText& command : program.commands)
        for (const OptionText& option : command.options) {
            const auto values = values_of(command.name, option);
            if (values.empty() && option.value.empty()) continue;
            std::string pattern;
            for (const std::string& name : option.names)
                pattern += fmt::format("{}'{} {}'", pattern.empty() ? "" : "|", command.name, name);
            if (std::ranges::count(option.names, "--set") > 0)
                text += fmt::format("    {}) list=$_strandline_settings; compopt -o nospace 2>/dev/null ;;\n",
                                    pattern);
            else if (!option.names.empty())
                text += fmt::format("    {}) list='{}' ;;\n", pattern, words(values));
        }
    return text;
}

/// The first word, and the words that are no options.
std::string command_cases(const ProgramText& program) {
    std::string text;
    for (const CommandText& command : program.commands) {
        std::vector<std::string> options, plain;
        for (const auto* list : {&command.options, &program.options})
            for (const OptionText& option : *list) {
                options.insert(options.end(), option.names.begin(), option.names.end());
                if (!option.names.empty()) continue;
                const auto values = values_of(command.name, option);
                plain.insert(plain.end(), values.begin(), values.end());
            }
        std::ranges::sort(options);
        options.erase(std::unique(options.begin(), options.end()), options.end());
        text +=
            fmt::format("    {}) options='{}' plain='{}' ;;\n", command.name, words(options), words(plain));
    }
    return text;
}

std::string setting_cases() {
    std::string text;
    for (const Setting& setting : settings()) {
        const auto choices =
            setting.kind == Setting::Kind::flag ? std::vector<std::string>{"on", "off"} : setting.choices;
        if (!choices.empty()) text += fmt::format("    {}) list='{}' ;;\n", setting.key, words(choices));
    }
    return text;
}

}  // namespace

std::string bash_completion(const ProgramText& program) {
    std::vector<std::string> commands, common;
    for (const CommandText& command : program.commands) commands.push_back(command.name);
    for (const OptionText& option : program.options)
        common.insert(common.end(), option.names.begin(), option.names.end());
    // Bash takes "=" for a word of its own: --set KEY = VALUE are four.
    constexpr const char* script =
        R"(# Completion of strandline for bash: printed by `strandline manual bash`.
_strandline_settings='@KEYS@'

# What follows "--set KEY=".
_strandline_choices() {
    local list=''
    case $1 in
@SETTINGS@    esac
    COMPREPLY=($(compgen -W "$list" -- "$2"))
}

_strandline() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command='' list='' options='' plain='' k
    COMPREPLY=()
    for ((k = 1; k < COMP_CWORD; ++k)); do
        case ${COMP_WORDS[k]} in -*) ;; *) command=${COMP_WORDS[k]}; break ;; esac
    done
    if [[ -z $command ]]; then
        COMPREPLY=($(compgen -W '@COMMANDS@ @COMMON@' -- "$word"))
        return
    fi
    if [[ $word == = && ${COMP_WORDS[COMP_CWORD-2]} == --set ]]; then
        _strandline_choices "$before" ''
        return
    fi
    if [[ $before == = && ${COMP_WORDS[COMP_CWORD-3]} == --set ]]; then
        _strandline_choices "${COMP_WORDS[COMP_CWORD-2]}" "$word"
        return
    fi
    case "$command $before" in
@VALUES@    *)
        case $command in
@PLAIN@        esac
        case $word in -*) list=$options ;; *) list=$plain ;; esac ;;
    esac
    COMPREPLY=($(compgen -W "$list" -- "$word"))
}
complete -o bashdefault -o default -F _strandline strandline
)";
    const std::pair<std::string, std::string> parts[] = {
        {"@KEYS@", words(setting_keys())},  {"@SETTINGS@", setting_cases()},
        {"@COMMANDS@", words(commands)},    {"@COMMON@", words(common)},
        {"@VALUES@", value_cases(program)}, {"@PLAIN@", command_cases(program)}};
    std::string text = script;
    for (const auto& [mark, part] : parts) text.replace(text.find(mark), mark.size(), part);
    return text;
}

}  // namespace strandline::cli
