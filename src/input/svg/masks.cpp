// mask, where it is no more than an area: shapes that let all through or nothing (CSS Masking 1, 7). So
// Figma writes frames, icons and strokes inside or outside an outline.
#include <utility>

#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

/// Of linear RGB, as masks use it (CSS Masking 1, 7.10.1), without the gamma that black and white do not
/// have.
double brightness(Colour c) { return (0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b) / 255; }

/// The rectangle that a mask is limited to, in the user's units; nothing where the file leaves it as it is.
std::optional<Box> frame_of(Walk& walk, pugi::xml_node mask, const Surroundings& around) {
    if (std::string_view(mask.attribute("maskUnits").value()) != "userSpaceOnUse") return std::nullopt;
    const auto side = [&](const char* name, Axis axis) { return length_of(walk, mask, name, axis, around); };
    const auto x = side("x", Axis::x), y = side("y", Axis::y), width = side("width", Axis::x),
               height = side("height", Axis::y);
    if (!width || !height) return std::nullopt;
    const Point low{x.value_or(0), y.value_or(0)};
    return Box{low, low + Point{*width, *height}};
}

}  // namespace

void add_to_mask(Collected& collected, const Surroundings& around, Regions area) {
    const auto& style = around.style;
    if (style.fill.mixed || (style.stroke_width > 0 && paint_of(style.stroke, style.stroke_opacity, around)))
        collected.unclear = true;
    const auto paint = paint_of(style.fill, style.fill_opacity, around);
    if (!paint) return;
    constexpr double nothing = 0.02, all = 0.98;
    const double value = collected.alpha ? paint->opacity : brightness(paint->colour);
    if ((value > nothing && value < all) || paint->opacity < all) collected.unclear = true;
    collected.area = value < all ? subtracted(collected.area, area) : united(collected.area, area);
}

std::shared_ptr<Clip> mask_of(Walk& walk, pugi::xml_node mask, pugi::xml_node user,
                              const Surroundings& around, int depth) {
    const ClipKey key = clip_key(mask, around.map, {});
    if (const auto known = walk.clips.find(key); known != walk.clips.end()) return known->second;
    std::shared_ptr<Clip> clip;
    Surroundings inner = around;
    inner.style = style_where_defined(walk, mask, around);
    inner.style.group_opacity = 1;
    inner.clip = nullptr;
    inner.instance = {};
    inner.instance_id.clear();
    if (const auto frame = frame_of(walk, mask, around)) clip_to(walk, inner, *frame);
    const bool by_box = std::string_view(mask.attribute("maskContentUnits").value()) == "objectBoundingBox";
    through_reference(walk, mask, user, [&] {
        Collected fresh{Purpose::mask};
        fresh.alpha = inner.style.alpha_mask;
        fresh.unclear = by_box || !inner.style.mask.empty() || !inner.style.clip_path.empty();
        auto outer = std::exchange(walk.collected, std::move(fresh));
        walk_children(walk, mask, inner, depth + 1);
        auto found = std::exchange(walk.collected, std::move(outer));
        if (!found.unclear) clip = make_clip(std::move(found.area));
    });
    walk.clips.emplace(key, clip);
    return clip;
}

}  // namespace strandline::svg
