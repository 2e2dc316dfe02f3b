// strandline manual: the command line's description read from what parses it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "manual.hpp"

namespace strandline::cli {
namespace {

std::vector<std::string> split(const std::string& text, const std::string& at) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find(at, begin)) != std::string::npos; begin = end + at.size())
        parts.push_back(text.substr(begin, end - begin));
    parts.push_back(text.substr(begin));
    return parts;
}

/// "on | off: off drives over ..." -> on, off. What is in capitals, or more than a word, is no choice.
std::vector<std::string> choices_told(const std::string& what) {
    std::vector<std::string> parts = split(what, " | ");
    if (parts.size() < 2) return {};
    parts.back() = parts.back().substr(0, parts.back().find(": "));
    std::erase_if(parts, [](const std::string& part) {
        return std::ranges::any_of(part, [](char c) { return c == ' ' || (c >= 'A' && c <= 'Z'); });
    });
    return parts;
}

/// CLI11 writes a type and what is checked as "TEXT:{a,b}", "INT:INT in [1 - 64]", "UINT:NONNEGATIVE".
void read_type(const std::string& type, OptionText& option) {
    const std::size_t colon = type.find(':');
    const std::string kind = type.substr(0, colon),
                      checked = colon == std::string::npos ? "" : type.substr(colon + 1);
    option.value = kind == "TEXT" ? kind : "NUMBER";
    if (checked.starts_with('{')) {
        option.value = checked.substr(1, checked.size() - 2);
        option.choices = split(option.value, ",");
        std::ranges::replace(option.value, ',', '|');
    } else if (const std::size_t open = checked.find('['); open != std::string::npos) {
        const auto ends = split(checked.substr(open + 1, checked.size() - open - 2), " - ");
        option.range = ends.front() + " to " + ends.back();
    } else if (checked == "POSITIVE") {
        option.range = "above 0";
    } else if (checked == "NONNEGATIVE") {
        option.range = "0 or more";
    }
}

OptionText option_text(const CLI::Option& from) {
    OptionText option;
    for (const std::string& name : from.get_snames()) option.names.push_back("-" + name);
    for (const std::string& name : from.get_lnames()) option.names.push_back("--" + name);
    if (from.get_positional()) option.label = from.get_name(true);
    option.what = from.get_description();
    option.required = from.get_required();
    option.repeated = from.get_expected_max() == CLI::detail::expected_max_vector_size;
    option.optional_value = from.get_items_expected_min() == 0 && from.get_items_expected_max() > 0;
    if (from.get_items_expected_max() == 0) return option;
    option.choices = choices_told(option.what);
    read_type(from.get_type_name(), option);
    option.fallback = from.get_default_str();
    return option;
}

std::vector<OptionText> option_texts(const CLI::App& app) {
    std::vector<OptionText> options;
    for (const CLI::Option* option : app.get_options()) options.push_back(option_text(*option));
    std::ranges::stable_partition(options, [](const OptionText& option) { return option.names.empty(); });
    return options;
}

}  // namespace

ProgramText program_text(const CLI::App& app) {
    ProgramText program{app.get_description(), app.get_footer(), option_texts(app), {}};
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        program.commands.push_back(
            {command->get_name(), command->get_description(), command->get_footer(), option_texts(*command)});
    return program;
}

std::string written(const OptionText& option) {
    if (option.names.empty()) return option.label + (option.repeated ? " ..." : "");
    std::string text;
    for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + name;
    if (option.value.empty()) return text;
    return text + (option.optional_value ? " [" + option.value + "]" : " " + option.value);
}

std::string told(const OptionText& option) {
    std::string more;
    const auto add = [&](const std::string& part) { more += (more.empty() ? "" : "; ") + part; };
    if (option.required) add("required");
    if (!option.range.empty()) add(option.range);
    if (!option.fallback.empty()) add("default: " + option.fallback);
    return option.what + (more.empty() ? "" : " (" + more + ")");
}

void add_manual(CLI::App& app, std::string& kind, std::function<int()>& chosen) {
    CLI::App* manual = app.add_subcommand("manual", "prints what --help says of every command, as one page");
    manual->add_option("kind", kind, "man: for man(1); bash: a completion script; markdown: docs/commands.md")
        ->required()
        ->check(CLI::IsMember({"man", "bash", "markdown"}));
    manual->footer(R"(Examples:
  strandline manual man > strandline.1
  source <(strandline manual bash))");
    manual->callback([&] {
        chosen = [&] {
            const ProgramText program = program_text(app);
            fmt::print("{}", kind == "man"    ? man_page(program)
                             : kind == "bash" ? bash_completion(program)
                                              : commands_page(program));
            return done;
        };
    });
}

}  // namespace strandline::cli
