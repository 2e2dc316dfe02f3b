#pragma once
// How true the sand is to the drawing: what a drive leaves, compared cell by cell with what was wanted.
#include <vector>

#include "plan/model/model.hpp"
#include "result/surface/surface.hpp"

namespace strandline::fidelity {

/// What is wrong with a patch of sand, worst last.
enum class Flaw {
    missing,        ///< wanted, and no pin went through
    stray,          ///< raked where the drawing is clean
    track,          ///< a wheel's mark where the drawing is clean
    track_on_line,  ///< ... in the groove of a finished line
    track_on_fill   ///< ... on a finished area
};
const char* name_of(Flaw flaw);
struct Place {
    Flaw flaw = Flaw::missing;
    Point at;
    double area = 0;  ///< m^2 of cells that hang together
};

/// Figures of the final sand. Areas in m^2, by the cells whose centres they hold.
struct Report {
    double cell = 0;
    /// Of the areas together. Raked sand counts whether or not it was rolled over later (that is `blemish`).
    double fill_area = 0, fill_perimeter = 0;
    double fill_union = 0;           ///< raked within areas over areas and what their strokes rake outside
    double coverage = 1, spill = 0;  ///< shares of fill_area: raked; raked outside by the areas' strokes
    double border_over = 0, border_missing = 0;  ///< cm per m of outline, within half a rake of it
    /// Of lines and areas together.
    double intersection_over_union = 1;
    double missing = 0, stray = 0, track = 0, track_on_line = 0, track_on_fill = 0;  ///< m^2, by Flaw
    /// Of lines. Lateral errors: the middle of the lowered pins from the line, metres.
    double line_length = 0, lateral_mean = 0, lateral_rms = 0, lateral_max = 0;
    /// Grooves across the line: their mean width less what was wanted, and the mean of the absolute
    /// differences.
    double width_bias = 0, width_error = 0;
    double undrawn = 0;         ///< m of lines whose middle no pin went through
    std::vector<Place> places;  ///< at least a pin square each, largest first
    /// Groove or wheel where it should be clean, and tracks on what is finished.
    double blemish() const { return stray + track + track_on_line + track_on_fill; }
};
struct Options {
    double cell = 0;  ///< metres; 0: surface::cell_for
};
struct Judged {
    Report report;
    surface::Surface sand;  ///< with what was wanted marked on it
};

/// What each sample draws by its stroke, -1: nothing.
std::vector<int> elements_of(const std::vector<Sample>& samples, const std::vector<Stroke>& strokes);
/// The drive of a plan: its samples, each with the element that it draws.
surface::Drive drive_of(const Plan& plan);
/// What each sample of a drive of unknown origin draws: each go with the rake down is given to the element
/// that most of its way is nearest to, lines by their distance, areas that hold it at distance 0.
/// O(samples x elements near).
std::vector<int> elements_drawn(const Drawing& drawing, const Robot& robot,
                                const std::vector<Sample>& samples);

/// Lays the drive and compares. O(cells + samples log).
Judged judged(const Drawing& drawing, const surface::Drive& drive, const Options& options = {},
              const Progress& progress = {});

}  // namespace strandline::fidelity
