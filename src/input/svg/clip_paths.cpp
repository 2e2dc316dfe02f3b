// clip-path: the areas that <clipPath> elements leave (CSS Masking 1, 5 and 6).
#include <utility>

#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

/// The box of what the element draws, in its own units, strokes and clips not counted.
Box box_of(Walk& walk, pugi::xml_node node, Kind kind, const Surroundings& around, int depth) {
    auto outer = std::exchange(walk.collected, Collected{Purpose::box});
    const bool silent = std::exchange(walk.notes.silent, true);
    Surroundings inner = around;
    inner.map = {};
    inner.clip = nullptr;
    walk_content(walk, node, kind, inner, depth);
    walk.notes.silent = silent;
    return std::exchange(walk.collected, std::move(outer)).box;
}

/// The regions that a clipPath leaves of an element whose units `around.map` takes to the root's. `box`: of
/// that element, where the clipPath asks for it.
std::shared_ptr<Clip> clip_of(Walk& walk, pugi::xml_node clip_path, pugi::xml_node user,
                              const std::optional<Box>& box, const Surroundings& around, int depth) {
    const ClipKey key = clip_key(clip_path, around.map, box.value_or(Box{{0, 0}, {0, 0}}));
    if (const auto known = walk.clips.find(key); known != walk.clips.end()) return known->second;

    Surroundings inner = around;
    inner.style = style_where_defined(walk, clip_path, around);
    inner.clip = nullptr;
    inner.instance = {};
    inner.instance_id.clear();
    if (const auto read = read_transform(inner.style.transform); read.state == ValueState::good)
        inner.map = composed(inner.map, read.map);
    else
        note(walk.notes, "a transform that is not understood: passed over", clip_path, inner.style.transform);
    if (box) {
        inner.map = composed(inner.map, {box->width(), 0, 0, box->height(), box->low.x, box->low.y});
        inner.viewport = {1, 1, inner.viewport.dpi};
    }
    std::shared_ptr<Clip> clip;
    through_reference(walk, clip_path, user, [&] {
        Surroundings own = inner;  // a clip-path on the clipPath, in the units of the user
        own.map = around.map;
        enter_clip(walk, clip_path, Kind::silent, own, depth + 1);
        inner.clip = own.clip;
        auto outer = std::exchange(walk.collected, Collected{Purpose::outlines});
        walk_children(walk, clip_path, inner, depth + 1);
        auto outlines = std::exchange(walk.collected, std::move(outer)).outlines;
        clip = make_clip(resolved(outlines, strandline::FillRule::nonzero));
    });
    if (clip) walk.clips.emplace(key, clip);
    return clip;
}

void enter_mask(Walk& walk, pugi::xml_node node, Surroundings& around, int depth) {
    if (around.style.mask.empty()) return;
    const auto target = element_of(walk.references, around.style.mask);
    if (local_name(target.name()) != "mask")
        return note(walk.notes, "a mask that is not in the file: drawn unmasked", node, around.style.mask);
    if (const auto area = mask_of(walk, target, node, around, depth))
        around.clip = both(around.clip, area);
    else
        note(walk.notes, "a mask with shades or strokes is not supported: drawn unmasked", node);
}

}  // namespace

ClipKey clip_key(pugi::xml_node node, const Affine& m, const Box& box) {
    return {node.hash_value(),
            {m.a, m.b, m.c, m.d, m.e, m.f, box.low.x, box.low.y, box.width(), box.height()}};
}

bool enter_clip(Walk& walk, pugi::xml_node node, Kind kind, Surroundings& around, int depth) {
    if (walk.collected.purpose == Purpose::box) return true;
    if (walk.collected.purpose == Purpose::shapes) enter_mask(walk, node, around, depth);
    const auto id = around.style.clip_path;
    if (id.empty()) return true;
    const auto target = element_of(walk.references, id);
    if (local_name(target.name()) != "clipPath") {
        note(walk.notes, "a clip-path that is not in the file: drawn uncut", node, id);
        return true;
    }
    std::optional<Box> box;
    if (std::string_view(target.attribute("clipPathUnits").value()) == "objectBoundingBox") {
        box = box_of(walk, node, kind, around, depth);
        if (walk.over()) return false;
        if (box->empty() || box->width() <= 0 || box->height() <= 0) {
            note(walk.notes, "a clip-path by the box of what has no area: draws nothing", node);
            return false;
        }
    }
    if (depth > walk.options.limits.depth) return false;
    const auto clip = clip_of(walk, target, node, box, around, depth);
    if (clip) around.clip = both(around.clip, clip);
    return !walk.over();
}

void clip_to(Walk& walk, Surroundings& around, const Box& box) {
    if (walk.collected.purpose == Purpose::box) return;
    const auto& [low, high] = box;
    Polygon corners{low, {high.x, low.y}, high, {low.x, high.y}};
    for (Point& corner : corners) corner = apply(around.map, corner);
    around.clip = both(around.clip, make_clip(resolved({corners}, strandline::FillRule::nonzero)));
}

}  // namespace strandline::svg
