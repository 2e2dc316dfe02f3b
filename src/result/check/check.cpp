#include "result/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "result/check/enclosure.hpp"
#include "result/check/faults.hpp"
#include "result/sand/sand.hpp"

namespace strandline::check {
namespace {

bool all_finite(std::initializer_list<double> numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}
bool finite(const Pose& pose) { return is_finite(pose.at) && std::isfinite(pose.heading); }
bool finite(const Sample& s) {
    return finite(s.pose) && is_finite(s.rake) && all_finite({s.t, s.curvature, s.speed, s.turn_rate});
}
bool finite(const Curve& curve) {
    return finite(curve.start) && std::ranges::all_of(curve.pieces, [](const Clothoid& c) {
               return all_finite({c.length, c.curvature, c.sharpness});
           });
}
bool finite(const Robot& r) {
    return all_finite({r.rake_offset, r.rake_side, r.pin_pitch, r.min_radius, r.left_radius, r.right_radius,
                       r.sharpness, r.speed, r.travel_speed, r.acceleration, r.turn_rate, r.turn_acceleration,
                       r.lift_delay, r.setback, r.fix_noise, r.front, r.back, r.half_width}) &&
           std::ranges::all_of(r.wheels,
                               [](const Wheel& w) { return is_finite(w.at) && std::isfinite(w.width); });
}
bool finite(const Segment& segment) {
    struct {
        bool operator()(const LineSegment& s) const { return is_finite(s.to); }
        bool operator()(const CubicSegment& s) const {
            return is_finite(s.control1) && is_finite(s.control2) && is_finite(s.to);
        }
        bool operator()(const ArcSegment& s) const {
            return is_finite(s.center) && is_finite(s.u) && is_finite(s.v) && is_finite(s.to) &&
                   all_finite({s.start, s.sweep});
        }
    } each;
    return std::visit(each, segment);
}
bool finite(const Polygon& polygon) {
    return std::ranges::all_of(polygon, [](Point p) { return is_finite(p); });
}
bool finite(const Region& region) {
    return finite(region.outer) &&
           std::ranges::all_of(region.holes, [](const Polygon& hole) { return finite(hole); });
}
bool finite(const Element& element) {
    if (const auto* line = std::get_if<LineElement>(&element.what))
        return is_finite(line->path.start) &&
               std::ranges::all_of(line->path.segments, [](const Segment& s) { return finite(s); });
    return finite(std::get<RegionElement>(element.what).region);
}

/// A number that is none makes every comparison false: nothing else can be proved about such a plan.
void check_finite(const Plan& plan, Faults& faults) {
    const auto fault = [&](const std::string& what, Point at, int sample, int stroke, int element) {
        faults.add(1, {Law::finite, what + " holds a number that is not finite, allowed none", at, sample,
                       stroke, element});
    };
    if (!finite(plan.robot)) fault("the robot", {}, -1, -1, -1);
    if (!all_finite({plan.drawing.canvas.width, plan.drawing.canvas.height, plan.options.canvas.run_out}))
        fault("the canvas", {}, -1, -1, -1);
    const DriveArea area = drive_area_of(plan);
    if (!finite(area.border) ||
        !std::ranges::all_of(area.keep_out, [](const Region& r) { return finite(r); }))
        fault("the field", {}, -1, -1, -1);
    for (std::size_t e = 0; e < plan.drawing.elements.size(); ++e)
        if (!finite(plan.drawing.elements[e]))
            fault(fmt::format("element {}", e), {}, -1, -1, static_cast<int>(e));
    for (std::size_t k = 0; k < plan.strokes.size(); ++k)
        if (!std::ranges::all_of(plan.strokes[k].rake_path, [](const Curve& c) { return finite(c); }))
            fault(fmt::format("stroke {}", k), {}, -1, static_cast<int>(k), plan.strokes[k].element);
    for (const PlannedConnection& c : plan.connections)
        if (!finite(c.curve) || !all_finite({c.turn_before, c.turn_after}))
            fault(fmt::format("the connection to stroke {}", c.to), {}, -1, c.to, -1);
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
        const Sample& s = plan.samples[i];
        if (finite(s)) continue;
        const Point known = is_finite(s.pose.at)                              ? s.pose.at
                            : i > 0 && is_finite(plan.samples[i - 1].pose.at) ? plan.samples[i - 1].pose.at
                                                                              : Point{};
        fault(fmt::format("sample {}", i), known, static_cast<int>(i), s.stroke, element_of(plan, s));
    }
}

/// What a person sees follows the size of the picture: 1 cm on a beach of 14 m, a tenth of a millimetre on a
/// sheet of paper.
double tolerance_for(const Canvas& canvas) {
    const Canvas beach;
    const double share = std::min(canvas.width, canvas.height) / std::min(beach.width, beach.height);
    constexpr double on_the_beach = 0.01, least = 1e-6;
    return std::max(least, on_the_beach * std::min(1.0, share));
}

/// Gaps between parts, or what is narrower than the rake left out: by the settings, or by the element's
/// hints.
bool asks_for_bare_sand(const Element& element, const strandline::Options& options) {
    strandline::Options own = options;
    for (const svg::Hint& hint : element.hints)
        if (is_fill_hint(hint)) static_cast<void>(set(own, hint));  // one that is wrong asks for nothing
    return own.fill.narrow == "warn" || (own.fill.style == "zigzag" && own.fill.part_inset > 0);
}

void check_sand(const Plan& plan, const Options& options, Faults& faults, Report& report,
                const Progress& progress) {
    sand::Options raster;
    raster.cell = 2 * options.tolerance;
    // Raking again within the rake's own width is one pass round a corner.
    raster.pass_gap = std::min(raster.pass_gap, 1.2 * plan.robot.rake_width());
    const sand::Sand sand = sand::simulate(plan, raster, progress);
    double area = 0, covered = 0, overdraw = 0;
    for (const sand::Account& account : sand.regions) {
        area += account.area;
        covered += account.covered;
        overdraw += account.overdraw;
        const Element& element = plan.drawing.elements[static_cast<std::size_t>(account.element)];
        // Smaller regions are left out because the options say so.
        if (account.area < plan.options.fill.min_area || account.area <= 0) continue;
        const double share = account.covered / account.area;
        // Where sand is to stay bare because the options say so, nothing raked at all is still a fault.
        const bool bare_asked = asks_for_bare_sand(element, plan.options);
        if (share >= (bare_asked ? std::numeric_limits<double>::min() : options.coverage_floor)) continue;
        const std::string name = element.id.empty()
                                     ? fmt::format("element {}", account.element)
                                     : fmt::format("element {} ({})", account.element, element.id);
        faults.add(1 - share,
                   {Law::drawn_once,
                    fmt::format("{} is {}: {:.1f} % of {:.3f} m^2 covered, least {:.1f} %", name,
                                share == 0 ? "not drawn" : "not filled", 100 * share, account.area,
                                100 * options.coverage_floor),
                    centroid(std::get<RegionElement>(element.what).region.outer), -1, -1, account.element});
    }
    if (area > 0) {
        report.coverage = covered / area;
        report.overdraw = overdraw / area;
        report.spill = sand.spill / area;
    }
    for (const sand::Bare& bare : sand.bare) report.bare.push_back({bare.at, bare.area, bare.element});
    for (const sand::Blemish& b : sand.blemishes) {
        report.blemishes.push_back({b.at, b.area, b.crossings, b.element, b.t});
        report.crossings += b.crossings;
        report.driven_over += b.area;
    }
}

}  // namespace

