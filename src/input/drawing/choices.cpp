// Which shapes are drawn, and what is asked for each: layers, rules, hints in the file.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

constexpr char left_out = '%', pause = '!';
constexpr std::string_view keep_out_layer = "keep-out";

std::string hex(svg::Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

}  // namespace

bool is_left_out(std::string_view layer) { return layer.starts_with(left_out); }

bool matches(std::string_view pattern, std::string_view text) {
    // Greedy, with one place to come back to: the last star.
    std::size_t p = 0, t = 0, star = std::string_view::npos, from = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            from = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++from;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

Choices::Choices(const svg::Document& document, const DrawingOptions& options)
    : document_(document), options_(options) {
    if (options.tools == DrawingOptions::Tools::asked) return;
    for (const svg::Shape& shape : document.shapes)
        if (chosen(shape) && fence_of(shape).empty() &&
            std::ranges::find(tool_keys_, tool_key(shape)) == tool_keys_.end())
            tool_keys_.push_back(tool_key(shape));
}

std::string Choices::tool_key(const svg::Shape& shape) const {
    if (options_.tools == DrawingOptions::Tools::by_layer) return shape.layer;
    const auto seen = [](const std::optional<svg::Paint>& paint) { return paint && paint->opacity > 0; };
    return seen(shape.stroke) ? hex(shape.stroke->colour) : seen(shape.fill) ? hex(shape.fill->colour) : "";
}

std::vector<std::string> Choices::layers_of(const svg::Shape& shape) const {
    std::vector<std::string> names;
    for (int i = shape.layer_index; i >= 0; i = document_.layers[static_cast<std::size_t>(i)].parent)
        names.push_back(document_.layers[static_cast<std::size_t>(i)].name);
    return names;
}

bool Choices::chosen(const svg::Shape& shape) const {
    const std::vector<std::string> names = layers_of(shape);
    if (std::ranges::any_of(names, is_left_out)) return false;
    if (options_.layers.empty()) return true;
    return std::ranges::any_of(options_.layers, [&](const std::string& wanted) {
        return std::ranges::any_of(names, [&](const std::string& name) { return matches(wanted, name); });
    });
}

std::string Choices::fence_of(const svg::Shape& shape) const {
    const std::vector<std::string> names = layers_of(shape);
    if (std::ranges::any_of(names, is_left_out)) return {};
    const std::vector<svg::Hint> hints = hints_of(shape);
    if (const std::string* asked = value_of(hints, "field")) return *asked;
    return std::ranges::find(names, keep_out_layer) != names.end() ? "keep-out" : "";
}

bool Choices::applies(const InkRule& rule, const svg::Shape& shape) const {
    const auto has = [&](std::string_view text) { return matches(rule.pattern, text); };
    const auto painted = [&](const std::optional<svg::Paint>& paint) {
        return paint && paint->opacity > 0 && has(hex(paint->colour));
    };
    switch (rule.of) {
        case InkRule::Of::layer:
            return std::ranges::any_of(layers_of(shape), has);
        case InkRule::Of::colour:
            return painted(shape.fill) || painted(shape.stroke);
        case InkRule::Of::id:
            return has(shape.id);
    }
    return false;
}

std::vector<svg::Hint> Choices::hints_of(const svg::Shape& shape) const {
    std::map<std::string, std::string> asked;
    const std::vector<std::string> names = layers_of(shape);
    for (const InkRule& rule : options_.rules) {
        if (applies(rule, shape))
            for (const svg::Hint& hint : rule.hints) asked[hint.name] = hint.value;
    }
    std::map<std::string, std::string> own;
    for (const svg::Hint& hint : shape.hints)
        own.emplace(hint.name, hint.value);  // the innermost comes first
    for (const auto& [name, value] : own) asked[name] = value;
    for (const std::string& name : names)
        if (name.starts_with(pause)) asked["pause"] = name;
    if (const auto own_tool = std::ranges::find(tool_keys_, tool_key(shape)); own_tool != tool_keys_.end())
        asked.emplace("tool", std::to_string(own_tool - tool_keys_.begin() + 1));
    std::vector<svg::Hint> hints;
    for (const auto& [name, value] : asked) hints.push_back({name, value});
    return hints;
}

}  // namespace strandline::drawing_parts
