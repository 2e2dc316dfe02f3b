#include "input/svg/style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace strandline::svg {

namespace {

enum class Property {
    clip_path,
    color,
    display,
    fill,
    fill_opacity,
    fill_rule,
    filter,
    font,
    font_size,
    marker,
    mask,
    mix_blend_mode,
    opacity,
    stroke,
    stroke_dasharray,
    stroke_linecap,
    stroke_linejoin,
    stroke_opacity,
    stroke_width,
    transform,
    vector_effect,
    visibility,
};
struct NamedProperty {
    std::string_view name;
    Property property;
};
/// Sorted by name.
constexpr std::array properties = std::to_array<NamedProperty>({
    {"clip-path", Property::clip_path},
    {"color", Property::color},
    {"display", Property::display},
    {"fill", Property::fill},
    {"fill-opacity", Property::fill_opacity},
    {"fill-rule", Property::fill_rule},
    {"filter", Property::filter},
    {"font", Property::font},
    {"font-size", Property::font_size},
    {"marker", Property::marker},
    {"marker-end", Property::marker},
    {"marker-mid", Property::marker},
    {"marker-start", Property::marker},
    {"mask", Property::mask},
    {"mix-blend-mode", Property::mix_blend_mode},
    {"opacity", Property::opacity},
    {"stroke", Property::stroke},
    {"stroke-dasharray", Property::stroke_dasharray},
    {"stroke-linecap", Property::stroke_linecap},
    {"stroke-linejoin", Property::stroke_linejoin},
    {"stroke-opacity", Property::stroke_opacity},
    {"stroke-width", Property::stroke_width},
    {"transform", Property::transform},
    {"transform-origin", Property::transform},
    {"vector-effect", Property::vector_effect},
    {"visibility", Property::visibility},
});
static_assert(std::ranges::is_sorted(properties, {}, &NamedProperty::name));

std::optional<Property> property_named(std::string_view name) {
    const auto found = std::ranges::lower_bound(properties, name, {}, &NamedProperty::name);
    if (found == properties.end() || found->name != name) return std::nullopt;
    return found->property;
}

struct Setter {
    pugi::xml_node node;
    const Style& parent;
    Style& style;
    StyleContext& context;

    void misread(std::string_view name, std::string_view value) const {
        note(context.notes, "a style value that is not understood: passed over", node,
             fmt::format("{}: {}", name, clipped(value)));
    }

    std::optional<Brush> brush(std::string_view value) const {
        if (value.starts_with("url(")) {
            const auto close = value.find(')');
            if (close == std::string_view::npos) return std::nullopt;
            auto reference = trimmed(value.substr(4, close - 4));
            if (reference.size() >= 2 && (reference.front() == '"' || reference.front() == '\''))
                reference = trimmed(reference.substr(1, reference.size() - 2));
            if (reference.starts_with('#'))
                if (auto served = served_paint(reference.substr(1), node, context)) return served;
            const auto fallback = trimmed(value.substr(close + 1));
            note(context.notes,
                 fallback.empty() ? "paint that is not in the file: nothing is drawn with it"
                                  : "paint that is not in the file: its fallback is taken",
                 node, value);
            return fallback.empty() || fallback.starts_with("url(") ? Brush{} : brush(fallback);
        }
        if (value == "none") return Brush{};
        if (lower_case(value.substr(0, 12)) == "currentcolor" && value.size() == 12)
            return Brush{Brush::Kind::current, {}};
        if (const auto ink = read_colour(value)) return Brush{Brush::Kind::ink, *ink};
        return std::nullopt;
    }

    /// Sets a length of zero or more; says so when it is not one.
    void length(double& target, std::string_view name, std::string_view value, double font_size) const {
        const auto read = read_length(value, Axis::diagonal, context.viewport, font_size);
        if (read.state == ValueState::refused && !context.error)
            context.error =
                Error{place_of(context.notes.markup, node),
                      fmt::format("{} is not finite or beyond {:g}", name, largest_number), "mend the file"};
        else if (read.state == ValueState::good && read.value >= 0)
            target = read.value;
        else
            misread(name, value);
    }

    template <class Value, std::size_t N>
    void keyword(Value& target, std::string_view name, std::string_view value,
                 const std::array<std::pair<std::string_view, Value>, N>& words) const {
        const auto found = std::ranges::find(words, value, &std::pair<std::string_view, Value>::first);
        if (found == words.end()) return misread(name, value);
        target = found->second;
    }

    void share(double& target, std::string_view name, std::string_view value) const {
        if (const auto read = read_share(value))
            target = *read;
        else
            misread(name, value);
    }

    void paint(Brush& target, std::string_view name, std::string_view value) const {
        if (const auto read = brush(value))
            target = *read;
        else
            misread(name, value);
    }

    /// True when `value` was a keyword that all properties share. `take` copies the property from one style
    /// to another.
    template <class Take>
    bool common_keyword(std::string_view value, bool inherited, Take take) const {
        static const Style initial;
        if (value == "inherit" || (value == "unset" && inherited))
            take(parent);
        else if (value == "initial" || value == "unset")
            take(initial);
        else
            return false;
        return true;
    }

    void unsupported(std::string_view value, std::string_view kind) const {
        if (value != "none" && !value.empty() && value != "inherit" && value != "normal" &&
            value != "initial")
            note(context.notes, kind, node);
    }

