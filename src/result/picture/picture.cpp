// Paints a sketch by cairo: raked sand seen from above.
#include "result/picture/picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "result/picture/page.hpp"
#include "result/sketch/sketch.hpp"

namespace strandline::picture {
namespace {

using sketch::LegendItem;
using sketch::Sketch;

constexpr int least_pixels = 64,
              most_pixels = 16'000;  // cairo's images end at 32767; 16000 x 16000 take 1 GB

struct Colour {
    double r, g, b, a = 1;
};
constexpr Colour beach{0.875, 0.812, 0.675}, canvas{0.937, 0.886, 0.769}, canvas_edge{0.70, 0.62, 0.46};
constexpr Colour grain_dark{0.45, 0.36, 0.20, 0.16}, grain_light{1, 0.98, 0.92, 0.35};
constexpr Colour berm{0.99, 0.955, 0.87, 0.6}, groove{0.13, 0.105, 0.08}, ridge{0.80, 0.70, 0.53, 0.48};
constexpr Colour up{0.83, 0.13, 0.09}, start{0.10, 0.56, 0.24}, end{0.10, 0.32, 0.66}, white{1, 1, 1};
constexpr Colour ink{0.17, 0.14, 0.09}, fence{0.42, 0.18, 0.56}, fenced{0.42, 0.18, 0.56, 0.25};

class Painter {
  public:
    Painter(cairo_t* cr, const Sketch& sketch, double scale) : cr_(cr), sketch_(sketch), scale_(scale) {}

    double em(double share = 1) const { return share * sketch_.em * scale_; }
    double pixels(double metres) const { return metres * scale_; }
    double x(Point p) const { return (p.x - sketch_.view.low.x) * scale_; }
    double y(Point p) const { return (sketch_.view.high.y - p.y) * scale_; }

    void colour(Colour c) { cairo_set_source_rgba(cr_, c.r, c.g, c.b, c.a); }
    void trace(const Polyline& track) {
        for (Point p : track) cairo_line_to(cr_, x(p), y(p));
    }
    void line(const Polyline& track, double width, Colour c) {
        if (track.size() < 2) return;
        cairo_new_path(cr_);
        trace(track);
        cairo_set_line_width(cr_, width);
        colour(c);
        cairo_stroke(cr_);
    }
    void area(const Polygon& polygon, Colour c) {
        cairo_new_path(cr_);
        trace(polygon);
        cairo_close_path(cr_);
        colour(c);
        cairo_fill(cr_);
    }
    void rectangle(Box box) {
        cairo_rectangle(cr_, x(box.low), y(box.high), pixels(box.width()), pixels(box.height()));
    }
    void outlined(Colour fill) {
        colour(fill);
        cairo_fill_preserve(cr_);
        cairo_set_line_width(cr_, em(0.12));
        colour(white);
        cairo_stroke(cr_);
    }
    void text(Point at, double size, const std::string& content, bool bold = false) {
        cairo_select_font_face(cr_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                               bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cr_, size);
        colour(ink);
        cairo_move_to(cr_, x(at), y(at));
        cairo_show_text(cr_, content.c_str());
    }
    cairo_t* cairo() { return cr_; }

