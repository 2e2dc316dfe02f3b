#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/text.hpp"

namespace strandline::cli {
namespace {

// More of one kind than this is summed up, not listed, unless asked for.
constexpr std::size_t most_listed = 8;

std::string scale_text(const Plan& plan) {
    const Drawing& d = plan.drawing;
    std::string text = fmt::format("1 user unit = {:.4g} m", d.scale);
    if (d.scale_denominator) {
        const double n = *d.scale_denominator;
        text += n >= 1 ? fmt::format(", 1:{:.4g}", n) : fmt::format(", {:.4g}:1", 1 / n);
    }
    return fmt::format("{}; canvas {:g} x {:g} m", text, d.canvas.width, d.canvas.height);
}

std::string corners(const Figures& f) {
    return fmt::format("{} exact, {} rounded, {} looped, {} turned on the spot", f.corners_exact,
                       f.corners_rounded, f.corners_looped, f.corners_pivoted);
}

}  // namespace

std::string duration(double seconds) {
    const int whole = static_cast<int>(std::lround(seconds));
    return whole >= 3600 ? fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60)
                         : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

std::string length(double metres) {
    const bool small = metres > 0 && metres < 0.1;
    return small ? fmt::format("{:.3g} mm", 1000 * metres) : fmt::format("{:.2f} m", metres);
}

std::string square(double area, int decimals) {
    const bool small = area > 0 && area < 0.1;
    return small ? fmt::format("{:.3g} cm^2", 1e4 * area) : fmt::format("{:.{}f} m^2", area, decimals);
}

std::string summary(const Plan& plan, const check::Report& report) {
    const Figures& f = plan.figures;
    std::string text;
    const auto row = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<12} {}\n", name, value);
    };
    row("scale", scale_text(plan));
    row("robot", plan.robot.name);
    row("elements", fmt::format("{}, {}; {}", counted(f.lines, "line"), counted(f.regions, "area"),
                                counted(f.strokes, "stroke")));
    const DrawingCounts& c = plan.drawing.counts;
    row("drawing", fmt::format("{}; {} joined, {}, {} merged, {} cut; left out: {} hidden, "
                               "{} bare, {} too short, "
                               "{} too small{}",
                               counted(c.shapes, "shape"), c.joined, counted(c.duplicates, "duplicate"),
                               c.merged, c.cut, c.hidden, c.bare, c.too_short, c.too_small,
                               c.unchosen > 0 ? fmt::format(", {} not chosen", c.unchosen) : ""));
    row("drawn", fmt::format("{:.2f} m of rake path", f.drawn));
    row("rake up",
        fmt::format("{:.2f} m straight / {:.2f} m Dubins bound / {:.2f} m driven{}", f.up_straight,
                    f.up_dubins, f.up_driven,
                    f.loops_driven > 0 ? fmt::format(" + {:.2f} m in corner loops", f.loops_driven) : ""));
    if (f.in_driven + f.out_driven > 0)
        row("in and out", fmt::format("{:.2f} m of that to the first stroke, {:.2f} m from the last one",
                                      f.in_driven, f.out_driven));
    row("order", std::string(f.tour_proven ? "proven optimal for straight gaps" : "searched") +
                     (f.tour_parts > 0
                          ? fmt::format(" in {}, {:.2f} m longer (straight)",
                                        counted(f.tour_parts, "part of neighbours", "parts of neighbours"),
                                        f.tour_longer)
                          : "") +
                     (f.reproducible ? "" : ", stopped early: not reproducible"));
    row("time", duration(f.time));
    if (f.regions > 0) {
        row("fills",
            fmt::format("as planned {:.2f} % raked, {:.2f} % twice, {:.2f} % outside; length x width / "
                        "area {:.3f}; {}, {} over finished sand; {}",
                        100 * f.fill_coverage, 100 * f.fill_overdraw, 100 * f.fill_spill,
                        f.fill_area > 0 ? f.fill_swept / f.fill_area : 0, counted(f.fill_hops, "hop"),
                        counted(f.fill_drives_over, "drive"), counted(plan.bare.size(), "bare place")));
        row("areas", fmt::format("as driven {:.1f} % raked, {:.1f} % twice, {:.1f} % outside; {}",
                                 100 * report.coverage, 100 * report.overdraw, 100 * report.spill,
                                 counted(report.bare.size(), "bare place")));
    }
    row("blemishes", fmt::format("{} of finished lines; {} over finished areas between strokes; {} of "
                                 "finished sand driven over in all",
                                 counted(report.crossings, "crossing"), length(report.over_finished),
                                 square(report.driven_over)));
    row("corners", corners(f));
    row("tightest", plan.robot.min_radius > 0
                        ? fmt::format("{:.2f} 1/m rake up (limit {:.2f}), {:.2f} 1/m drawing", f.tightest_up,
                                      1 / plan.robot.min_radius, f.tightest_drawn)
                        : "turns on the spot");
    for (const Stop& stop : plan.stops)
        row("stop",
            fmt::format("{}: before stroke {}, after {}", stop.why, stop.stroke, duration(stop.time)));
    row("fallbacks", fmt::format("{}; {} joined directly; {} that cannot be driven", f.fallbacks,
                                 counted(f.direct, "gap"), counted(plan.undrivable.size(), "span")));
    row("warnings", fmt::format("{}", plan.warnings.size() + plan.idle_edits.size()));
    row("check", report.sound() ? "sound" : counted(report.faults.size(), "fault"));
    return text;
}

