#include "input/svg/elements.hpp"

#include <algorithm>
#include <array>

namespace strandline::svg {

namespace {

constexpr std::string_view no_image = "images are not drawn: left out";
constexpr std::string_view no_flow =
    "flowing text (flowRoot) is not supported: left out (turn it into paths)";

/// Sorted by name.
constexpr std::array kinds = std::to_array<NamedKind>({
    {"a", Kind::group, {}},
    {"altGlyphDef", Kind::silent, {}},
    {"animate", Kind::left_out, "animations are not played: left out"},
    {"animateColor", Kind::left_out, "animations are not played: left out"},
    {"animateMotion", Kind::left_out, "animations are not played: left out"},
    {"animateTransform", Kind::left_out, "animations are not played: left out"},
    {"circle", Kind::circle, {}},
    {"clipPath", Kind::silent, {}},
    {"color-profile", Kind::silent, {}},
    {"cursor", Kind::silent, {}},
    {"defs", Kind::silent, {}},
    {"desc", Kind::silent, {}},
    {"ellipse", Kind::ellipse, {}},
    {"filter", Kind::silent, {}},
    {"flowRoot", Kind::left_out, no_flow},
    {"font", Kind::silent, {}},
    {"font-face", Kind::silent, {}},
    {"foreignObject", Kind::left_out, "foreignObject is not drawn: left out"},
    {"g", Kind::group, {}},
    {"hatch", Kind::silent, {}},
    {"image", Kind::left_out, no_image},
    {"line", Kind::line, {}},
    {"linearGradient", Kind::silent, {}},
    {"marker", Kind::silent, {}},
    {"mask", Kind::silent, {}},
    {"meshgradient", Kind::silent, {}},
    {"metadata", Kind::silent, {}},
    {"namedview", Kind::silent, {}},
    {"path", Kind::path, {}},
    {"pattern", Kind::silent, {}},
    {"polygon", Kind::polygon, {}},
    {"polyline", Kind::polyline, {}},
    {"radialGradient", Kind::silent, {}},
    {"rect", Kind::rect, {}},
    {"script", Kind::left_out, "scripts are not run: left out"},
    {"set", Kind::left_out, "animations are not played: left out"},
    {"solidColor", Kind::silent, {}},
    {"style", Kind::silent, {}},
    {"svg", Kind::nested_svg, {}},
    {"switch", Kind::choice, {}},
    {"symbol", Kind::symbol, {}},
    {"text", Kind::text, {}},
    {"title", Kind::silent, {}},
    {"use", Kind::use, {}},
    {"view", Kind::silent, {}},
});
static_assert(std::ranges::is_sorted(kinds, {}, &NamedKind::name));

}  // namespace

NamedKind kind_named(std::string_view name) {
    const auto found = std::ranges::lower_bound(kinds, name, {}, &NamedKind::name);
    return found == kinds.end() || found->name != name ? NamedKind{name, Kind::unknown, {}} : *found;
}

}  // namespace strandline::svg
