#include "input/svg/notes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace strandline::svg {

namespace {

constexpr std::size_t detail_length = 120;

}

void note(Notes& notes, std::string_view kind, pugi::xml_node node, std::string_view detail) {
    if (notes.silent) return;
    const auto known = std::ranges::find(notes.list, kind, &Note::kind);
    if (known != notes.list.end())
        ++known->count;
    else
        notes.list.push_back({kind, place_of(notes.markup, node), clipped(detail, detail_length), 1});
}

void note_each(Notes& notes, std::string_view kind, pugi::xml_node node, std::string_view detail) {
    if (notes.silent) return;
    constexpr int most = 20;
    const auto text = clipped(detail, detail_length);
    Note* last = nullptr;
    int same_kind = 0;
    for (auto& known : notes.list) {
        if (known.kind != kind) continue;
        last = &known;
        if (++same_kind; known.detail == text) break;
    }
    if (last != nullptr && (last->detail == text || same_kind >= most))
        ++last->count;
    else
        notes.list.push_back({kind, place_of(notes.markup, node), text, 1});
}

Warnings as_warnings(const Notes& notes) {
    Warnings warnings = notes.markup.warnings;
    for (const auto& [kind, place, detail, count] : notes.list) {
        std::string reason(kind);
        if (!detail.empty()) reason += ": " + detail;
        if (count > 1) reason += fmt::format(" ({} times, first here)", count);
        warnings.push_back({place, std::move(reason)});
    }
    return warnings;
}

}  // namespace strandline::svg
