#pragma once
// Drawing, options, edits -> plan. Owns no search: it calls the rooms one after the other and keeps their
// accounts.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/svg/svg.hpp"
#include "input/trace/trace.hpp"
#include "path/trajectory/trajectory.hpp"
#include "plan/model/model.hpp"

namespace strandline {

/// A file to plan from.
struct Source {
    std::string_view bytes;  ///< all of it
    std::string title;       ///< its name, for people
};
/// The drawing in a file: SVG, or a picture (PNG, JPEG) that is traced; its first bytes tell which. Under
/// ink.invert the bright parts of a picture are traced. Errors as those of svg::read and trace.
Outcome<svg::Document> read_source(const Source& source, const Options& options,
                                   const Progress& progress = {});

/// The picture alone, with what was found out on the way. Error: the file is no picture.
Outcome<trace::Traced> trace_source(const Source& source, const Options& options,
                                    const Progress& progress = {});

/// What a file is to draw, before any edit: all that plans of it are held against. Errors as make_plan.
Outcome<Drawing> drawing_of(const Source& source, const Robot& robot, const Options& options,
                            const Progress& progress = {});

/// Whether these options ask of the robot what it can do. Error: the key and what to change.
Outcome<void> valid(const Options& options, const Robot& robot);

/// plan = f(drawing, options, edits). Deterministic: the same input, options and seed give the same plan bit
/// for bit, unless options.tour.time_limit or the user stopped the search (figures.reproducible says so).
/// Error: options that are not valid(); input at fault (place, reason, remedy); contradictory edits by name.
/// Edits whose place is gone are kept and listed as idle.
Outcome<Plan> make_plan(svg::Document document, const std::string& title, const Robot& robot,
                        const Options& options, const std::vector<Edit>& edits = {},
                        const Progress& progress = {});
/// From the file itself.
Outcome<Plan> make_plan(const Source& source, const Robot& robot, const Options& options,
                        const std::vector<Edit>& edits = {}, const Progress& progress = {});

/// What is shown until the plan is there. The samples are the plan's, where pins are lifted one by one,
/// something is told about single samples, or the drive waits; else they are left in pieces, those that did
/// not change the same objects as before, and the plan has none.
struct Draft {
    Plan plan;
    std::vector<trajectory::Placed> pieces;
};
/// With all samples. O(samples).
Plan whole(Draft draft);

/// Makes one plan after the other of a drawing that is being edited: the file read, the drawing and the
/// strokes of single elements are kept and made again only where what they follow from has changed, and so is
/// how strokes are driven. The plans are those of make_plan(). Holds the memory of two plans. One thread at a
/// time.
class Planner {
  public:
    Planner();
    ~Planner();
    Planner(Planner&&) noexcept;
    Planner& operator=(Planner&&) noexcept;
    Outcome<Plan> plan(const Source& source, const Robot& robot, const Options& options,
                       const std::vector<Edit>& edits = {}, const Progress& progress = {});
    /// Soon: the last plan's order mended, only what an edit touches connected anew (order::mended). What the
    /// search would gain, and ways round what is finished elsewhere by now, are left to plan(). Marked as not
    /// reproducible; times are those of the same drive planned in whole but for rounding.
    Outcome<Draft> draft(const Source& source, const Robot& robot, const Options& options,
                         const std::vector<Edit>& edits = {}, const Progress& progress = {});

  private:
    Outcome<Plan> plan_or_draft(const Source& source, const Robot& robot, const Options& options,
                                const std::vector<Edit>& edits, std::vector<trajectory::Placed>* draft,
                                const Progress& progress);
    struct Kept;
    std::unique_ptr<Kept> kept_;
};

/// A connection as it would be.
struct Leading {
    Curve curve;
    bool loops = false;  ///< the poses are too near to each other: somewhere the robot goes round in a loop
};
/// What a connection of the plan would be if it were led through these poses (ThroughEdit). Error: what makes
/// it impossible. About half a millisecond a pose.
Outcome<Leading> led_connection(const Plan& plan, int connection, const std::vector<Pose>& through);

/// The defaults of Options belong to a beach of 14 m. Here every length that follows the drawing's size
/// (margin, tolerances, least lengths and areas, sample spacing) is scaled down, never up, by the canvas's
/// shorter side, so that a sheet of paper is served too.
Options defaults_for(const Canvas& canvas);

}  // namespace strandline
