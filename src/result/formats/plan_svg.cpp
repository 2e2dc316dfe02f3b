// A plan as an SVG picture: true to scale, y turned down, as SVG has it.
#include <cmath>

#include "base/text/text.hpp"
#include "result/formats/formats.hpp"
#include "result/sketch/sketch.hpp"

namespace strandline::formats {
namespace {

using sketch::LegendItem;
using sketch::Sketch;

constexpr int decimals = 2;
constexpr double pixels = 1000;  // of the picture's width
constexpr const char* fence = "#6b2f8f";
constexpr const char *sand = "#efe3c8", *down = "#000", *up = "#d3261a", *start = "#1f8a3b", *end = "#1b4f9c";

/// User units a metre: the power of ten that makes the picture 1,000 to 10,000 units wide. A beach is drawn
/// in centimetres, a sheet of paper in tenths of a millimetre.
double units_for(double width) { return std::pow(10, std::ceil(3 - std::log10(width))); }

class SvgWriter {
  public:
    SvgWriter(Text& out, const Sketch& sketch)
        : out_(out), sketch_(sketch), units_(units_for(sketch.view.width())) {}
    double units(double metres) const { return metres * units_; }

    template <class... Pieces>
    SvgWriter& put(const Pieces&... pieces) {
        (piece(pieces), ...);
        return *this;
    }
    double x(Point p) const { return units(p.x - sketch_.view.low.x); }
    double y(Point p) const { return units(sketch_.view.high.y - p.y); }
    double em(double share = 1) const { return units(sketch_.em * share); }

    void path(const Polyline& track) {
        const char* command = "M";
        for (Point p : track) {
            put(command, x(p), " ", y(p));
            command = "L";
        }
    }
    void area(const Polygon& polygon) {
        path(polygon);
        put("Z");
    }
    void box(Box b) {
        put("x=\"", x(b.low), "\" y=\"", y(b.high), "\" width=\"", units(b.width()), "\" height=\"",
            units(b.height()), "\"");
    }
    void text(Point at, double size, std::string_view content, const char* more = "") {
        put("<text x=\"", x(at), "\" y=\"", y(at), "\" font-size=\"", size, "\"", more, ">");
        escaped(content);
        put("</text>\n");
    }
    void escaped(std::string_view content) { add_xml(out_, content); }

  private:
    void piece(std::string_view text) { add(out_, text); }
    void piece(double value) { add_fixed(out_, value, decimals); }

