#pragma once
// What every picture of a plan shows, as values: grooves, trips, arrows, legend. The SVG writer and the PNG
// painter both draw this, so that they look alike. Metres on the canvas, y up; the lines are tracks of the
// rake's centre Q or of its pins, as driven.
#include <cstddef>
#include <string>
#include <vector>

#include "plan/model/model.hpp"

namespace strandline::sketch {

/// Samples first .. last (both included) between which one thing is done: the pins of `mask` are down, or
/// none is. Neighbouring runs share a sample. Runs without pins take connections, leads, loops and pivots
/// together; `draws` marks the ones that follow a stroke.
struct Run {
    std::size_t first = 0, last = 0;
    unsigned mask = 0;
    int stroke = -1;
    bool draws = false;
    bool operator==(const Run&) const = default;
};
/// All of the plan's driving in order; fewer than two samples give none. O(samples).
std::vector<Run> runs(const std::vector<Sample>& samples);

/// Track of the point of the rake's bar that is `offset` metres left of its centre. Points that are not
/// finite are left out.
Polyline bar_track(const std::vector<Sample>& samples, const Run& run, double offset);

/// What neighbouring pins leave in one run: a band `width` wide along the track of its middle.
struct Groove {
    Run run;
    double offset = 0;  ///< of the band's middle on the bar, metres to the left
    int pins = 1;
    double width = 0;  ///< metres: pins x pitch
};
/// Driven with all pins up: the track of Q, and where arrows sit on it.
struct Trip {
    Run run;
    Polyline track;
    std::vector<Pose> arrows;
};
/// One entry of the legend: its sign begins at `at` (left middle), its text at `text_at` (left, on the base
/// line).
struct LegendItem {
    enum class Sign { groove, trip, start, end, keep_out, border, rule };
    Sign sign;
    Point at, text_at;
    double sign_width;
    std::string text;
};

/// Sizes of letters, arrows and lines are in metres, in proportion to `em`, the letter size: a picture looks
/// the same at any scale.
struct Sketch {
    Box canvas, view;  ///< view: all that is drawn, legend included
    double em = 0;
    std::vector<Region> keep_outs;
    Polygon border;               ///< of the field, where it is another than the canvas and its run-out
    std::vector<Groove> grooves;  ///< in driving order
    std::vector<Trip> trips;
    bool driven = false;         ///< false: no samples; start and end are meaningless
    Pose start;                  ///< Q of the first sample, heading of the robot
    Point end;                   ///< Q of the last sample
    std::string title, caption;  ///< caption: "14 x 14 m, 54.7 m drawn, ..."
    Point title_at, caption_at;
    std::vector<LegendItem> legend;
};
struct Options {
    bool arrows = true, legend = true;
};
/// O(samples). A canvas without extent, or one that overflows, gives a sketch that is not drawable: nothing
/// but its view is set.
Sketch sketched(const Plan& plan, const Options& options = {});
bool drawable(const Sketch& sketch);

/// Corners of an arrow head at the pose, its middle there, `size` long.
Polygon arrow_head(Pose pose, double size);

}  // namespace strandline::sketch
