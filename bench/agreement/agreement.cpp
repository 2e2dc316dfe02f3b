// agreement FILE...: reads each SVG and draws it twice by cairo at 512 px, as librsvg sees it and as
// input/svg does. One line a file, tab separated: file, outcome (read | refused | no shapes | librsvg
// refuses), ratio, seconds to read, seconds to make a drawing of it, warnings (or the refusal). ratio:
// sum(min) / sum(max) of the non-white coverage over all pixels.
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "input/drawing/drawing.hpp"
#include "input/svg/svg.hpp"
#include "machine/robot/robot.hpp"

namespace {

using namespace strandline;

constexpr double pixels = 512;
/// A channel that much below white (of 255) counts as wholly covered: what is compared is where paint is, not
/// how dark.
constexpr double full_coverage = 32;

struct Release {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Cairo = std::unique_ptr<cairo_t, Release>;

Surface white_sheet(int width, int height) {
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
    const Cairo cairo(cairo_create(surface.get()));
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    return surface;
}

void add(cairo_t* cairo, const Path& path) {
    cairo_move_to(cairo, path.start.x, path.start.y);
    for (const Segment& segment : path.segments) {
        if (const auto* line = std::get_if<LineSegment>(&segment)) {
            cairo_line_to(cairo, line->to.x, line->to.y);
        } else if (const auto* c = std::get_if<CubicSegment>(&segment)) {
            cairo_curve_to(cairo, c->control1.x, c->control1.y, c->control2.x, c->control2.y, c->to.x,
                           c->to.y);
        } else {
            // cubics of at most an eighth of a turn: off by less than 1e-6 of the radius
            const auto& arc = std::get<ArcSegment>(segment);
            const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (pi / 4))));
            const double step = arc.sweep / parts, handle = 4.0 / 3 * std::tan(step / 4);
            for (int i = 0; i < parts; ++i) {
                const double t0 = arc.start + i * step, t1 = t0 + step;
                const auto at = [&](double t) {
                    return arc.center + std::cos(t) * arc.u + std::sin(t) * arc.v;
                };
                const auto along = [&](double t) { return -std::sin(t) * arc.u + std::cos(t) * arc.v; };
                const Point a = at(t0) + handle * along(t0), b = at(t1) - handle * along(t1), end = at(t1);
                cairo_curve_to(cairo, a.x, a.y, b.x, b.y, end.x, end.y);
            }
        }
    }
    if (path.closed) cairo_close_path(cairo);
}

void set_paint(cairo_t* cairo, const svg::Paint& paint) {
    cairo_set_source_rgba(cairo, paint.colour.r / 255.0, paint.colour.g / 255.0, paint.colour.b / 255.0,
                          paint.opacity);
}

Surface ours(const svg::Document& document, int width, int height) {
    Surface surface = white_sheet(width, height);
    const Cairo held(cairo_create(surface.get()));
    cairo_t* cairo = held.get();
    const double scale = std::min(width / document.view.width(), height / document.view.height());
    cairo_translate(cairo, (width - scale * document.view.width()) / 2,
                    (height - scale * document.view.height()) / 2);
    cairo_scale(cairo, scale, scale);
    cairo_translate(cairo, -document.view.low.x, -document.view.low.y);
    cairo_set_tolerance(cairo, 0.1);
    for (const svg::Shape& shape : document.shapes) {
        if (shape.fill) {
            cairo_new_path(cairo);
            for (const Path& path : shape.subpaths) add(cairo, path);
            cairo_set_fill_rule(cairo, shape.fill_rule == svg::FillRule::nonzero ? CAIRO_FILL_RULE_WINDING
                                                                                 : CAIRO_FILL_RULE_EVEN_ODD);
            set_paint(cairo, *shape.fill);
            cairo_fill(cairo);
        }
        if (!shape.stroke) continue;
        cairo_save(cairo);
        if (shape.stroke_clip) {
            cairo_new_path(cairo);
            for (const Region& region : *shape.stroke_clip) {
                add(cairo, path_through(region.outer, true));
                for (const Polygon& hole : region.holes) add(cairo, path_through(hole, true));
            }
            cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
            cairo_clip(cairo);
        }
        cairo_new_path(cairo);
        for (const Path& path : svg::stroked_paths(shape)) add(cairo, path);
        cairo_set_line_width(cairo, shape.stroke_width);
        cairo_set_line_cap(cairo, shape.cap == svg::LineCap::butt    ? CAIRO_LINE_CAP_BUTT
                                  : shape.cap == svg::LineCap::round ? CAIRO_LINE_CAP_ROUND
                                                                     : CAIRO_LINE_CAP_SQUARE);
        cairo_set_line_join(cairo, shape.join == svg::LineJoin::miter   ? CAIRO_LINE_JOIN_MITER
                                   : shape.join == svg::LineJoin::round ? CAIRO_LINE_JOIN_ROUND
                                                                        : CAIRO_LINE_JOIN_BEVEL);
        cairo_set_miter_limit(cairo, 4);
        set_paint(cairo, *shape.stroke);
        cairo_stroke(cairo);
        cairo_restore(cairo);
    }
    return surface;
}

