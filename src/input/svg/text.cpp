// <text>: its spans with their fonts, and their outlines from whoever can make them.
#include <fmt/format.h>

#include <algorithm>

#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

struct Gathered {
    Walk& walk;
    Text text;
    std::vector<Surroundings> looks;  ///< of each span
    bool after_space = true;          ///< spaces at the start are dropped
};

std::vector<double> lengths_of(Walk& walk, pugi::xml_node node, const char* name, Axis axis,
                               const Surroundings& around) {
    std::vector<double> lengths;
    const std::string_view text = node.attribute(name).value();
    for (std::size_t at = 0; at < text.size();) {
        const auto end = std::min(text.find_first_of(" \t\n\r\f,", at), text.size());
        const auto word = trimmed(text.substr(at, end - at));
        at = end + 1;
        if (word.empty()) continue;
        const auto read = read_length(word, axis, around.viewport, around.style.font_size);
        if (read.state == ValueState::refused) walk.refuse_number(node, name);
        if (read.state != ValueState::good) {
            note(walk.notes, "a length that is not understood: passed over", node,
                 fmt::format("{}=\"{}\"", name, clipped(text)));
            break;
        }
        lengths.push_back(read.value);
    }
    return lengths;
}

/// White space as SVG 2, 11.7 asks: each run one space, none after another, unless it is to be kept.
std::string collapsed(std::string_view raw, bool keep, bool& after_space) {
    std::string text;
    for (const char c : raw) {
        const bool space = is_space(c);
        if (keep || !space || !after_space) text += space ? ' ' : c;
        after_space = space && !keep;
    }
    return text;
}

void add_span(Gathered& gathered, std::string text, TextSpan places, const Surroundings& around) {
    auto& span = gathered.text.spans.emplace_back(std::move(places));
    const auto& style = around.style;
    span.text = std::move(text);
    span.family = well_formed(style.font_family);
    span.size = style.font_size;
    span.weight = style.font_weight;
    span.italic = style.italic;
    span.anchor = style.text_anchor == "middle" ? TextSpan::Anchor::middle
                  : style.text_anchor == "end"  ? TextSpan::Anchor::end
                                                : TextSpan::Anchor::start;
    span.letter_spacing = style.letter_spacing;
    gathered.looks.push_back(around);
}

void gather(Gathered& gathered, pugi::xml_node node, const Surroundings& around, bool keep, int depth) {
    auto& walk = gathered.walk;
    if (depth > walk.options.limits.depth)
        return walk.refuse(node, fmt::format("elements are nested deeper than {}", walk.options.limits.depth),
                           "ungroup the drawing");
    if (const auto space = node.attribute("xml:space")) keep = std::string_view(space.value()) == "preserve";
    TextSpan places;
    places.x = lengths_of(walk, node, "x", Axis::x, around);
    places.y = lengths_of(walk, node, "y", Axis::y, around);
    places.dx = lengths_of(walk, node, "dx", Axis::x, around);
    places.dy = lengths_of(walk, node, "dy", Axis::y, around);
    places.rotate = lengths_of(walk, node, "rotate", Axis::diagonal, around);
    if (!places.x.empty() || !places.y.empty()) gathered.after_space = !keep;
    for (const auto child : node.children()) {
        if (walk.over()) return;
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
            auto text = collapsed(child.value(), keep, gathered.after_space);
            if (!text.empty()) add_span(gathered, std::move(text), std::exchange(places, {}), around);
            continue;
        }
        if (child.type() != pugi::node_element) continue;
        const auto name = local_name(child.name());
        if (name == "textPath" || name == "tref") {
            note(walk.notes, "text along a path or by reference is not supported: left out", child);
            continue;
        }
        if (name != "tspan" && name != "a") continue;
        Surroundings inner = around;
        auto context = walk.style_context(around.viewport);
        inner.style = resolved_style(child, around.style, context);
        if (context.error && !walk.error) walk.error = context.error;
        if (inner.style.displayed) gather(gathered, child, inner, keep, depth + 1);
    }
}

/// One warning a font, so that all that are missing are named.
void say_left_out(Walk& walk, pugi::xml_node node, const Text& text) {
    for (const auto& span : text.spans)
        note_each(walk.notes, "text is left out (turn it into paths)", node,
                  span.family.empty() ? "no font named" : "font " + span.family);
}

}  // namespace

void add_text(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth) {
    Gathered gathered{walk, {}, {}, true};
    gather(gathered, node, around, false, depth);
    auto& text = gathered.text;
    if (walk.over()) return;
    if (!text.spans.empty() && text.spans.back().text.ends_with(' ') && gathered.after_space)
        text.spans.back().text.pop_back();
    if (std::ranges::all_of(text.spans, [](const TextSpan& span) { return trimmed(span.text).empty(); }))
        return note(walk.notes, "a text without letters: draws nothing", node);
    if (walk.collected.purpose != Purpose::box && !around.style.visible) {
        if (walk.collected.purpose == Purpose::shapes)
            note(walk.notes, "hidden (visibility): left out", node);
        return;
    }
    if (!walk.options.text_outlines) walk.collected.unclear = true;
    if (!walk.options.text_outlines) return say_left_out(walk, node, text);
    if (determinant(around.map) == 0)
        return note(walk.notes, "a transform that leaves no area: draws nothing", node);
    text.id = well_formed(node.attribute("id").value());
    text.place = place_of(walk.markup, node);
    const auto outlines = walk.options.text_outlines(text);
    if (!outlines)
        return note_each(walk.notes, "text is left out", node,
                         outlines.error().reason + "; " + outlines.error().remedy);
    for (std::size_t i = 0; i < std::min(outlines->size(), gathered.looks.size()) && !walk.over(); ++i)
        if (!(*outlines)[i].empty())
            add_outline(walk, node, (*outlines)[i], {true, i == 0 ? "" : fmt::format("/{}", i + 1)},
                        gathered.looks[i]);
}

}  // namespace strandline::svg
