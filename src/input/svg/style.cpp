#include "input/svg/style.hpp"

#include "input/svg/properties.hpp"

namespace strandline::svg {

namespace {

Declarations of_attribute(std::string_view css, Sheet& sheet) {
    constexpr std::size_t per_step = 16;  // characters read in the time of one comparison
    sheet.steps += css.size() / per_step;
    if (const auto known = sheet.copied_attributes.find(css.data()); known != sheet.copied_attributes.end())
        return known->second;
    const auto texts = sheet.texts.size();
    auto declarations = read_declarations(css, sheet.texts);
    if (sheet.texts.size() > texts) sheet.copied_attributes.emplace(css.data(), declarations);
    return declarations;
}

}  // namespace

Declarations cascade(pugi::xml_node node, StyleContext& context) {
    Declarations all;
    std::string_view css;
    for (const auto attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        if (name == "style")
            css = attribute.value();
        else
            all.push_back({name, trimmed(attribute.value()), false});
    }
    Declarations important;
    const auto take = [&](const Declarations& declarations) {
        for (const auto& declaration : declarations)
            (declaration.important ? important : all).push_back(declaration);
    };
    std::vector<const Declarations*> matching;
    matching_declarations(context.sheet, node, matching);
    for (const auto* block : matching) take(*block);
    if (!css.empty()) take(of_attribute(css, context.sheet));
    all.insert(all.end(), important.begin(), important.end());
    return all;
}

Style resolved_style(pugi::xml_node node, const Style& parent, StyleContext& context) {
    Style style = parent;
    const Style initial;
    style.opacity = initial.opacity;
    style.displayed = initial.displayed;
    style.scaling_stroke = initial.scaling_stroke;
    style.overflows = initial.overflows;
    style.alpha_mask = initial.alpha_mask;
    style.clip_path = style.mask = style.transform = style.transform_origin = {};
    Setter setter{node, parent, style, context};
    const auto declarations = cascade(node, context);
    for (const auto& [name, value, important] : declarations)
        if (sets_font_size(name)) set_property(setter, name, value);
    for (const auto& [name, value, important] : declarations)
        if (!sets_font_size(name)) set_property(setter, name, value);
    style.group_opacity = parent.group_opacity * style.opacity;
    return style;
}

}  // namespace strandline::svg
