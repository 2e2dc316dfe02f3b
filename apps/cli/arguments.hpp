#pragma once
// Texts of the command line and settings files -> values.
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "plan/model/model.hpp"

namespace strandline::cli {

/// A built-in robot's name, or a profile file.
Outcome<Robot> robot_named(const std::string& name);

/// What a plan is made with.
struct Wishes {
    std::string robot;                                              ///< name or file; "" : not said
    std::optional<std::string> profile = {};                        ///< of the robot, TOML: instead of a name
    std::vector<std::pair<std::string, std::string>> robot_fields;  ///< robot.FIELD=value, in order
    Options options;
    std::vector<Edit> edits;
    Warnings warnings;
};
/// Settings file: tables as in `strandline settings` ([fill] spacing = "36cm"); robot = "NAME", or [robot]
/// with base = "NAME" and FIELD = value; edits as lists of texts: link = ["a:0=b:-1"], entry = [...],
/// direction = [...]. Errors name the key and the line.
Outcome<void> read_settings_file(Wishes& wishes, const std::string& path);
/// --border and --keep-out: outlines as text, or files of GeoJSON (names that end in .geojson or .json),
/// which need the site. Keep-outs come to those of settings files.
Outcome<void> set_fences(Wishes& wishes, const std::string& border,
                         const std::vector<std::string>& keep_outs);
Outcome<void> set_from_text(Wishes& wishes, const std::string& key_and_value);
Outcome<Edit> parse_link(const std::string& text);
Outcome<Edit> parse_entry(const std::string& text);
Outcome<Edit> parse_direction(const std::string& text);
/// "fit", "actual", "width=10m", "scale=1:50".
Outcome<void> set_place(Options& options, const std::string& text);
/// "14mx10m", "20x10", "A4".
Outcome<void> set_canvas(Options& options, const std::string& text);
/// "X,Y" or "X,Y,HEADING" as settings whose names begin with `prefix`: "park." or "park.exit_".
Outcome<void> set_pose(Options& options, const std::string& prefix, const std::string& option,
                       const std::string& text);
/// "outside", "parked", or a pose.
Outcome<void> set_exit(Options& options, const std::string& text);
Outcome<void> set_drive_end(Options& options, const std::string& which, const std::string& text);

/// All that a call of plan wishes for: the settings file, the command line over it, both over the defaults of
/// the canvas that is wished for.
Outcome<Wishes> gathered(const PlanArguments& arguments);
Outcome<Robot> robot_of(const Wishes& wishes);

}  // namespace strandline::cli
