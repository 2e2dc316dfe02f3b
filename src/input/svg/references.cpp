#include "input/svg/references.hpp"

#include <algorithm>

#include "input/svg/scan.hpp"

namespace strandline::svg {

pugi::xml_node next_in_document(pugi::xml_node node) {
    if (const auto child = node.first_child()) return child;
    while (node && !node.next_sibling()) node = node.parent();
    return node ? node.next_sibling() : node;
}

pugi::xml_node element_of(References& references, std::string_view id) {
    auto& index = references.by_id;
    using Entry = std::pair<std::string_view, pugi::xml_node>;
    if (!references.indexed) {
        references.indexed = true;
        for (auto node = references.markup.tree.document_element(); node; node = next_in_document(node))
            if (const auto attribute = node.attribute("id")) index.emplace_back(attribute.value(), node);
        std::ranges::stable_sort(index, {}, &Entry::first);
    }
    const auto found = std::ranges::lower_bound(index, id, {}, &Entry::first);
    return found != index.end() && found->first == id ? found->second : pugi::xml_node{};
}

std::optional<Url> read_url(std::string_view value) {
    if (!value.starts_with("url(")) return std::nullopt;
    const auto close = value.find(')');
    if (close == std::string_view::npos) return std::nullopt;
    auto target = trimmed(value.substr(4, close - 4));
    if (target.size() >= 2 && (target.front() == '"' || target.front() == '\''))
        target = trimmed(target.substr(1, target.size() - 2));
    const auto rest = trimmed(value.substr(close + 1));
    return target.starts_with('#') ? Url{target.substr(1), rest} : Url{{}, rest};
}

std::string_view href_of(pugi::xml_node node) {
    if (const auto plain = node.attribute("href")) return trimmed(plain.value());
    for (const auto attribute : node.attributes())
        if (local_name(attribute.name()) == "href") return trimmed(attribute.value());
    return {};
}

}  // namespace strandline::svg
