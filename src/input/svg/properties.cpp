#include "input/svg/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace strandline::svg {

namespace {

using Value = std::string_view;

void misread(Setter& to, Value name, Value value) {
    note(to.context.notes, "a style value that is not understood: passed over", to.node,
         fmt::format("{}: {}", name, clipped(value)));
}

std::optional<Brush> read_brush(Setter& to, Value value) {
    if (const auto url = read_url(value)) {
        if (!url->id.empty())
            if (auto served = served_paint(url->id, to.node, to.context)) return served;
        note(to.context.notes,
             url->rest.empty() ? "paint that is not in the file: nothing is drawn with it"
                               : "paint that is not in the file: its fallback is taken",
             to.node, value);
        return url->rest.empty() || url->rest.starts_with("url(") ? Brush{} : read_brush(to, url->rest);
    }
    if (value == "none") return Brush{};
    if (value == "context-fill") return Brush{Brush::Kind::context_fill, {}};
    if (value == "context-stroke") return Brush{Brush::Kind::context_stroke, {}};
    if (value.size() == 12 && lower_case(value) == "currentcolor") return Brush{Brush::Kind::current, {}};
    if (const auto ink = read_colour(value)) return Brush{Brush::Kind::ink, *ink};
    return std::nullopt;
}

void set_brush(Brush& target, Setter& to, Value name, Value value) {
    if (const auto read = read_brush(to, value))
        target = *read;
    else
        misread(to, name, value);
}

/// Nothing when it is no length (noted) or beyond all numbers (an error).
std::optional<double> length_of(Setter& to, Value name, Value value, double font_size) {
    const auto read = read_length(value, Axis::diagonal, to.context.viewport, font_size);
    if (read.state == ValueState::good) return read.value;
    if (read.state == ValueState::refused && !to.context.error)
        to.context.error =
            Error{place_of(to.context.notes.markup, to.node),
                  fmt::format("{} is not finite or beyond {:g}", name, largest_number), "mend the file"};
    else
        misread(to, name, value);
    return std::nullopt;
}

void set_share(double& target, Setter& to, Value name, Value value) {
    if (const auto read = read_share(value))
        target = *read;
    else
        misread(to, name, value);
}

template <class Word, std::size_t N>
void set_word(Word& target, Setter& to, Value name, Value value,
              const std::array<std::pair<Value, Word>, N>& words) {
    const auto found = std::ranges::find(words, value, &std::pair<Value, Word>::first);
    if (found == words.end()) return misread(to, name, value);
    target = found->second;
}
constexpr auto fill_rules = std::to_array<std::pair<Value, FillRule>>(
    {{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::even_odd}});
constexpr auto caps = std::to_array<std::pair<Value, LineCap>>(
    {{"butt", LineCap::butt}, {"round", LineCap::round}, {"square", LineCap::square}});
constexpr auto joins = std::to_array<std::pair<Value, LineJoin>>({{"miter", LineJoin::miter},
                                                                  {"miter-clip", LineJoin::miter},
                                                                  {"arcs", LineJoin::miter},
                                                                  {"round", LineJoin::round},
                                                                  {"bevel", LineJoin::bevel}});

/// The id that a property names; empty for none.
void set_reference(Value& target, Setter& to, Value name, Value value) {
    const auto url = read_url(value);
    if (!url && value != "none") return misread(to, name, value);
    target = url ? url->id : Value{};
    if (url && url->id.empty())
        note(to.context.notes, "a reference to another file: passed over", to.node,
             fmt::format("{}: {}", name, clipped(value)));
}

/// SVG 2, 13.5.6: numbers of commas or spaces, none below zero, not all zero.
void set_dashes(Setter& to, Value name, Value value) {
    to.style.dashes = nullptr;
    if (value == "none") return;
    std::vector<double> dashes;
    double sum = 0;
    for (std::size_t at = 0; at < value.size();) {
        const auto end = std::min(value.find_first_of(" \t\n\r\f,", at), value.size());
        const auto word = trimmed(value.substr(at, end - at));
        at = end + 1;
        if (word.empty()) continue;
        const auto length = length_of(to, name, word, to.style.font_size);
        if (!length) return;
        if (*length < 0) return misread(to, name, value);
        dashes.push_back(*length);
        sum += *length;
    }
    if (sum > 0) to.style.dashes = std::make_shared<const std::vector<double>>(std::move(dashes));
}

void set_font_size(Setter& to, Value name, Value value) {
    Scanner scanner{value};
    if (value.ends_with('%')) {
        if (const auto number = take_number(scanner); number.state == ValueState::good)
            to.style.font_size = to.parent.font_size * std::max(0.0, number.value) / 100;
        return;
    }
    // CSS 2.1, 15.7: the scale of words
    constexpr auto words = std::to_array<std::pair<Value, double>>({{"xx-small", 9},
                                                                    {"x-small", 10},
                                                                    {"small", 13},
                                                                    {"medium", 16},
                                                                    {"large", 18},
                                                                    {"x-large", 24},
                                                                    {"xx-large", 32}});
    if (value == "larger" || value == "smaller") {
        to.style.font_size = to.parent.font_size * (value == "larger" ? 1.2 : 1 / 1.2);
    } else if (!at_number(scanner)) {
        set_word(to.style.font_size, to, name, value, words);
    } else if (const auto size = length_of(to, name, value, to.parent.font_size); size && *size >= 0) {
        to.style.font_size = *size;
    }
}

void set_font_weight(Setter& to, Value name, Value value) {
    int& weight = to.style.font_weight;
    Scanner scanner{value};
    if (value == "normal")
        weight = 400;
    else if (value == "bold")
        weight = 700;
    else if (value == "bolder")
        weight = to.parent.font_weight < 600 ? 700 : 900;
    else if (value == "lighter")
        weight = to.parent.font_weight < 600 ? 100 : 400;
    else if (const auto number = take_number(scanner);
             number.state == ValueState::good && number.value >= 1 && number.value <= 1000)
        weight = static_cast<int>(number.value);
    else
        misread(to, name, value);
}

void set_letter_spacing(Setter& to, Value name, Value value) {
    if (value == "normal")
        to.style.letter_spacing = 0;
    else if (const auto length = length_of(to, name, value, to.style.font_size))
        to.style.letter_spacing = *length;
}

/// [style | variant | weight | stretch]* size[/line-height] family (CSS 2.1, 15.8).
void set_font(Setter& to, Value name, Value value) {
    Value rest = value;
    to.style.italic = false;
    to.style.font_weight = 400;
    while (!rest.empty()) {
        const auto end = std::min(rest.find_first_of(" \t\n\r"), rest.size());
        const auto word = rest.substr(0, end);
        rest = trimmed(rest.substr(end));
        const bool hundreds = word.size() == 3 && word.ends_with("00");
        if (word == "italic" || word == "oblique") {
            to.style.italic = true;
        } else if (word == "bold" || word == "bolder" || word == "lighter" || hundreds) {
            set_font_weight(to, name, word);
        } else if (word != "normal" && word != "small-caps" && word.find("condensed") == Value::npos &&
                   word.find("expanded") == Value::npos) {
            set_font_size(to, name, word.substr(0, word.find('/')));
            to.style.font_family = rest;
            return;
        }
    }
    misread(to, name, value);
}

void say_unless_none(Setter& to, Value value, Value kind) {
    if (value != "none" && value != "normal" && value != "auto" && !value.empty())
        note(to.context.notes, kind, to.node);
}

struct Property {
    Value name;
    bool inherited;
    void (*take)(Style& to, const Style& from);  ///< for inherit and initial; none: they change nothing
    void (*set)(Setter& to, Value name, Value value);
};

template <auto Field>
void take(Style& to, const Style& from) {
    to.*Field = from.*Field;
}

/// Sorted by name.
constexpr std::array properties = std::to_array<Property>({
    {"clip-path", false, take<&Style::clip_path>,
     [](Setter& to, Value name, Value value) { set_reference(to.style.clip_path, to, name, value); }},
    {"clip-rule", true, take<&Style::clip_rule>,
     [](Setter& to, Value name, Value value) { set_word(to.style.clip_rule, to, name, value, fill_rules); }},
    {"color", true, take<&Style::color>,
     [](Setter& to, Value name, Value value) {
         if (const auto ink = read_colour(value))
             to.style.color = ink->colour;
         else if (lower_case(value) != "currentcolor")
             misread(to, name, value);
     }},
    {"display", false, take<&Style::displayed>,
     [](Setter& to, Value, Value value) { to.style.displayed = value != "none"; }},
    {"fill", true, take<&Style::fill>,
     [](Setter& to, Value name, Value value) { set_brush(to.style.fill, to, name, value); }},
    {"fill-opacity", true, take<&Style::fill_opacity>,
     [](Setter& to, Value name, Value value) { set_share(to.style.fill_opacity, to, name, value); }},
    {"fill-rule", true, take<&Style::fill_rule>,
     [](Setter& to, Value name, Value value) { set_word(to.style.fill_rule, to, name, value, fill_rules); }},
    {"filter", false, nullptr,
     [](Setter& to, Value, Value value) {
         say_unless_none(to, value, "filter is not supported: drawn without");
     }},
    {"font", true, nullptr, set_font},
    {"font-family", true, take<&Style::font_family>,
     [](Setter& to, Value, Value value) { to.style.font_family = value; }},
    {"font-size", true, take<&Style::font_size>, set_font_size},
    {"font-style", true, take<&Style::italic>,
     [](Setter& to, Value, Value value) { to.style.italic = value != "normal"; }},
    {"font-weight", true, take<&Style::font_weight>, set_font_weight},
    {"letter-spacing", true, take<&Style::letter_spacing>, set_letter_spacing},
    {"marker", true, nullptr,
     [](Setter& to, Value name, Value value) {
         set_reference(to.style.marker_start, to, name, value);
         to.style.marker_mid = to.style.marker_end = to.style.marker_start;
     }},
    {"marker-end", true, take<&Style::marker_end>,
     [](Setter& to, Value name, Value value) { set_reference(to.style.marker_end, to, name, value); }},
    {"marker-mid", true, take<&Style::marker_mid>,
     [](Setter& to, Value name, Value value) { set_reference(to.style.marker_mid, to, name, value); }},
    {"marker-start", true, take<&Style::marker_start>,
     [](Setter& to, Value name, Value value) { set_reference(to.style.marker_start, to, name, value); }},
    {"mask", false, take<&Style::mask>,
     [](Setter& to, Value name, Value value) { set_reference(to.style.mask, to, name, value); }},
    {"mask-type", false, take<&Style::alpha_mask>,
     [](Setter& to, Value, Value value) { to.style.alpha_mask = value == "alpha"; }},
    {"mix-blend-mode", false, nullptr,
     [](Setter& to, Value, Value value) {
         say_unless_none(to, value, "mix-blend-mode is not supported: drawn plainly");
     }},
    {"opacity", false, take<&Style::opacity>,
     [](Setter& to, Value name, Value value) { set_share(to.style.opacity, to, name, value); }},
    {"overflow", false, take<&Style::overflows>,
     [](Setter& to, Value, Value value) { to.style.overflows = value == "visible" || value == "auto"; }},
    {"paint-order", true, nullptr,
     [](Setter& to, Value, Value value) {
         if (value != "normal" && !value.starts_with("fill"))
             note(to.context.notes, "paint-order is not supported: the stroke is painted over the fill", to.node,
                  value);
     }},
    {"stroke", true, take<&Style::stroke>,
     [](Setter& to, Value name, Value value) { set_brush(to.style.stroke, to, name, value); }},
    {"stroke-dasharray", true, take<&Style::dashes>, set_dashes},
    {"stroke-dashoffset", true, take<&Style::dash_offset>,
     [](Setter& to, Value name, Value value) {
         if (const auto length = length_of(to, name, value, to.style.font_size))
             to.style.dash_offset = *length;
     }},
    {"stroke-linecap", true, take<&Style::cap>,
     [](Setter& to, Value name, Value value) { set_word(to.style.cap, to, name, value, caps); }},
    {"stroke-linejoin", true, take<&Style::join>,
     [](Setter& to, Value name, Value value) { set_word(to.style.join, to, name, value, joins); }},
    {"stroke-opacity", true, take<&Style::stroke_opacity>,
     [](Setter& to, Value name, Value value) { set_share(to.style.stroke_opacity, to, name, value); }},
    {"stroke-width", true, take<&Style::stroke_width>,
     [](Setter& to, Value name, Value value) {
         const auto length = length_of(to, name, value, to.style.font_size);
         if (length && *length >= 0) to.style.stroke_width = *length;
         if (length && *length < 0) misread(to, name, value);
     }},
    {"text-anchor", true, take<&Style::text_anchor>,
     [](Setter& to, Value, Value value) { to.style.text_anchor = value; }},
    {"transform", false, take<&Style::transform>,
     [](Setter& to, Value, Value value) { to.style.transform = value; }},
    {"transform-box", false, nullptr,
     [](Setter& to, Value, Value value) {
         if (value != "view-box")
             note(to.context.notes, "transform-box is not supported: the view box is taken", to.node);
     }},
    {"transform-origin", false, take<&Style::transform_origin>,
     [](Setter& to, Value, Value value) { to.style.transform_origin = value; }},
    {"vector-effect", false, take<&Style::scaling_stroke>,
     [](Setter& to, Value, Value value) { to.style.scaling_stroke = value != "non-scaling-stroke"; }},
    {"visibility", true, take<&Style::visible>,
     [](Setter& to, Value, Value value) {
         to.style.visible = value != "hidden" && value != "collapse";
     }},
});
static_assert(std::ranges::is_sorted(properties, {}, &Property::name));

}  // namespace

bool sets_font_size(std::string_view name) { return name == "font-size" || name == "font"; }

void set_property(Setter& setter, std::string_view name, std::string_view value) {
    static const Style initial;
    const auto property = std::ranges::lower_bound(properties, name, {}, &Property::name);
    if (property == properties.end() || property->name != name) return;
    const bool unset = value == "unset" || value == "revert";
    const bool inherit = value == "inherit" || (unset && property->inherited);
    if (!inherit && !unset && value != "initial") return property->set(setter, name, value);
    if (property->take != nullptr) property->take(setter.style, inherit ? setter.parent : initial);
}

}  // namespace strandline::svg