Surface theirs(const std::string& text, int width, int height) {
    GError* error = nullptr;
    const std::unique_ptr<RsvgHandle, Release> handle(
        rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(text.data()), text.size(), &error));
    if (!handle) {
        g_clear_error(&error);
        return nullptr;
    }
    rsvg_handle_set_dpi(handle.get(), 96);
    Surface surface = white_sheet(width, height);
    const Cairo cairo(cairo_create(surface.get()));
    const RsvgRectangle viewport{0, 0, static_cast<double>(width), static_cast<double>(height)};
    if (!rsvg_handle_render_document(handle.get(), cairo.get(), &viewport, &error)) {
        g_clear_error(&error);
        return nullptr;
    }
    return surface;
}

double coverage(const unsigned char* pixel) {
    const int least = std::min({pixel[0], pixel[1], pixel[2]});
    return std::min(1.0, (255 - least) / full_coverage);
}

double ratio(cairo_surface_t* a, cairo_surface_t* b) {
    cairo_surface_flush(a);
    cairo_surface_flush(b);
    double least = 0, most = 0;
    const int stride = cairo_image_surface_get_stride(a), height = cairo_image_surface_get_height(a);
    const unsigned char *rows_a = cairo_image_surface_get_data(a), *rows_b = cairo_image_surface_get_data(b);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < cairo_image_surface_get_width(a); ++x) {
            const double p = coverage(rows_a + y * stride + 4 * x), q = coverage(rows_b + y * stride + 4 * x);
            least += std::min(p, q);
            most += std::max(p, q);
        }
    return most > 0 ? least / most : 1;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string told(const Warnings& warnings) {
    std::string all;
    for (const Warning& warning : warnings) all += (all.empty() ? "" : " | ") + sentence(warning);
    std::ranges::replace_if(
        all, [](char c) { return c == '\t' || c == '\n'; }, ' ');
    return all;
}

void compare(const char* file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    std::printf("%s\t", file);
    std::fflush(stdout);
    auto start = std::chrono::steady_clock::now();
    const auto document = svg::read(text.str(), {.dpi = 96});
    const double reading = seconds_since(start);
    if (!document) {
        std::printf("refused\t\t%.3f\t\t%s\n", reading, sentence(document.error()).c_str());
        return;
    }
    if (document->shapes.empty()) {
        std::printf("no shapes\t\t%.3f\t\t%s\n", reading, told(document->warnings).c_str());
        return;
    }
    start = std::chrono::steady_clock::now();
    const auto drawing = make_drawing(*document, *builtin_robot("beachbot"), {});
    const double drawn = seconds_since(start);
    static_cast<void>(drawing);  // refused or not: its time counts here

    const double larger = std::max(document->view.width(), document->view.height());
    const auto side = [&](double units) {
        return std::max(1, static_cast<int>(std::lround(pixels * units / larger)));
    };
    const int width = side(document->view.width()), height = side(document->view.height());
    const Surface a = ours(*document, width, height), b = theirs(text.str(), width, height);
    if (!b)
        std::printf("librsvg refuses\t\t%.3f\t%.3f\t%s\n", reading, drawn, told(document->warnings).c_str());
    else
        std::printf("read\t%.4f\t%.3f\t%.3f\t%s\n", ratio(a.get(), b.get()), reading, drawn,
                    told(document->warnings).c_str());
}

}  // namespace

int main(int count, char** files) {
    for (int i = 1; i < count; ++i) compare(files[i]);
    return EXIT_SUCCESS;
}
