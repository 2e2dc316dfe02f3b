#pragma once
// Private to the room: the walk from the XML tree to shapes in painting order, and what its parts share.
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "input/svg/clip.hpp"
#include "input/svg/elements.hpp"
#include "input/svg/frame.hpp"
#include "input/svg/markup.hpp"
#include "input/svg/notes.hpp"
#include "input/svg/outline.hpp"
#include "input/svg/references.hpp"
#include "input/svg/sheet.hpp"
#include "input/svg/style.hpp"
#include "input/svg/svg.hpp"
#include "math/region/region.hpp"

namespace strandline::svg {

/// What an element takes over from those around it.
struct Surroundings {
    Style style;
    Affine map;  ///< to the root's user units
    Viewport viewport;
    bool percent_known = false;
    bool bare_is_svg = true;      ///< names without prefix are SVG's
    std::string_view svg_prefix;  ///< a prefix that means SVG
    int layer = -1;               ///< in Document::layers
    bool grouped = false;         ///< a named group is around it: no group inside is a layer of its own
    std::shared_ptr<Clip> clip;   ///< what may be seen; absent: all
    std::shared_ptr<const std::vector<Hint>> hints;
    pugi::xml_node instance;                      ///< the element that <use> or a marker draws once more
    std::string instance_id;                      ///< and the id that it gets; empty: not in <use>
    std::optional<double> use_width, use_height;  ///< of the <use> that draws a symbol or svg
    std::optional<Paint> context_fill, context_stroke;  ///< of the shape that carries the marker
};

/// What the walk is for: shapes, or, for clips, the box of an element, the outlines of a clipPath or the area
/// that a mask lets through.
enum class Purpose { shapes, box, outlines, mask };
struct Collected {
    Purpose purpose = Purpose::shapes;
    Box box = {};
    std::vector<Polygon> outlines = {};
    Regions area = {};
    bool alpha = false;    ///< of a mask: opacity counts, not brightness
    bool unclear = false;  ///< of a mask: it holds more than shapes that let all through or nothing
};

struct Walk {
    const Markup& markup;
    const ReadOptions& options;
    const Progress& progress;
    Notes notes;
    References references;
    Sheet sheet = {};
    std::map<std::string_view, Served> gradients = {};
    Document document = {};
    Frame frame = {};
    bool has_layers = false;                    ///< Inkscape's own
    std::vector<std::string> layer_paths = {};  ///< Shape::layer of each layer
    std::optional<Error> error = {};
    bool stopped = false;
    std::size_t elements = 0, expanded = 0, segments = 0;
    std::unordered_set<std::string> ids = {};
    std::vector<pugi::xml_node> active = {};  ///< elements that are being drawn through a reference
    std::map<ClipKey, std::shared_ptr<Clip>> clips = {};
    Collected collected = {};

    bool over() const { return error || stopped; }
    void refuse(pugi::xml_node node, std::string reason, std::string remedy = "mend the file") {
        if (!error) error = Error{place_of(markup, node), std::move(reason), std::move(remedy)};
    }
    void refuse_number(pugi::xml_node node, std::string_view what);
    StyleContext style_context(const Viewport& viewport) {
        return {notes, references, sheet, gradients, viewport, {}};
    }
};

// ---- walk.cpp
void walk_element(Walk& walk, pugi::xml_node node, const Surroundings& outside, int depth);
void walk_children(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth);
/// What the element draws, its own style, transform and clip being in `around` already.
void walk_content(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around, int depth);
/// The style that what is defined in `node` inherits: of a marker's or clipPath's own ancestors.
Style style_where_defined(Walk& walk, pugi::xml_node node, const Surroundings& user);
bool is_svg_element(std::string_view name, const Surroundings& around);
/// A length attribute; nothing when it is absent or not understood (noted).
std::optional<double> length_of(Walk& walk, pugi::xml_node node, const char* name, Axis axis,
                                const Surroundings& around);
/// Runs `draw` with `target` marked as being drawn. False, with a note at `user`, when it is so already or
/// holds `user`: a circle.
template <class Draw>
bool through_reference(Walk& walk, pugi::xml_node target, pugi::xml_node user, Draw draw) {
    const auto circle = [&] {
        for (const auto& node : walk.active)
            if (node == target) return true;
        for (auto node = user; node; node = node.parent())
            if (node == target) return true;
        return false;
    };
    if (circle()) {
        note(walk.notes, "a reference in a circle: passed over", user);
        return false;
    }
    walk.active.push_back(target);
    draw();
    walk.active.pop_back();
    return true;
}

// ---- containers.cpp
void enter_layer(Walk& walk, pugi::xml_node node, Surroundings& around);
/// False when nothing of it can be seen.
bool enter_nested_svg(Walk& walk, pugi::xml_node node, Surroundings& around);
void walk_choice(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth);
void walk_use(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth);

// ---- shapes.cpp
void add_shape(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around, int depth);
/// How an outline is painted: whether it bounds an area, and what tells several of one element apart.
struct Painted {
    bool fillable = true;
    std::string part = {};
};
/// From subpaths in the element's own units to a shape, or to what the walk collects.
void add_outline(Walk& walk, pugi::xml_node node, const std::vector<Path>& outline, Painted painted,
                 const Surroundings& around);
Outline outline_of(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around);
std::optional<Paint> paint_of(const Brush& brush, double opacity, const Surroundings& around);

// ---- text.cpp
void add_text(Walk& walk, pugi::xml_node node, const Surroundings& around, int depth);

// ---- markers.cpp
/// Draws the markers of a shape whose outline, in its own units, is `outline`.
void add_markers(Walk& walk, pugi::xml_node node, const std::vector<Path>& outline,
                 const Surroundings& around, int depth);

// ---- clip_paths.cpp
/// Sets around.clip to what the element's clip-path (and mask, where that is no more than one) leaves of it.
/// False when nothing is left.
bool enter_clip(Walk& walk, pugi::xml_node node, Kind kind, Surroundings& around, int depth);
ClipKey clip_key(pugi::xml_node node, const Affine& map, const Box& box);
/// Cuts at a rectangle of the element's own units.
void clip_to(Walk& walk, Surroundings& around, const Box& box);

// ---- masks.cpp
/// The area that a mask lets through at a place; nothing where it is more than an area.
std::shared_ptr<Clip> mask_of(Walk& walk, pugi::xml_node mask, pugi::xml_node user,
                              const Surroundings& around, int depth);
/// Paints an area of root units onto the mask that is being collected.
void add_to_mask(Collected& collected, const Surroundings& around, Regions area);

}  // namespace strandline::svg
