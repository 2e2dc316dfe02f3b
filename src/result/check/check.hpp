#pragma once
// Proves a plan from its file alone: never uses the rooms that planned it.
#include <string>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "plan/model/model.hpp"

namespace strandline::check {

enum class Law {
    version,
    finite,
    drawn_once,
    drawn_right,
    position,
    heading,
    curvature,
    sharpness,
    speed,
    turn_rate,
    acceleration,
    time,
    field,
    pins,
    offset,
    ends,
    step
};
const char* name_of(Law law);

/// A broken law, with its place: the worst spot of each run of neighbouring samples.
struct Fault {
    Law law;
    std::string what;  ///< one sentence with figures: found and allowed
    Point at;
    int sample = -1, stroke = -1, element = -1;
};
/// Finished ground driven over: allowed, but listed.
struct Blemish {
    Point at;
    double area = 0;  ///< m^2
    int crossings = 0;
    int element = -1;
    double t = 0;
};
/// Sand of a region that no pin raked: corners, turns, narrow parts.
struct Bare {
    Point at;
    double area = 0;  ///< m^2
    int element = -1;
};
struct Report {
    std::vector<Fault> faults;
    std::vector<Blemish> blemishes;
    std::vector<Bare> bare;  ///< largest first
    // re-measured from samples and elements, not copied from the plan's own figures
    double drawn = 0, up_driven = 0, time = 0;
    double coverage = 1, overdraw = 0, spill = 0;  ///< of the regions' area together
    int crossings = 0;                             ///< of finished lines
    double driven_over = 0;                        ///< m^2 of finished regions
    /// m that P goes between strokes within areas all of whose strokes are drawn; the way out of the area
    /// just finished apart
    double over_finished = 0;
    double max_curvature_up = 0, max_sharpness_up = 0;
    double worst_offset = 0;  ///< m, rake from where the drawing has it
    bool sound() const { return faults.empty(); }
};
struct Options {
    double tolerance = 0;  ///< m: rake from its element's line, besides what corner rounding explains; 0: 1
                           ///< cm on a canvas of 14 m, less on a smaller one
    double coverage_floor = 0.80;  ///< least coverage of a region that counts as drawn
};
/// O(samples x log + raster).
Report prove(const Plan& plan, const Options& options = {}, const Progress& progress = {});

}  // namespace strandline::check