    void set(std::string_view name, std::string_view value) const {
        const auto property = property_named(name);
        if (!property) return;
        switch (*property) {
            case Property::fill:
                if (!common_keyword(value, true, [&](const Style& from) { style.fill = from.fill; }))
                    paint(style.fill, name, value);
                break;
            case Property::stroke:
                if (!common_keyword(value, true, [&](const Style& from) { style.stroke = from.stroke; }))
                    paint(style.stroke, name, value);
                break;
            case Property::color:
                if (!common_keyword(value, true, [&](const Style& from) { style.color = from.color; })) {
                    if (const auto ink = read_colour(value))
                        style.color = ink->colour;
                    else if (lower_case(value.substr(0, 20)) != "currentcolor")
                        misread(name, value);
                }
                break;
            case Property::fill_opacity:
                if (!common_keyword(value, true,
                                    [&](const Style& from) { style.fill_opacity = from.fill_opacity; }))
                    share(style.fill_opacity, name, value);
                break;
            case Property::stroke_opacity:
                if (!common_keyword(value, true,
                                    [&](const Style& from) { style.stroke_opacity = from.stroke_opacity; }))
                    share(style.stroke_opacity, name, value);
                break;
            case Property::opacity:
                if (!common_keyword(value, false, [&](const Style& from) { style.opacity = from.opacity; }))
                    share(style.opacity, name, value);
                break;
            case Property::stroke_width:
                if (!common_keyword(value, true,
                                    [&](const Style& from) { style.stroke_width = from.stroke_width; }))
                    length(style.stroke_width, name, value, style.font_size);
                break;
            case Property::font_size:
                font_size(value);
                break;
            case Property::fill_rule:
                if (!common_keyword(value, true,
                                    [&](const Style& from) { style.fill_rule = from.fill_rule; }))
                    keyword(style.fill_rule, name, value,
                            std::to_array<std::pair<std::string_view, FillRule>>(
                                {{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::even_odd}}));
                break;
            case Property::stroke_linecap:
                if (!common_keyword(value, true, [&](const Style& from) { style.cap = from.cap; }))
                    keyword(
                        style.cap, name, value,
                        std::to_array<std::pair<std::string_view, LineCap>>({{"butt", LineCap::butt},
                                                                             {"round", LineCap::round},
                                                                             {"square", LineCap::square}}));
                break;
            case Property::stroke_linejoin:
                if (!common_keyword(value, true, [&](const Style& from) { style.join = from.join; }))
                    keyword(
                        style.join, name, value,
                        std::to_array<std::pair<std::string_view, LineJoin>>({{"miter", LineJoin::miter},
                                                                              {"miter-clip", LineJoin::miter},
                                                                              {"arcs", LineJoin::miter},
                                                                              {"round", LineJoin::round},
                                                                              {"bevel", LineJoin::bevel}}));
                break;
            case Property::visibility:
                if (!common_keyword(value, true, [&](const Style& from) { style.visible = from.visible; }))
                    style.visible = value != "hidden" && value != "collapse";
                break;
            case Property::display:
                style.displayed = value != "none";
                break;
            case Property::vector_effect:
                style.scaling_stroke = value != "non-scaling-stroke";
                break;
            case Property::stroke_dasharray:
                if (value.find_first_of("123456789") != std::string_view::npos)
                    note(context.notes, "stroke-dasharray is not supported yet: drawn solid", node);
                break;
            case Property::clip_path:
                unsupported(value, "clip-path is not supported yet: drawn uncut");
                break;
            case Property::mask:
                unsupported(value, "mask is not supported yet: drawn unmasked");
                break;
            case Property::filter:
                unsupported(value, "filter is not supported: drawn without");
                break;
            case Property::marker:
                unsupported(value, "markers are not supported yet: left out");
                break;
            case Property::mix_blend_mode:
                unsupported(value, "mix-blend-mode is not supported: drawn plainly");
                break;
            case Property::font:
                break;  // sizes in the shorthand matter to text alone
            case Property::transform:
                break;  // geometry: read by the walk
        }
    }

    void font_size(std::string_view value) const {
        if (common_keyword(value, true, [&](const Style& from) { style.font_size = from.font_size; })) return;
        Scanner scanner{value};
        if (!at_number(scanner)) return;  // medium, larger: matter to text alone
        if (value.ends_with('%')) {
            if (const auto number = take_number(scanner); number.state == ValueState::good)
                style.font_size = parent.font_size * std::max(0.0, number.value) / 100;
            return;
        }
        length(style.font_size, "font-size", value, parent.font_size);
    }
};

}  // namespace

std::string without_comments(std::string_view css) {
    std::string plain;
    while (true) {
        const auto open = css.find("/*");
        plain += css.substr(0, open);
        if (open == std::string_view::npos) return plain;
        const auto close = css.find("*/", open + 2);
        if (close == std::string_view::npos) return plain;
        css.remove_prefix(close + 2);
    }
}

std::size_t declaration_end(std::string_view css, std::size_t from) {
    int brackets = 0;
    char quote = 0;
    for (std::size_t i = from; i < css.size(); ++i) {
        const char c = css[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(') {
            ++brackets;
        } else if (c == ')') {
            brackets = std::max(0, brackets - 1);
        } else if (c == ';' && brackets == 0) {
            return i;
        }
    }
    return css.size();
}

Style resolved_style(pugi::xml_node node, const Style& parent, StyleContext& context) {
    Style style = parent;
    style.opacity = 1;
    style.displayed = true;
    style.scaling_stroke = true;
    const Setter setter{node, parent, style, context};
    // First, because widths in em refer to it.
    if (const auto size = node.attribute("font-size")) setter.set("font-size", trimmed(size.value()));
    std::string_view css;
    for (const auto attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        if (name == "style")
            css = attribute.value();
        else if (name != "font-size")
            setter.set(name, trimmed(attribute.value()));
    }
    if (!css.empty())
        each_declaration(css,
                         [&](const std::string& name, std::string_view value) { setter.set(name, value); });
    style.group_opacity = parent.group_opacity * style.opacity;
    return style;
}

}  // namespace strandline::svg
