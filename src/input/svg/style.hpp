#pragma once
// Private to the room: presentation attributes and style="", resolved as CSS resolves them: inherited where
// they are.
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "input/svg/colour.hpp"
#include "input/svg/notes.hpp"
#include "input/svg/scan.hpp"

namespace strandline::svg {

/// What `fill` or `stroke` says: nothing, an ink, or the colour property wherever it is used.
struct Brush {
    enum class Kind { none, ink, current } kind = Kind::none;
    Ink ink;
};

struct Style {
    Brush fill{Brush::Kind::ink, {}}, stroke;
    double fill_opacity = 1, stroke_opacity = 1;
    double opacity = 1;        ///< the element's own (not inherited)
    double group_opacity = 1;  ///< own and all ancestors' multiplied
    FillRule fill_rule = FillRule::nonzero;
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
    double stroke_width = 1;     ///< user units of the element
    bool scaling_stroke = true;  ///< false: vector-effect non-scaling-stroke (not inherited)
    Colour color;                ///< for currentColor
    double font_size = 16;       ///< px, for em
    bool visible = true;
    bool displayed = true;  ///< not inherited: an element that is not displayed takes its children with it
};

/// A gradient as one ink; `uniform` when it was no more than that.
struct Served {
    Brush brush;
    bool uniform = true;
};
/// What ids name as paint: gradients as the one ink they come nearest to.
struct PaintServers {
    bool indexed = false;
    std::map<std::string_view, pugi::xml_node> by_id;  ///< first element of each id
    std::map<std::string_view, Served> resolved;       ///< gradients, by id
};

struct StyleContext {
    Notes& notes;
    PaintServers& servers;
    Viewport viewport;
    std::optional<Error> error;  ///< a number that is not finite or too large
};

/// The element's style from its parent's: presentation attributes first, then style="".
Style resolved_style(pugi::xml_node node, const Style& parent, StyleContext& context);

/// The solid ink for url(#id): a gradient's is the mean of its stops (weighted by their opacity), a pattern's
/// black. Nothing when the id names no paint. Notes what was replaced at `user`. Each id is worked out once.
std::optional<Brush> served_paint(std::string_view id, pugi::xml_node user, StyleContext& context);

/// Calls use(name, value) for each declaration of style="", names in lower case, `!important` off, comments
/// out.
template <class Use>
void each_declaration(std::string_view css, Use use);
std::string without_comments(std::string_view css);
/// The next declaration's end: the `;` outside brackets and quotes, or the end.
std::size_t declaration_end(std::string_view css, std::size_t from);

template <class Use>
void each_declaration(std::string_view css, Use use) {
    const std::string plain = without_comments(css);
    const std::string_view text = plain;
    for (std::size_t from = 0; from < text.size();) {
        const auto end = declaration_end(text, from);
        const auto declaration = text.substr(from, end - from);
        from = end + 1;
        const auto colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        auto value = trimmed(declaration.substr(colon + 1));
        if (const auto bang = value.rfind('!');
            bang != std::string_view::npos && lower_case(trimmed(value.substr(bang + 1))) == "important")
            value = trimmed(value.substr(0, bang));
        use(lower_case(trimmed(declaration.substr(0, colon))), value);
    }
}

}  // namespace strandline::svg
