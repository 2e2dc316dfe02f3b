// Entities of the DOCTYPE's internal subset. Illustrator names its namespaces and styles so:
// xmlns="&ns_svg;". pugixml leaves them as they are; we put their values into the text before it is parsed,
// in attributes and between tags (there they may hold elements), and refuse what grows beyond any honest use
// before anything is expanded.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "input/svg/markup.hpp"
#include "input/svg/scan.hpp"

namespace strandline::svg {

namespace {

constexpr std::size_t largest_expansion = 100'000;  // characters of one entity with all entities in it
constexpr std::size_t largest_total = 64u << 20;    // characters that all entities of a file put in
constexpr std::size_t reference_cost = 1;           // so that a bomb of empty entities counts too
constexpr int deepest = 32;                         // entities in entities

struct Entity {
    std::string_view value;
    std::optional<std::size_t> size;  ///< fully expanded
};
using Entities = std::map<std::string_view, Entity>;

bool is_name(std::string_view text) {
    constexpr std::size_t longest = 256;
    if (text.empty() || text.size() > longest) return false;
    for (const char c : text)
        if (is_space(c) || c == '&' || c == '<' || c == '>' || c == '"' || c == '\'' || c == '%')
            return false;
    return true;
}

/// The definitions `<!ENTITY name "value">`; parameter and external entities are passed over.
Entities definitions(std::string_view doctype) {
    Entities found;
    Scanner scanner{doctype, std::min(doctype.find('['), doctype.size())};
    const auto quoted = [&]() -> std::optional<std::string_view> {
        const char quote = scanner.peek();
        if (quote != '"' && quote != '\'') return std::nullopt;
        const auto end = doctype.find(quote, scanner.at + 1);
        if (end == std::string_view::npos) return std::nullopt;
        const auto value = doctype.substr(scanner.at + 1, end - scanner.at - 1);
        scanner.at = end + 1;
        return value;
    };
    while (!scanner.done()) {
        const auto rest = doctype.substr(scanner.at);
        if (rest.starts_with("<!--")) {
            const auto end = rest.find("-->");
            scanner.at = end == std::string_view::npos ? doctype.size() : scanner.at + end + 3;
        } else if (rest.starts_with("<!ENTITY")) {
            scanner.at += 8;
            skip_space(scanner);
            const auto name_at = scanner.at;
            while (!scanner.done() && !is_space(scanner.peek()) && scanner.peek() != '>') ++scanner.at;
            const auto name = doctype.substr(name_at, scanner.at - name_at);
            skip_space(scanner);
            const auto value = quoted();
            if (value && is_name(name))
                found.try_emplace(name, Entity{*value, {}});  // the first definition counts
        } else if (rest.starts_with('"') || rest.starts_with('\'')) {
            if (!quoted()) ++scanner.at;
        } else {
            ++scanner.at;
        }
    }
    return found;
}

/// Calls text(piece) and entity(name, entity) for the parts of a value in their order.
template <class OnText, class OnEntity>
void each_part(std::string_view value, Entities& entities, OnText text, OnEntity entity) {
    std::size_t from = 0;
    while (true) {
        const auto amp = value.find('&', from);
        text(value.substr(from, amp == std::string_view::npos ? amp : amp - from));
        if (amp == std::string_view::npos) return;
        const auto end = value.find_first_of(";& ", amp + 1);
        const auto known = end != std::string_view::npos && value[end] == ';'
                               ? entities.find(value.substr(amp + 1, end - amp - 1))
                               : entities.end();
        if (known == entities.end()) {
            text(value.substr(amp, 1));
            from = amp + 1;
        } else {
            entity(known->first, known->second);
            from = end + 1;
        }
    }
}

/// Fills in Entity::size from the inside out; false when it grows beyond the limit or names itself.
bool measure(Entity& entity, Entities& entities, int depth) {
    if (entity.size) return *entity.size <= largest_expansion;
    if (depth > deepest) return false;
    std::size_t size = 0;
    bool sane = true;
    each_part(
        entity.value, entities, [&](std::string_view piece) { size += piece.size(); },
        [&](std::string_view, Entity& inner) {
            sane = sane && measure(inner, entities, depth + 1);
            if (sane) size += *inner.size + reference_cost;
            if (size > largest_expansion) sane = false;
        });
    if (!sane || size > largest_expansion) return false;
    entity.size = size;
    return true;
}

void expand(std::string_view value, Entities& entities, std::string& out) {
    each_part(
        value, entities, [&](std::string_view piece) { out += piece; },
        [&](std::string_view, Entity& inner) { expand(inner.value, entities, out); });
}

/// Where `end` ends, or the end of the text.
std::size_t behind(std::string_view text, std::string_view end, std::size_t from) {
    const auto at = text.find(end, from);
    return at == std::string_view::npos ? text.size() : at + end.size();
}

/// From "<!DOCTYPE" to behind its '>', quotes, comments and brackets followed; nothing when there is none.
std::string_view doctype_of(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size() && !text.substr(at).starts_with("<!DOCTYPE")) {
        if (is_space(text[at]))
            ++at;
        else if (text.substr(at).starts_with("<?"))
            at = behind(text, "?>", at);
        else if (text.substr(at).starts_with("<!--"))
            at = behind(text, "-->", at);
        else
            return {};
    }
    const auto start = at;
    int brackets = 0;
    while (at < text.size()) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = behind(text, text.substr(at, 1), at + 1);
        } else if (text.substr(at).starts_with("<!--")) {
            at = behind(text, "-->", at);
        } else {
            brackets += c == '[' ? 1 : c == ']' ? -1 : 0;
            ++at;
            if (c == '>' && brackets <= 0) return text.substr(start, at - start);
        }
    }
    return {};
}