    Text& out_;
    const Sketch& sketch_;
    double units_;
};

void write_grooves(SvgWriter& out, const Plan& plan, const Sketch& sketch) {
    out.put("<g id=\"rake-down\" fill=\"none\" stroke=\"", down,
            "\" stroke-linecap=\"butt\" stroke-linejoin=\"round\">\n");
    for (const sketch::Groove& groove : sketch.grooves) {
        out.put("<path stroke-width=\"", out.units(groove.width), "\" d=\"");
        out.path(sketch::bar_track(plan.samples, groove.run, groove.offset));
        out.put("\"/>\n");
    }
    out.put("</g>\n");
}

void write_trips(SvgWriter& out, const Sketch& sketch) {
    out.put("<g id=\"rake-up\" fill=\"none\" stroke=\"", up, "\" stroke-width=\"", out.em(0.12), "\">\n");
    for (const sketch::Trip& trip : sketch.trips) {
        out.put("<path d=\"");
        out.path(trip.track);
        out.put("\"/>\n");
    }
    out.put("</g>\n<g id=\"arrows\" fill=\"", up, "\">\n");
    for (const sketch::Trip& trip : sketch.trips)
        for (const Pose& arrow : trip.arrows) {
            out.put("<path d=\"");
            out.area(sketch::arrow_head(arrow, 0.8 * sketch.em));
            out.put("\"/>\n");
        }
    out.put("</g>\n");
}

void write_fences(SvgWriter& out, const Sketch& sketch) {
    if (sketch.keep_outs.empty() && sketch.border.empty()) return;
    out.put("<g id=\"field\" stroke=\"", fence, "\" stroke-width=\"", out.em(0.12), "\">\n");
    for (const Region& keep_out : sketch.keep_outs) {
        out.put("<path fill=\"", fence, "\" fill-opacity=\"0.25\" fill-rule=\"evenodd\" d=\"");
        out.area(keep_out.outer);
        for (const Polygon& hole : keep_out.holes) out.area(hole);
        out.put("\"/>\n");
    }
    if (!sketch.border.empty()) {
        out.put("<path fill=\"none\" stroke-dasharray=\"", out.em(0.6), "\" d=\"");
        out.area(sketch.border);
        out.put("\"/>\n");
    }
    out.put("</g>\n");
}

void write_start(SvgWriter& out, Point at) {
    out.put("<circle cx=\"", out.x(at), "\" cy=\"", out.y(at), "\" r=\"", out.em(0.45), "\" fill=\"", start,
            "\" stroke=\"#fff\" stroke-width=\"", out.em(0.1), "\"/>\n");
}
void write_end(SvgWriter& out, const Sketch& sketch, Point at) {
    out.put("<rect ");
    out.box(grown({at, at}, 0.4 * sketch.em));
    out.put(" fill=\"", end, "\" stroke=\"#fff\" stroke-width=\"", out.em(0.1), "\"/>\n");
}

void write_sign(SvgWriter& out, const Sketch& sketch, const LegendItem& item) {
    const Point from = item.at, to = from + Point{item.sign_width, 0}, middle = between(from, to, 0.5);
    const auto line = [&](const char* colour, double width) {
        out.put("<path fill=\"none\" stroke=\"", colour, "\" stroke-width=\"", width, "\" d=\"");
        out.path({from, to});
        out.put("\"/>\n");
    };
    switch (item.sign) {
        case LegendItem::Sign::groove:
            line(down, out.em(0.7));
            break;
        case LegendItem::Sign::trip:
            line(up, out.em(0.12));
            out.put("<path fill=\"", up, "\" d=\"");
            out.area(sketch::arrow_head({middle, 0}, 0.8 * sketch.em));
            out.put("\"/>\n");
            break;
        case LegendItem::Sign::start:
            write_start(out, middle);
            break;
        case LegendItem::Sign::end:
            write_end(out, sketch, middle);
            break;
        case LegendItem::Sign::keep_out:
            out.put("<rect ");
            out.box({from - Point{0, 0.4 * sketch.em}, to + Point{0, 0.4 * sketch.em}});
            out.put(" fill=\"", fence, "\" fill-opacity=\"0.25\" stroke=\"", fence, "\" stroke-width=\"",
                    out.em(0.12), "\"/>\n");
            break;
        case LegendItem::Sign::border:
            out.put("<path fill=\"none\" stroke=\"", fence, "\" stroke-width=\"", out.em(0.12),
                    "\" stroke-dasharray=\"", out.em(0.6), "\" d=\"");
            out.path({from, to});
            out.put("\"/>\n");
            break;
        case LegendItem::Sign::rule: {
            line(down, out.em(0.1));
            const Point tick{0, 0.3 * sketch.em};
            for (const Point p : {from, to}) {
                out.put("<path stroke=\"", down, "\" stroke-width=\"", out.em(0.1), "\" d=\"");
                out.path({p - tick, p + tick});
                out.put("\"/>\n");
            }
        }
    }
}

}  // namespace

std::string write_svg(const Plan& plan) {
    const Sketch sketch = sketch::sketched(plan);
    Text text;
    if (!sketch::drawable(sketch))
        return "<svg xmlns=\"http://www.w3.org/2000/svg\"><title>a canvas without extent</title></svg>\n";
    SvgWriter out(text, sketch);
    const double width = sketch.view.width(), height = sketch.view.height();
    out.put("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", pixels, "\" height=\"",
            pixels * height / width, "\" viewBox=\"0 0 ", out.units(width), " ", out.units(height),
            "\" role=\"img\" aria-labelledby=\"title desc\">\n<title id=\"title\">");
    out.escaped(plan.title.empty() ? "Plan" : plan.title);
    out.put("</title>\n<desc id=\"desc\">What a raking robot draws, in driving order, seen from above. ");
    out.escaped(sketch.caption);
    out.put(". ", out.units(1),
            " units are a metre.</desc>\n<rect width=\"100%\" height=\"100%\" "
            "fill=\"#e3d5b4\"/>\n<rect ");
    out.box(sketch.canvas);
    out.put(" fill=\"", sand, "\" stroke=\"#b9a67c\" stroke-width=\"", out.em(0.06), "\"/>\n");
    write_grooves(out, plan, sketch);
    write_fences(out, sketch);
    write_trips(out, sketch);
    if (sketch.driven) {
        write_end(out, sketch, sketch.end);
        write_start(out, sketch.start.at);
    }
    out.put("<g id=\"legend\" font-family=\"sans-serif\" fill=\"#2b2418\">\n");
    out.text(sketch.title_at, out.em(1.1), sketch.title, " font-weight=\"bold\"");
    out.text(sketch.caption_at, out.em(0.95), sketch.caption);
    for (const LegendItem& item : sketch.legend) {
        write_sign(out, sketch, item);
        out.text(item.text_at, out.em(0.95), item.text);
    }
    out.put("</g>\n</svg>\n");
    return text;
}

}  // namespace strandline::formats
