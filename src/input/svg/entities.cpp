// Entities of the DOCTYPE's internal subset. Illustrator names its namespaces and styles so:
// xmlns="&ns_svg;". pugixml leaves them as they are; we put values into attributes, and refuse what grows
// beyond any honest use before anything is expanded.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "input/svg/markup.hpp"
#include "input/svg/scan.hpp"

namespace strandline::svg {

namespace {

constexpr std::size_t largest_expansion = 100'000;  // characters of one entity with all entities in it
constexpr std::size_t largest_total = 64u << 20;    // characters of all attributes that name one
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

}  // namespace

Outcome<void> expand_entities(Markup& markup) {
    const auto doctype = [&] {
        for (const auto node : markup.tree.children())
            if (node.type() == pugi::node_doctype) return node;
        return pugi::xml_node{};
    }();
    auto entities = definitions(doctype.value());
    if (entities.empty()) return {};
    const auto place = fmt::format("line {}, <!DOCTYPE>", spot_of(markup, doctype).line);
    const auto bomb = [&](std::string_view what) {
        return fail(place, std::string(what), "an entity bomb? remove the DOCTYPE from the file");
    };
    for (auto& [name, entity] : entities)
        if (!measure(entity, entities, 0))
            return bomb(fmt::format("the entity &{}; grows beyond {} characters or names itself",
                                    clipped(name), largest_expansion));
    for (const auto& [name, entity] : entities)
        if (entity.value.find('<') != std::string_view::npos) {
            markup.warnings.push_back(
                {place, "entities that hold elements are not put in: what they draw is left out"});
            break;
        }
    std::size_t total = 0;
    std::string value;
    for (auto node = markup.tree.document_element(); node;) {
        for (auto attribute : node.attributes()) {
            const std::string_view raw = attribute.value();
            if (raw.find('&') == std::string_view::npos) continue;
            value.clear();
            std::size_t size = 0;
            each_part(
                raw, entities, [&](std::string_view piece) { size += piece.size(); },
                [&](std::string_view, Entity& inner) { size += *inner.size + reference_cost; });
            total += size;
            if (total > largest_total)
                return bomb(fmt::format("entities grow the file beyond {} characters", largest_total));
            expand(raw, entities, value);
            attribute.set_value(value.c_str());
        }
        if (const auto child = node.first_child()) {  // next in document order, without recursion
            node = child;
            continue;
        }
        while (node && !node.next_sibling()) node = node.parent();
        if (node) node = node.next_sibling();
    }
    return {};
}

}  // namespace strandline::svg
