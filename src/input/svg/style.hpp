#pragma once
// Private to the room: what an element looks like, as CSS resolves it: presentation attributes, then style
// sheets, then style="", then what is !important of both; inherited where the property is.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/svg/colour.hpp"
#include "input/svg/notes.hpp"
#include "input/svg/references.hpp"
#include "input/svg/scan.hpp"
#include "input/svg/sheet.hpp"

namespace strandline::svg {

/// What `fill` or `stroke` says: nothing, an ink, the colour property wherever it is used, or, in a marker,
/// the paint of the shape that carries it.
struct Brush {
    enum class Kind { none, ink, current, context_fill, context_stroke } kind = Kind::none;
    Ink ink;
    bool mixed = false;  ///< it stands for a gradient or pattern of several
};

/// References are ids, empty for none; texts point into the document.
struct Style {
    Brush fill{Brush::Kind::ink, {}}, stroke;
    double fill_opacity = 1, stroke_opacity = 1;
    double opacity = 1;        ///< the element's own (not inherited)
    double group_opacity = 1;  ///< own and all ancestors' multiplied
    FillRule fill_rule = FillRule::nonzero, clip_rule = FillRule::nonzero;
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
    double stroke_width = 1;                            ///< user units of the element
    std::shared_ptr<const std::vector<double>> dashes;  ///< user units; nothing: solid
    double dash_offset = 0;
    std::string_view marker_start, marker_mid, marker_end;
    Colour color;           ///< for currentColor
    double font_size = 16;  ///< px, for em
    std::string_view font_family, text_anchor;
    int font_weight = 400;
    bool italic = false;
    double letter_spacing = 0;
    bool visible = true;

    // Not inherited.
    bool displayed = true;          ///< an element that is not displayed takes its children with it
    bool scaling_stroke = true;     ///< false: vector-effect non-scaling-stroke
    std::optional<bool> overflows;  ///< overflow visible (or hidden), where the element says so
    bool alpha_mask = false;        ///< mask-type of a <mask>
    std::string_view clip_path, mask, transform, transform_origin;
};

/// A gradient as one ink; `uniform` when it was no more than that.
struct Served {
    Brush brush;
    bool uniform = true;
};

struct StyleContext {
    Notes& notes;
    References& references;
    Sheet& sheet;
    std::map<std::string_view, Served>& gradients;  ///< worked out so far, by id
    Viewport viewport;
    std::optional<Error> error;  ///< a number that is not finite or too large
};

/// All declarations for the element, weakest first.
Declarations cascade(pugi::xml_node node, StyleContext& context);

/// The element's style from its parent's.
Style resolved_style(pugi::xml_node node, const Style& parent, StyleContext& context);

/// The solid ink for url(#id): a gradient's is the mean of its stops (weighted by their opacity), a pattern's
/// black. Nothing when the id names no paint. Notes what was replaced at `user`. Each id is worked out once.
std::optional<Brush> served_paint(std::string_view id, pugi::xml_node user, StyleContext& context);

}  // namespace strandline::svg