std::string places(const Plan& plan, const check::Report& report, bool all) {
    const std::size_t warned_of = plan.blemishes.size() + plan.undrivable.size();
    if (!all && warned_of > 0)
        return fmt::format("note: {} places of the warnings: -v lists all\n", warned_of);
    std::string text;
    if (!all) return text;
    for (const Spot& spot : plan.bare)
        text += fmt::format("bare as planned: {} of {} at ({:.2f}, {:.2f})\n", square(spot.amount), spot.what,
                            spot.at.x, spot.at.y);
    for (const check::Bare& bare : report.bare)
        text += fmt::format("bare as driven: {} of {} at ({:.2f}, {:.2f})\n", square(bare.area),
                            plan.drawing.elements[static_cast<std::size_t>(bare.element)].id, bare.at.x,
                            bare.at.y);
    for (const Spot& spot : plan.blemishes)
        text += fmt::format("blemish as planned: at ({:.2f}, {:.2f}): {} ({:.2f})\n", spot.at.x, spot.at.y,
                            spot.what, spot.amount);
    for (const Spot& spot : plan.undrivable)
        text += fmt::format("not drivable: at ({:.2f}, {:.2f}): {} ({:.2f})\n", spot.at.x, spot.at.y,
                            spot.what, spot.amount);
    return text;
}

std::string shortcomings(const Plan& plan, const check::Report& report) {
    std::string text;
    const auto say = [&](std::size_t count, std::string_view sentence, const std::string& one,
                         const std::string& many = "") {
        if (count > 0)
            text +=
                fmt::format("strict: {}\n", fmt::format(fmt::runtime(sentence), counted(count, one, many)));
    };
    say(report.faults.size(), "check finds {}", "fault");
    say(static_cast<std::size_t>(plan.figures.fallbacks), "{} done otherwise than asked: see the warnings",
        "thing is", "things are");
    say(plan.undrivable.size(), "along {} the rake cannot follow its path (-v lists them)", "span");
    say(plan.idle_edits.size(), "{} no place: see the warnings", "edit finds", "edits find");
    say(report.blemishes.size(),
        "finished sand is driven over, or finished lines are crossed, at {} (strandline check -v lists them)",
        "place");
    return text;
}

std::string findings(const check::Report& report, bool all) {
    std::string text;
    std::size_t listed = 0;
    for (const check::Fault& fault : report.faults) {
        if (!all && ++listed > most_listed) {
            text += fmt::format("fault: and {} more (strandline check --verbose lists all)\n",
                                report.faults.size() - most_listed);
            break;
        }
        text += fmt::format("fault: {} at ({:.2f}, {:.2f}): {}\n", check::name_of(fault.law), fault.at.x,
                            fault.at.y, fault.what);
    }
    return text;
}

}  // namespace strandline::cli