/// Lines are kept, so that places stay true; in a tag nothing of the value may end it.
void append_value(std::string_view value, bool in_tag, std::string& out) {
    for (const char c : value) {
        if (c == '\n' || c == '\r')
            out += ' ';
        else if (in_tag && c == '<')
            out += "&lt;";
        else if (in_tag && c == '"')
            out += "&quot;";
        else if (in_tag && c == '\'')
            out += "&apos;";
        else
            out += c;
    }
}

/// The end of what begins at `at`: a comment, CDATA, <?...?>, a tag (`in_tag`), or the text up to the next
/// '<'.
std::size_t piece_end(std::string_view text, std::size_t at, bool& in_tag, bool& literal) {
    const auto rest = text.substr(at);
    in_tag = literal = false;
    if (rest[0] != '<') return std::min(text.find('<', at), text.size());
    literal = true;
    if (rest.starts_with("<!--")) return behind(text, "-->", at);
    if (rest.starts_with("<![CDATA[")) return behind(text, "]]>", at);
    if (rest.starts_with("<?")) return behind(text, "?>", at);
    literal = false;
    in_tag = true;
    while (++at < text.size() && text[at] != '>')
        if (text[at] == '"' || text[at] == '\'') at = behind(text, text.substr(at, 1), at + 1) - 1;
    return std::min(at + 1, text.size());
}

}  // namespace

Outcome<void> expand_entities(std::string& text) {
    const auto doctype = doctype_of(text);
    auto entities = definitions(doctype);
    if (entities.empty()) return {};
    const auto start = static_cast<std::size_t>(doctype.data() - text.data());
    const auto place = fmt::format(
        "line {}, <!DOCTYPE>", 1 + std::count(text.begin(), text.begin() + static_cast<long>(start), '\n'));
    const auto bomb = [&](std::string_view what) {
        return fail(place, std::string(what), "an entity bomb? remove the DOCTYPE from the file");
    };
    for (auto& [name, entity] : entities)
        if (!measure(entity, entities, 0))
            return bomb(fmt::format("the entity &{}; grows beyond {} characters or names itself",
                                    clipped(name), largest_expansion));
    std::size_t total = 0, at = start + doctype.size();
    std::string out = text.substr(0, at), value;
    while (at < text.size() && total <= largest_total) {
        bool in_tag = false, literal = false;
        const auto end = piece_end(text, at, in_tag, literal);
        const auto piece = std::string_view(text).substr(at, end - at);
        at = end;
        if (literal || piece.find('&') == std::string_view::npos) {
            out += piece;
            continue;
        }
        each_part(
            piece, entities, [&](std::string_view plain) { out += plain; },
            [&](std::string_view, Entity& entity) {
                total += *entity.size + reference_cost;
                if (total > largest_total) return;
                value.clear();
                expand(entity.value, entities, value);
                append_value(value, in_tag, out);
            });
    }
    if (total > largest_total)
        return bomb(fmt::format("entities grow the file beyond {} characters", largest_total));
    text = std::move(out);
    return {};
}

}  // namespace strandline::svg
