// What check found, as JSON.
#include "result/formats/formats.hpp"
#include "result/formats/json_members.hpp"

namespace strandline::formats {
std::string write_report(const check::Report& report) {
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
    all.close();
    add(text, "\n");
    return text;
}

}  // namespace strandline::formats
