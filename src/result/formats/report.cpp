// What check found, as JSON.
#include "result/formats/formats.hpp"
#include "result/formats/json_members.hpp"

namespace strandline::formats {
namespace {

void add_fidelity(Text& text, Members& all, const fidelity::Report& r) {
    all("cell", r.cell)("intersection_over_union", r.intersection_over_union);
    all("fill_area", r.fill_area)("fill_perimeter", r.fill_perimeter)("fill_union", r.fill_union);
    all("coverage", r.coverage)("spill", r.spill);
    all("border_over_cm", r.border_over)("border_missing_cm", r.border_missing);
    all("missing", r.missing)("stray", r.stray)("track", r.track)("track_on_line", r.track_on_line);
    all("track_on_fill", r.track_on_fill)("blemish", r.blemish());
    all("line_length", r.line_length)("lateral_mean", r.lateral_mean)("lateral_rms", r.lateral_rms);
    all("lateral_max", r.lateral_max)("width_bias", r.width_bias)("width_error", r.width_error);
    all("undrawn", r.undrawn);
    all.list("places", r.places, [&](const fidelity::Place& place) {
        Members one(text);
        one("flaw", std::string_view(fidelity::name_of(place.flaw)))("x", place.at.x)("y", place.at.y);
        one("area", place.area).close();
    });
}

}  // namespace

std::string write_report(const check::Report& report, const fidelity::Report* fidelity) {
    Text text;
    Members all(text);
    all.flag("sound", report.sound());
    all("drawn", report.drawn)("up_driven", report.up_driven)("time", report.time);
    all("coverage", report.coverage)("overdraw", report.overdraw)("spill", report.spill);
    all("crossings", report.crossings)("driven_over", report.driven_over)("over_finished",
                                                                          report.over_finished);
    all("max_curvature_up", report.max_curvature_up)("max_sharpness_up", report.max_sharpness_up);
    all("worst_offset", report.worst_offset);
    all.list("faults", report.faults, [&](const check::Fault& fault) {
        Members one(text);
        one("law", std::string_view(check::name_of(fault.law)))("what", std::string_view(fault.what));
        one("x", fault.at.x)("y", fault.at.y)("sample", fault.sample)("stroke", fault.stroke);
        one("element", fault.element).close();
    });
    all.list("bare", report.bare, [&](const check::Bare& bare) {
        Members one(text);
        one("x", bare.at.x)("y", bare.at.y)("area", bare.area)("element", bare.element).close();
    });
    all.list("blemishes", report.blemishes, [&](const check::Blemish& blemish) {
        Members one(text);
        one("x", blemish.at.x)("y", blemish.at.y)("area", blemish.area)("crossings", blemish.crossings);
        one("element", blemish.element)("t", blemish.t).close();
    });
    if (fidelity != nullptr)
        all.object("fidelity", [&](Members& one) { add_fidelity(text, one, *fidelity); });
    all.close();
    add(text, "\n");
    return text;
}

std::string write_fidelity(const Simulated& simulated) {
    Text text;
    Members all(text);
    all("time", simulated.time);
    if (simulated.planned_time) all("planned_time", *simulated.planned_time);
    if (simulated.same_sand) all("same_sand", *simulated.same_sand);
    if (const tracking::Driven* driven = simulated.driven) {
        all("tracking_mean", driven->mean)("tracking_rms", driven->rms)("tracking_max", driven->most);
        all.flag("lost", driven->lost);
    }
    add_fidelity(text, all, simulated.fidelity);
    all.close();
    add(text, "\n");
    return text;
}

}  // namespace strandline::formats
