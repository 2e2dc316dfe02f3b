#pragma once
// Plan and stage values <-> text. Reads and writes strings only; the apps do files.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "plan/model/model.hpp"
#include "result/check/check.hpp"
#include "result/fidelity/fidelity.hpp"
#include "result/tracking/tracking.hpp"

namespace strandline::formats {

/// Versioned plan file (docs/plan-format.md). What is written, read back, is the same plan, bit for bit.
std::string write_plan(const Plan& plan);
/// The plan file's object "robot" alone, on one line.
std::string write_robot_json(const Robot& robot);
/// Error: not JSON (line, column), not a plan, another version, a field missing or of the wrong kind (its
/// JSON pointer), NaN.
Outcome<Plan> read_plan(std::string_view text, const std::string& place);

/// The table of settings: a list of {"key", "kind", "unit", "default", "choices" or "low" and "high",
/// "meaning"}, SI units, an object a line.
std::string write_settings_json();
/// The plan file's array "edits" alone: what the editor and its project files hold.
std::string write_edits(const std::vector<Edit>& edits);
/// Error: as read_plan; a hint that no element can have.
Outcome<std::vector<Edit>> read_edits(std::string_view text, const std::string& place);

/// The pair of 2014: NAME_robot.txt and NAME_rake.txt. Line i of both is the same instant: "x y mask";
/// metres, y up, origin lower left. A turn on the spot is one line with 128; the last line has 129.
struct BeachbotPair {
    std::string robot, rake;
};
BeachbotPair write_beachbot(const Plan& plan);
/// Input of the trace judges: targets, draw and travel moves of the rake path, or of the robot path.
std::string write_trace(const Plan& plan, bool robot_path);
/// SVG: rake down black at true width, rake up red with arrows, start dot, legend. `picture width` in px.
std::string write_svg(const Plan& plan);
/// s, t, x, y, heading, curvature, v, omega, pins, rake x, y: a line a sample.
std::string write_csv(const Plan& plan);
/// Figures as JSON for --json.
std::string write_figures(const Plan& plan);
/// What check found, as JSON: figures, faults, blemishes; and how true the sand is to the drawing, as
/// "fidelity", where that is known.
std::string write_report(const check::Report& report, const fidelity::Report* fidelity = nullptr);

/// A pair of 2014 -> the drive. Headings are from the rake to the turning point; a tool at the turning point
/// looks where it goes. Times follow from the robot's speeds. Error: a line that is not "x y rake", files of
/// different length.
Outcome<std::vector<Sample>> read_beachbot(std::string_view robot_text, std::string_view rake_text,
                                           const Robot& robot, const std::string& robot_place,
                                           const std::string& rake_place);
/// CSV with a first line of names: x, y, pins, and heading, t, rake_x, rake_y where known; others are passed
/// over. What write_csv writes is read back.
Outcome<std::vector<Sample>> read_drive_csv(std::string_view text, const Robot& robot,
                                            const std::string& place);
/// A tick of a simulated drive a line.
std::string write_log(const tracking::Driven& driven);
/// What a simulation found.
struct Simulated {
    fidelity::Report fidelity;
    double time = 0;  ///< s that were driven
    std::optional<double> planned_time;
    std::optional<double>
        same_sand;  ///< intersection over union with the sand of the plan it is held against
    const tracking::Driven* driven = nullptr;  ///< nullptr: no controller drove
};
/// As JSON: figures, then places of flaws.
std::string write_fidelity(const Simulated& simulated);

}  // namespace strandline::formats
