// What a simulation found, for a person.
#include <fmt/format.h>

#include <algorithm>

#include "base/text/text.hpp"
#include "summary.hpp"

namespace strandline::cli {
namespace {

constexpr double centimetres = 100;

std::string row(std::string_view name, const std::string& value) {
    return fmt::format("  {:<12} {}\n", name, value);
}

}  // namespace

std::string fidelity_rows(const fidelity::Report& r) {
    std::string text;
    text += row("likeness", fmt::format("intersection over union {:.4f}; {} not raked, {} raked "
                                        "where it should be clean; cells of {:.3g} cm",
                                        r.intersection_over_union, square(r.missing), square(r.stray),
                                        centimetres * r.cell));
    if (r.fill_area > 0)
        text += row("areas",
                    fmt::format("intersection over union {:.4f}: {:.2f} % raked, {:.2f} % outside; along the "
                                "border {:.2f} cm over, {:.2f} cm missing (per metre, cm)",
                                r.fill_union, centimetres * r.coverage, centimetres * r.spill, r.border_over,
                                r.border_missing));
    const bool fine = std::max(r.lateral_max, r.width_error) < 1e-3;  // a pen on paper
    const double unit = fine ? 1000 : centimetres;
    if (r.line_length > 0)
        text +=
            row("lines",
                fmt::format("aside {:.2f} {} in the mean, {:.2f} rms, {:.2f} at most; width off by {:.2f} "
                            "{} ({:+.2f}); {:.1f} of {:.1f} m not drawn",
                            unit * r.lateral_mean, fine ? "mm" : "cm", unit * r.lateral_rms,
                            unit * r.lateral_max, unit * r.width_error, fine ? "mm" : "cm",
                            unit * r.width_bias, r.undrawn, r.line_length));
    text += row("tracks", fmt::format("{} on areas, {} on lines, {} on clean sand", square(r.track_on_fill),
                                      square(r.track_on_line), square(r.track)));
    return text;
}

std::string legibility_rows(const Drawing& drawing, const legibility::Report& report, bool all) {
    if (report.details.empty()) return "";
    std::string text =
        row("legibility",
            fmt::format("{}{} finer than the rake; all survive on a canvas of "
                        "{:.1f} x {:.1f} m",
                        report.whole ? "" : "at least ",
                        counted(report.details.size(), "detail is", "details are"),
                        report.factor * drawing.canvas.width, report.factor * drawing.canvas.height));
    if (!all) return text;
    const auto name = [&](int element) { return drawing.elements[static_cast<std::size_t>(element)].id; };
    for (const legibility::Detail& detail : report.details)
        text += fmt::format("  {} at ({:.2f}, {:.2f}): {}, {:.3g} cm where {:.3g} cm are needed\n",
                            detail.other < 0
                                ? name(detail.element)
                                : fmt::format("{} beside {}", name(detail.element), name(detail.other)),
                            detail.at.x, detail.at.y, legibility::meaning_of(detail.kind),
                            centimetres * detail.width, centimetres * detail.needed);
    return text;
}

std::string simulated(const formats::Simulated& found, bool all) {
    std::string text = fidelity_rows(found.fidelity);
    if (found.same_sand)
        text += row("same sand", fmt::format("intersection over union {:.4f} with that plan's own sand",
                                             *found.same_sand));
    text += row("time",
                duration(found.time) +
                    (found.planned_time ? fmt::format(" (planned {})", duration(*found.planned_time)) : ""));
    if (found.driven != nullptr)
        text +=
            row("controller", fmt::format("rake off its path by {:.2f} cm rms, {:.2f} cm at most{}",
                                          centimetres * found.driven->rms, centimetres * found.driven->most,
                                          found.driven->lost ? "; it fell behind and was stopped" : ""));
    constexpr std::size_t most_listed = 8;
    std::size_t listed = 0;
    for (const fidelity::Place& place : found.fidelity.places) {
        if (!all && ++listed > most_listed) {
            text += fmt::format("  and {} more places (-v lists all)\n",
                                found.fidelity.places.size() - most_listed);
            break;
        }
        text += fmt::format("  {:<16} {} at ({:.2f}, {:.2f})\n", fidelity::name_of(place.flaw),
                            square(place.area, 3), place.at.x, place.at.y);
    }
    return text;
}

}  // namespace strandline::cli
