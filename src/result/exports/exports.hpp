#pragma once
// A plan as other programs and machines read it; docs/exports has a page a format. What a format can be told
// (where on earth, templates, limits) is in the plan's options: site.*, mission.*, gcode.*, thr.*, nav.*.
// Output is the same for the same plan, byte for byte.
#include <string>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "plan/model/model.hpp"

namespace strandline::exports {

struct File {
    std::string suffix;  ///< in the place of the name's extension: ".geojson", "_robot.txt"
    std::string bytes;
};
struct Written {
    std::vector<File> files;
    Warnings warnings;  ///< what was taken for granted, thinned or rounded
};

/// GeoJSON (RFC 7946): what is raked and what is driven as lines with properties, fences, stops.
Written geojson(const Plan& plan);
/// One nav_msgs/Path as YAML: the robot's path, pose by pose, with the time of each.
Written nav_path(const Plan& plan);
/// nav2_msgs/action/FollowPath goals as YAML: one, or a document for each time the rake goes up or down.
Written follow_path(const Plan& plan);
/// "QGC WPL 110" for ArduPilot rovers: waypoints thinned to mission.items, the rake by a servo. Error: the
/// thinned waypoints would leave the path by more than mission.tolerance. O(n log^2 n).
Outcome<Written> wpl(const Plan& plan);
/// The same mission as QGroundControl's .plan, with the fences.
Outcome<Written> qgc_plan(const Plan& plan);
/// G-code from the templates gcode.*: the track of the tool, millimetres. Error: a template that cannot be
/// filled in.
Outcome<Written> gcode(const Plan& plan);
/// .thr for sand tables: theta rho, one line without lifting. Error: nothing is drawn, or it does not fit
/// thr.radius.
Outcome<Written> thr(const Plan& plan);

/// What the caller chooses beside the plan's options.
struct Choice {
    bool robot_path = false;  ///< trace: of the turning point
};
struct Format {
    std::string name, what;
    std::vector<std::string> suffixes;  ///< of the files it writes, in that order
    std::string type;                   ///< "text/plain"
    bool stops = false;                 ///< it has a word for stops
    Outcome<Written> (*write)(const Plan&, const Choice&) = nullptr;
};
/// All texts that a plan can be exported to, those of result/formats among them.
const std::vector<Format>& table();

/// Sets what an export may be told. Error: as set() of the setting; a setting that only planning reads.
Outcome<void> set_for_export(Options& options, const std::string& key, const std::string& value);
/// What `from` tells exports, into `options`; the rest stays.
void take_export_options(Options& options, const Options& from);

}  // namespace strandline::exports