const char* name_of(Law law) {
    switch (law) {
        case Law::version:
            return "version";
        case Law::finite:
            return "finite";
        case Law::drawn_once:
            return "drawn-once";
        case Law::drawn_right:
            return "drawn-right";
        case Law::position:
            return "position";
        case Law::heading:
            return "heading";
        case Law::curvature:
            return "curvature";
        case Law::sharpness:
            return "sharpness";
        case Law::speed:
            return "speed";
        case Law::turn_rate:
            return "turn-rate";
        case Law::acceleration:
            return "acceleration";
        case Law::time:
            return "time";
        case Law::ends:
            return "ends";
        case Law::field:
            return "field";
        case Law::pins:
            return "pins";
        case Law::offset:
            return "offset";
        case Law::step:
            return "step";
    }
    return "";
}

Report prove(const Plan& plan, const Options& wished, const Progress& progress) {
    Options options = wished;
    if (options.tolerance <= 0) options.tolerance = tolerance_for(plan.drawing.canvas);
    Report report;
    Faults faults;
    if (plan.version != Plan::current_version) {
        // Another version's numbers mean something else: nothing more can be said.
        faults.add(1, {Law::version,
                       fmt::format("the plan is of version {}, this program reads version {}", plan.version,
                                   Plan::current_version),
                       {},
                       -1,
                       -1,
                       -1});
        report.faults = faults.take();
        return report;
    }
    check_finite(plan, faults);
    report.faults = faults.take();
    if (!report.faults.empty()) return report;
    check_drawn(plan, options, faults, report);
    check_motion(plan, faults, report);
    check_ends(plan, faults);
    check_sand(plan, options, faults, report, progress);
    measure_finished(plan, report);
    report.faults = faults.take();
    std::ranges::stable_sort(report.faults, {}, [](const Fault& f) { return f.law; });
    return report;
}

}  // namespace strandline::check