  private:
    cairo_t* cr_;
    const Sketch& sketch_;
    double scale_;
};

void paint_ground(Painter& paint, const Sketch& sketch) {
    paint.colour(beach);
    cairo_paint(paint.cairo());
    paint.rectangle(sketch.canvas);
    paint.colour(canvas);
    cairo_fill_preserve(paint.cairo());
    paint.colour(canvas_edge);
    cairo_set_line_width(paint.cairo(), paint.em(0.06));
    cairo_stroke(paint.cairo());
}

/// Grains of sand: always the same ones, from a small generator of our own (Vigna, xorshift64*).
void paint_grains(Painter& paint, const Sketch& sketch) {
    std::uint64_t state = 0x9E3779B97F4A7C15U;
    const auto uniform = [&state] {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        return static_cast<double>((state * 0x2545F4914F6CDD1DU) >> 11) * 0x1p-53;
    };
    const Box view = sketch.view;
    const double grain = 0.055;  // em
    const double count = std::min(30'000.0, 1.2 * view.width() * view.height() / (sketch.em * sketch.em));
    for (double k = 0; k < count; ++k) {
        const double across = uniform(), along = uniform(), size = paint.em(grain * (0.6 + uniform()));
        const Point at{view.low.x + across * view.width(), view.low.y + along * view.height()};
        cairo_rectangle(paint.cairo(), paint.x(at), paint.y(at), size, size);
        paint.colour(std::fmod(k, 2) < 1 ? grain_dark : grain_light);
        cairo_fill(paint.cairo());
    }
}

/// Sand thrown up on both sides, the groove of each pin, and the fine ridges that stay between pins.
void paint_grooves(Painter& paint, const Plan& plan, const Sketch& sketch) {
    cairo_set_line_cap(paint.cairo(), CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(paint.cairo(), CAIRO_LINE_JOIN_ROUND);
    const double pitch = plan.robot.pin_pitch;
    const auto track = [&](const sketch::Groove& g, double offset) {
        return sketch::bar_track(plan.samples, g.run, g.offset + offset);
    };
    const auto element = [&](const sketch::Groove& g) {
        const bool known = g.run.stroke >= 0 && g.run.stroke < static_cast<int>(plan.strokes.size());
        return known ? plan.strokes[static_cast<std::size_t>(g.run.stroke)].element : -1;
    };
    std::size_t bermed = 0;
    for (std::size_t i = 0; i < sketch.grooves.size(); ++i) {
        const sketch::Groove& g = sketch.grooves[i];
        // Of one element first of all: what its passes throw up on each other would look half raked.
        for (; bermed < sketch.grooves.size() && element(sketch.grooves[bermed]) == element(g); ++bermed)
            paint.line(track(sketch.grooves[bermed], 0),
                       paint.pixels(sketch.grooves[bermed].width) + 2 * paint.em(0.09), berm);
        // Pin by pin: in a curve the bar stands skew and the band is narrower than its pins side by side.
        constexpr double overlap = 1.06;  // no hairline of sand between neighbours
        for (int pin = 0; pin < g.pins; ++pin)
            paint.line(track(g, ((g.pins - 1) / 2.0 - pin) * pitch), paint.pixels(pitch) * overlap, groove);
        if (paint.pixels(pitch) < 2.5) continue;  // finer than the picture can show
        for (int gap = 1; gap < g.pins; ++gap)
            paint.line(track(g, (g.pins / 2.0 - gap) * pitch), std::max(0.5, 0.16 * paint.pixels(pitch)),
                       ridge);
    }
}

void paint_trips(Painter& paint, const Sketch& sketch) {
    for (const sketch::Trip& trip : sketch.trips) paint.line(trip.track, paint.em(0.11), up);
    for (const sketch::Trip& trip : sketch.trips)
        for (const Pose& arrow : trip.arrows) paint.area(sketch::arrow_head(arrow, 0.85 * sketch.em), up);
}

void dashed(Painter& paint, const Polyline& line) {
    const double dash = paint.em(0.6);
    cairo_set_dash(paint.cairo(), &dash, 1, 0);
    paint.line(line, paint.em(0.12), fence);
    cairo_set_dash(paint.cairo(), nullptr, 0, 0);
}

void paint_fences(Painter& paint, const Sketch& sketch) {
    for (const Region& keep_out : sketch.keep_outs) {
        cairo_new_path(paint.cairo());
        const auto ring = [&](const Polygon& outline) {
            cairo_new_sub_path(paint.cairo());
            paint.trace(outline);
            cairo_close_path(paint.cairo());
        };
        ring(keep_out.outer);
        for (const Polygon& hole : keep_out.holes) ring(hole);
        cairo_set_fill_rule(paint.cairo(), CAIRO_FILL_RULE_EVEN_ODD);
        paint.colour(fenced);
        cairo_fill_preserve(paint.cairo());
        cairo_set_fill_rule(paint.cairo(), CAIRO_FILL_RULE_WINDING);
        paint.colour(fence);
        cairo_set_line_width(paint.cairo(), paint.em(0.12));
        cairo_stroke(paint.cairo());
    }
    Polyline border = sketch.border;
    if (border.empty()) return;
    border.push_back(border.front());
    dashed(paint, border);
}

void paint_start(Painter& paint, Point at) {
    cairo_new_path(paint.cairo());
    cairo_arc(paint.cairo(), paint.x(at), paint.y(at), paint.em(0.48), 0, 2 * pi);
    paint.outlined(start);
}
void paint_end(Painter& paint, const Sketch& sketch, Point at) {
    paint.rectangle(grown({at, at}, 0.42 * sketch.em));
    paint.outlined(end);
}

void paint_sign(Painter& paint, const Sketch& sketch, const LegendItem& item) {
    const Point from = item.at, to = from + Point{item.sign_width, 0}, middle = between(from, to, 0.5);
    switch (item.sign) {
        case LegendItem::Sign::groove:
            paint.line({from, to}, paint.em(0.9), berm);
            paint.line({from, to}, paint.em(0.7), groove);
            break;
        case LegendItem::Sign::trip:
            paint.line({from, to}, paint.em(0.11), up);
            paint.area(sketch::arrow_head({middle, 0}, 0.85 * sketch.em), up);
            break;
        case LegendItem::Sign::start:
            paint_start(paint, middle);
            break;
        case LegendItem::Sign::end:
            paint_end(paint, sketch, middle);
            break;
        case LegendItem::Sign::keep_out: {
            const Point high{0, 0.4 * sketch.em};
            paint.area({from - high, to - high, to + high, from + high}, fenced);
            paint.line({from - high, to - high, to + high, from + high, from - high}, paint.em(0.12), fence);
            break;
        }
        case LegendItem::Sign::border:
            dashed(paint, {from, to});
            break;
        case LegendItem::Sign::rule: {
            const Point tick{0, 0.3 * sketch.em};
            paint.line({from, to}, paint.em(0.12), ink);
            paint.line({from - tick, from + tick}, paint.em(0.12), ink);
            paint.line({to - tick, to + tick}, paint.em(0.12), ink);
        }
    }
}

void paint_all(Painter& paint, const Plan& plan, const Sketch& sketch) {
    paint_grooves(paint, plan, sketch);
    paint_fences(paint, sketch);
    paint_trips(paint, sketch);
    if (sketch.driven) {
        paint_end(paint, sketch, sketch.end);
        paint_start(paint, sketch.start.at);
    }
    paint.text(sketch.title_at, paint.em(1.1), sketch.title, true);
    paint.text(sketch.caption_at, paint.em(0.95), sketch.caption);
    for (const LegendItem& item : sketch.legend) {
        paint_sign(paint, sketch, item);
        paint.text(item.text_at, paint.em(0.95), item.text);
    }
}

}  // namespace

Outcome<std::string> png(const Plan& plan, const Look& look) {
    if (look.pixels < least_pixels || look.pixels > most_pixels)
        return fail("picture", fmt::format("{} pixels are out of range", look.pixels),
                    fmt::format("use {} to {}", least_pixels, most_pixels));
    const Sketch sketch = sketch::sketched(plan, {.arrows = look.arrows, .legend = look.legend});
    if (!sketch::drawable(sketch))
        return fail("picture", "the canvas has no extent, or too much", "check its size");
    const double width = sketch.view.width(), height = sketch.view.height();
    const double scale = look.pixels / std::max(width, height);
    const int columns = std::max(1, static_cast<int>(std::lround(width * scale)));
    const int rows = std::max(1, static_cast<int>(std::lround(height * scale)));

    const Page page(columns, rows);
    Painter paint(page.cairo(), sketch, scale);
    paint_ground(paint, sketch);
    paint_grains(paint, sketch);
    paint_all(paint, plan, sketch);
    return page.png();
}

Outcome<std::string> pdf(const Plan& plan, const Look& look) {
    constexpr double longest_side = 0.42;  // m: A3
    constexpr double points = 72 / 0.0254;
    Sketch sketch = sketch::sketched(plan, {.arrows = look.arrows, .legend = look.legend});
    if (!sketch::drawable(sketch))
        return fail("picture", "the canvas has no extent, or too much", "check its size");
    const double width = sketch.view.width(), height = sketch.view.height();
    double scale = 1;  // 1 : this
    for (int step = 0; std::max(width, height) / scale > longest_side; ++step)
        scale *= step % 3 == 1 ? 2.5 : 2;
    sketch.caption += fmt::format(", 1:{:.0f}", scale);
    Paper paper(points * width / scale, points * height / scale, plan.title);
    Painter paint(paper.cairo(), sketch, points / scale);
    paint_ground(paint, sketch);
    paint_all(paint, plan, sketch);
    return paper.pdf();
}

}  // namespace strandline::picture
