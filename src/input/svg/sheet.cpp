// Style sheets: CSS 2.1, chapters 4 and 5, as far as drawing programs write them.
#include "input/svg/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "input/svg/scan.hpp"

namespace strandline::svg {

namespace {

std::string without_comments(std::string_view css) {
    std::string plain;
    while (true) {
        const auto open = css.find("/*");
        plain += css.substr(0, open);
        if (open == std::string_view::npos) return plain;
        const auto close = css.find("*/", open + 2);
        if (close == std::string_view::npos) return plain;
        plain += ' ';
        css.remove_prefix(close + 2);
    }
}

/// The first of `wanted` from `from` on that stands outside quotes and brackets; the end when there is none.
std::size_t find_outside(std::string_view css, std::size_t from, std::string_view wanted) {
    int brackets = 0;
    char quote = 0;
    for (std::size_t i = from; i < css.size(); ++i) {
        const char c = css[i];
        if (quote != 0) {
            if (c == '\\')
                ++i;
            else if (c == quote)
                quote = 0;
        } else if (brackets == 0 && wanted.find(c) != std::string_view::npos) {
            return i;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(' || c == '[') {
            ++brackets;
        } else if (c == ')' || c == ']') {
            brackets = std::max(0, brackets - 1);
        }
    }
    return css.size();
}

/// Behind the `}` that closes the block which `open` begins.
std::size_t block_end(std::string_view css, std::size_t open) {
    int depth = 0;
    for (auto at = open; at < css.size(); at = find_outside(css, at + 1, "{}")) {
        depth += css[at] == '{' ? 1 : -1;
        if (depth == 0) return at + 1;
    }
    return css.size();
}

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
std::string_view take_name(Scanner& scanner) {
    const auto from = scanner.at;
    while (!scanner.done() && is_name_character(scanner.peek())) ++scanner.at;
    return scanner.text.substr(from, scanner.at - from);
}

/// Nothing when it asks for something that is not read: attributes, pseudo-classes, neighbours, escapes.
std::optional<Rule> read_selector(std::string_view text) {
    constexpr long per_id = 1'000'000, per_class = 1'000;  // CSS 2.1, 6.4.3: they do not carry over
    Rule rule;
    Scanner scanner{trimmed(text)};
    bool child = false;
    while (!scanner.done()) {
        Compound compound;
        compound.child = child;
        const auto from = scanner.at;
        if (scanner.peek() == '*') {
            ++scanner.at;
        } else {
            compound.type = take_name(scanner);
            if (!compound.type.empty()) ++rule.specificity;
        }
        while (scanner.peek() == '.' || scanner.peek() == '#') {
            const bool is_id = scanner.text[scanner.at++] == '#';
            const auto name = take_name(scanner);
            if (name.empty() || (is_id && !compound.id.empty() && compound.id != name)) return std::nullopt;
            if (is_id)
                compound.id = name;
            else
                compound.classes.push_back(name);
            rule.specificity += is_id ? per_id : per_class;
        }
        if (scanner.at == from) return std::nullopt;
        rule.compounds.push_back(std::move(compound));
        if (scanner.done()) break;
        if (!is_space(scanner.peek()) && scanner.peek() != '>') return std::nullopt;
        skip_space(scanner);
        child = scanner.peek() == '>';
        if (child) {
            ++scanner.at;
            skip_space(scanner);
            if (scanner.done()) return std::nullopt;
        }
    }
    if (rule.compounds.empty()) return std::nullopt;
    // Each compound says how the one to its right hangs on it; seen from the element it is the other way.
    std::ranges::reverse(rule.compounds);
    return rule;
}

void index_rule(Sheet& sheet, std::size_t i) {
    const auto& first = sheet.rules[i].compounds.front();
    if (!first.id.empty())
        sheet.by_id[first.id].push_back(i);
    else if (!first.classes.empty())
        sheet.by_class[first.classes.front()].push_back(i);
    else if (!first.type.empty())
        sheet.by_type[first.type].push_back(i);
    else
        sheet.others.push_back(i);
}

void note_at_rule(std::string_view name, pugi::xml_node style, Notes& notes) {
    if (name == "charset" || name == "namespace") return;  // change nothing for a drawing
    if (name == "font-face") return note(notes, "@font-face in a style sheet: its font is not taken", style);
    note(notes, "a part of a style sheet that is not read: passed over", style, fmt::format("@{}", name));
}

void read_sheet(Sheet& sheet, std::string_view css, pugi::xml_node style, Notes& notes) {
    for (std::size_t at = 0; at < css.size();) {
        if (is_space(css[at]) || css[at] == '}' || css[at] == ';') {
            ++at;
            continue;
        }
        if (css.substr(at).starts_with("<!--") || css.substr(at).starts_with("-->")) {  // CSS 2.1, 4.4
            at += css[at] == '<' ? 4 : 3;
            continue;
        }
        if (css[at] == '@') {
            Scanner scanner{css, at + 1};
            note_at_rule(lower_case(take_name(scanner)), style, notes);
            const auto end = find_outside(css, scanner.at, "{;");
            at = end < css.size() && css[end] == '{' ? block_end(css, end) : end + 1;
            continue;
        }
        const auto open = find_outside(css, at, "{");
        if (open == css.size())
            return note(notes, "a style sheet that ends within a rule: the rule is passed over", style);
        const auto end = block_end(css, open);
        const auto body = css.substr(open + 1, end - open - (css[end - 1] == '}' ? 2 : 1));
        const auto block = sheet.blocks.size();
        sheet.blocks.push_back(read_declarations(body, sheet.texts));
        const auto selectors = css.substr(at, open - at);
        for (std::size_t from = 0; from <= selectors.size();) {
            const auto comma = find_outside(selectors, from, ",");
            const auto selector = trimmed(selectors.substr(from, comma - from));
            if (auto rule = read_selector(selector)) {
                rule->block = block;
                sheet.rules.push_back(std::move(*rule));
                index_rule(sheet, sheet.rules.size() - 1);
            } else {
                note(notes, "a selector that is not read: its rule is not followed", style, selector);
            }
            from = comma + 1;
        }
        at = end;
    }
}

bool has_class(std::string_view classes, std::string_view wanted) {
    for (std::size_t at = classes.find(wanted); at != std::string_view::npos;
         at = classes.find(wanted, at + 1)) {
        const auto end = at + wanted.size();
        if ((at == 0 || is_space(classes[at - 1])) && (end == classes.size() || is_space(classes[end])))
            return true;
    }
    return false;
}

bool fits(const Compound& compound, pugi::xml_node node) {
    if (!compound.type.empty() && compound.type != local_name(node.name())) return false;
    if (!compound.id.empty() && compound.id != node.attribute("id").value()) return false;
    if (compound.classes.empty()) return true;
    const std::string_view classes = node.attribute("class").value();
    return std::ranges::all_of(compound.classes,
                               [&](std::string_view name) { return has_class(classes, name); });
}

/// Do compounds from `i` on hold, the one before having held at `node`? Of several ancestors that would do
/// the nearest is enough unless a child combinator follows, so only those are tried again.
bool holds_outside(Sheet& sheet, const Rule& rule, std::size_t i, pugi::xml_node node) {
    if (i == rule.compounds.size()) return true;
    const bool child = rule.compounds[i - 1].child;
    const bool retry = i + 1 < rule.compounds.size() &&
                       std::any_of(rule.compounds.begin() + static_cast<long>(i), rule.compounds.end(),
                                   [](const Compound& compound) { return compound.child; });
    for (auto ancestor = node.parent(); ancestor.type() == pugi::node_element; ancestor = ancestor.parent()) {
        if (++sheet.steps > sheet.most_steps) return false;
        if (fits(rule.compounds[i], ancestor)) {
            if (holds_outside(sheet, rule, i + 1, ancestor)) return true;
            if (!retry) return false;
        }
        if (child) return false;
    }
    return false;
}

}  // namespace

Declarations read_declarations(std::string_view css, std::deque<std::string>& texts) {
    if (css.find("/*") != std::string_view::npos) css = texts.emplace_back(without_comments(css));
    Declarations found;
    for (std::size_t from = 0; from < css.size();) {
        const auto end = find_outside(css, from, ";");
        const auto text = css.substr(from, end - from);
        from = end + 1;
        const auto colon = text.find(':');
        if (colon == std::string_view::npos) continue;
        Declaration declaration{trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1)), false};
        if (std::ranges::any_of(declaration.name, [](char c) { return c >= 'A' && c <= 'Z'; }))
            declaration.name = texts.emplace_back(lower_case(declaration.name));
        if (const auto bang = declaration.value.rfind('!');
            bang != std::string_view::npos &&
            lower_case(trimmed(declaration.value.substr(bang + 1))) == "important") {
            declaration.value = trimmed(declaration.value.substr(0, bang));
            declaration.important = true;
        }
        found.push_back(declaration);
    }
    return found;
}

void add_style_element(Sheet& sheet, pugi::xml_node style, Notes& notes) {
    const auto type = lower_case(trimmed(style.attribute("type").value()));
    if (!type.empty() && type != "text/css")
        return note(notes, "a style sheet of another language: not followed", style, type);
    const auto media = lower_case(trimmed(style.attribute("media").value()));
    if (!media.empty() && media != "all" && media != "screen")
        return note(notes, "a style sheet for other media: not followed", style, media);
    std::string text;
    for (const auto child : style.children())
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
    sheet.texts.push_back(without_comments(text));
    read_sheet(sheet, sheet.texts.back(), style, notes);
}

void matching_declarations(Sheet& sheet, pugi::xml_node node, std::vector<const Declarations*>& found) {
    found.clear();
    if (sheet.rules.empty() || sheet.steps > sheet.most_steps) return;
    sheet.steps += std::string_view(node.attribute("class").value()).size() / 16;  // long lists take longer
    std::vector<std::size_t> fitting;
    const auto consider = [&](const std::vector<std::size_t>& rules) {
        for (const auto i : rules) {
            if (++sheet.steps > sheet.most_steps) return;
            const auto& rule = sheet.rules[i];
            if (fits(rule.compounds.front(), node) && holds_outside(sheet, rule, 1, node))
                fitting.push_back(i);
        }
    };
    const auto look_up = [&](const auto& index, std::string_view key) {
        if (const auto known = index.find(key); known != index.end()) consider(known->second);
    };
    consider(sheet.others);
    look_up(sheet.by_type, local_name(node.name()));
    look_up(sheet.by_id, node.attribute("id").value());
    if (!sheet.by_class.empty()) {
        Scanner scanner{node.attribute("class").value()};
        for (skip_space(scanner); !scanner.done(); skip_space(scanner)) {
            const auto from = scanner.at;
            while (!scanner.done() && !is_space(scanner.peek())) ++scanner.at;
            look_up(sheet.by_class, scanner.text.substr(from, scanner.at - from));
        }
    }
    std::ranges::sort(fitting, [&](std::size_t a, std::size_t b) {
        const long sa = sheet.rules[a].specificity, sb = sheet.rules[b].specificity;
        return sa != sb ? sa < sb : a < b;
    });
    fitting.erase(std::unique(fitting.begin(), fitting.end()), fitting.end());  // a class named twice
    for (const auto i : fitting) found.push_back(&sheet.blocks[sheet.rules[i].block]);
}

}  // namespace strandline::svg
