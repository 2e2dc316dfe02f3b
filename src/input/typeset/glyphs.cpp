#include "input/typeset/glyphs.hpp"

#include <fmt/format.h>
#include <hb.h>

#include <algorithm>
#include <iterator>
#include <memory>

namespace strandline::typeset {
namespace {

// Text is laid out at this size and scaled: lengths in Pango are whole numbers of 1/1024 pixel, so that an em
// has 65,536 steps, and a line may be longest_line em long before they overflow.
constexpr double layout_size = 64;

template <class T, auto release>
struct Release {
    void operator()(T* held) const { release(held); }
};
using Layout = std::unique_ptr<PangoLayout, Release<PangoLayout, [](PangoLayout* l) { g_object_unref(l); }>>;
using Description =
    std::unique_ptr<PangoFontDescription, Release<PangoFontDescription, pango_font_description_free>>;
using LayoutIter = std::unique_ptr<PangoLayoutIter, Release<PangoLayoutIter, pango_layout_iter_free>>;
using DrawFuncs = std::unique_ptr<hb_draw_funcs_t, Release<hb_draw_funcs_t, hb_draw_funcs_destroy>>;

/// Where HarfBuzz draws: its points, y up, through `map`.
struct Pen {
    Affine map;
    std::vector<Path> paths;

    Point at(float x, float y) const { return apply(map, {double(x), double(y)}); }
    void close() {
        if (paths.empty()) return;
        Path& path = paths.back();
        if (path.segments.empty()) return paths.pop_back();
        if (end_of(path) != path.start) path.segments.emplace_back(LineSegment{path.start});
        path.closed = true;
    }
};
Pen& pen(void* data) { return *static_cast<Pen*>(data); }

void move_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
    pen(data).paths.push_back({pen(data).at(x, y), {}, false});
}
void line_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
    pen(data).paths.back().segments.emplace_back(LineSegment{pen(data).at(x, y)});
}
void quadratic_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float cx, float cy, float x, float y,
                  void*) {
    Path& path = pen(data).paths.back();
    const Point from = end_of(path), control = pen(data).at(cx, cy), to = pen(data).at(x, y);
    path.segments.emplace_back(
        CubicSegment{between(from, control, 2.0 / 3), between(to, control, 2.0 / 3), to});
}
void cubic_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float ax, float ay, float bx, float by, float x,
              float y, void*) {
    pen(data).paths.back().segments.emplace_back(
        CubicSegment{pen(data).at(ax, ay), pen(data).at(bx, by), pen(data).at(x, y)});
}
void close_path(hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) { pen(data).close(); }

DrawFuncs draw_funcs() {
    DrawFuncs funcs(hb_draw_funcs_create());
    hb_draw_funcs_set_move_to_func(funcs.get(), move_to, nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(funcs.get(), line_to, nullptr, nullptr);
    hb_draw_funcs_set_quadratic_to_func(funcs.get(), quadratic_to, nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(funcs.get(), cubic_to, nullptr, nullptr);
    hb_draw_funcs_set_close_path_func(funcs.get(), close_path, nullptr, nullptr);
    return funcs;
}

Layout layout_of(PangoContext* context, const std::string& text, const std::string& families,
                 const svg::TextSpan& span) {
    Layout layout(pango_layout_new(context));
    const Description font(pango_font_description_new());
    pango_font_description_set_family(font.get(), families.c_str());
    pango_font_description_set_weight(font.get(),
                                      static_cast<PangoWeight>(std::clamp(span.weight, 100, 1000)));
    pango_font_description_set_style(font.get(), span.italic ? PANGO_STYLE_ITALIC : PANGO_STYLE_NORMAL);
    pango_font_description_set_absolute_size(font.get(), layout_size * PANGO_SCALE);
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    if (span.letter_spacing != 0) {
        PangoAttrList* attributes = pango_attr_list_new();
        const double spacing = span.letter_spacing / span.size;
        pango_attr_list_insert(
            attributes, pango_attr_letter_spacing_new(static_cast<int>(spacing * layout_size * PANGO_SCALE)));
        pango_layout_set_attributes(layout.get(), attributes);
        pango_attr_list_unref(attributes);
    }
    return layout;
}

void add_once(std::vector<std::string>& list, const std::string& text) {
    if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

/// What of `text` begins at `byte`, for people.
std::string character_at(const std::string& text, std::size_t byte) {
    const char* at = text.c_str() + std::min(byte, text.size());
    return {at, static_cast<std::size_t>(g_utf8_next_char(at) - at)};
}
bool draws_nothing(const std::string& character) {
    const gunichar code = g_utf8_get_char(character.c_str());
    return code == 0 || g_unichar_isspace(code) || g_unichar_iszerowidth(code) || g_unichar_iscntrl(code);
}

struct Setting {
    const std::string& text;
    double scale;  ///< user units to the Pango unit
    DrawFuncs funcs = draw_funcs();
    Piece piece = {};

    /// `x`: where the run begins, Pango units.
    void add(const PangoGlyphItem& run, int x) {
        PangoFont* font = run.item->analysis.font;
        const Description described(pango_font_describe(font));
        hb_font_t* outlines = pango_font_get_hb_font(font);
        for (int i = 0; i < run.glyphs->num_glyphs; ++i) {
            const PangoGlyphInfo& glyph = run.glyphs->glyphs[i];
            const auto byte = static_cast<std::size_t>(run.item->offset + run.glyphs->log_clusters[i]);
            const Point at{scale * (x + glyph.geometry.x_offset), scale * glyph.geometry.y_offset};
            x += glyph.geometry.width;
            if (glyph.glyph == PANGO_GLYPH_EMPTY) continue;
            Pen drawn{{scale, 0, 0, -scale, at.x, at.y}, {}};
            if ((glyph.glyph & PANGO_GLYPH_UNKNOWN_FLAG) == 0)
                hb_font_get_glyph_shape(outlines, glyph.glyph, funcs.get(), &drawn);
            if (drawn.paths.empty()) {
                const std::string character = character_at(text, byte);
                if (!draws_nothing(character)) add_once(piece.missing, character);
                continue;
            }
            add_once(piece.families, pango_font_description_get_family(described.get()));
            std::ranges::move(drawn.paths, std::back_inserter(piece.outlines));
        }
    }
};

}  // namespace

Piece piece_of(PangoContext* context, const std::string& text, const std::string& families,
               const svg::TextSpan& span) {
    const Layout layout = layout_of(context, text, families, span);
    Setting setting{text, span.size / layout_size / PANGO_SCALE};
    const LayoutIter iter(pango_layout_get_iter(layout.get()));
    int base_line_end = 0;
    do {
        PangoRectangle extents;
        pango_layout_iter_get_run_extents(iter.get(), nullptr, &extents);
        base_line_end = std::max(base_line_end, extents.x + extents.width);
        if (const PangoGlyphItem* run = pango_layout_iter_get_run_readonly(iter.get()))
            setting.add(*run, extents.x);
    } while (pango_layout_iter_next_run(iter.get()));
    setting.piece.advance = setting.scale * base_line_end;
    return std::move(setting.piece);
}

}  // namespace strandline::typeset
