#pragma once
// The Plan as values, its options and edits: no algorithm. What a plan file holds is exactly this
// (docs/plan-format.md).
#include <string>
#include <variant>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "input/drawing/drawing.hpp"
#include "machine/follow/follow.hpp"
#include "machine/robot/robot.hpp"
#include "machine/site/site.hpp"
#include "math/curve/curve.hpp"
#include "path/stroke/stroke.hpp"

namespace strandline {

// ---- options

/// All that can be set, with defaults. Lengths in metres, angles in radians. The table of settings() names
/// each field as "group.name" with its unit, range, choices and meaning: --set, settings files, docs and the
/// editor all read it.
struct Options {
    struct Fit {                   // "place.*"
        std::string mode = "fit";  // fit | actual | width | scale
        double width = 10, scale_denominator = 50;
        bool positioned = false;
        double x = 0, y = 0, rotate = 0;
        bool mirror = false;
        bool operator==(const Fit&) const = default;
    } place;
    struct Field {  // "canvas.*"
        double width = 14, height = 14, margin = 0.5;
        double run_out = -1;  // metres round the canvas the robot may use; < 0: 2 R + footprint
        bool operator==(const Field&) const = default;
    } canvas;
    struct Draw {  // "drawing.*"
        double tolerance = 0.002, join_tolerance = 0.005, min_length = 0.01;
        double simplify = 0, smooth = 0;  // metres; 0: lines stay as they are
        bool occlusion = true;
        std::string layers;           // names, separated by ";"; empty: all
        std::string rules;            // what rules_of() reads
        std::string tools = "asked";  // asked | layer | colour
        double dpi = 0;  // px to the inch in the SVG; 0: 96, or 90 in files of Inkscape before 0.92
        bool operator==(const Draw&) const = default;
    } drawing;
    struct Ink {  // "ink.*"
        double threshold = 0.9;
        bool invert = false;
        bool operator==(const Ink&) const = default;
    } ink;
    struct Trace {             // "trace.*": of pictures; in pixels
        double threshold = 0;  // 0: by Otsu's method
        int despeckle = 2;
        double alphamax = 1, opttolerance = 0.2;
        bool operator==(const Trace&) const = default;
    } trace;
    struct Text {  // "text.*": in SVGs
        bool substitutes =
            true;  // a font that is absent is replaced, with a warning; else its text is left out
        bool operator==(const Text&) const = default;
    } text;
    struct FillArea {                    // "fill.*"
        std::string style = "rings";     // rings | spiral | zigzag
        std::string inset = "offset";    // offset | skeleton
        std::string join = "half-step";  // half-step | nearest | alternating | longest-edge
        double shift = 3, spacing = 0, direction = 0;
        bool best_direction = true;
        std::string partition = "fitted";  // none | monotone | optimal-convex | fitted
        std::string cuts;                  // "x,y x,y; x,y x,y"
        std::string segments;              // "x,y direction=30deg; x,y style=rings"
        bool one_stroke = false, rake_turns = true;
        double part_inset = 0, min_area = 0.01;
        bool border = true;
        std::string narrow = "single-pass";
        std::string tips = "all";  // off | border | all
        bool lift_pins = true;
        bool operator==(const FillArea&) const = default;
    } fill;
    struct TourSearch {  // "tour.*"
        bool inner_first = true, has_start = false, has_end = false;
        double start_x = 0, start_y = 0, end_x = 0, end_y = 0;
        std::string method = "best";  // best | exact | nearest | file
        std::string cost = "driven";  // driven | straight
        bool grouped = false;
        int seed = 1, moves = 0, threads = 1;
        double time_limit = 0;
        bool operator==(const TourSearch&) const = default;
    } tour;
    struct Corner {  // "corner.*"
        double threshold = pi / 2, radius = 0.5, fill_radius = 0.1;
        std::string below = "exact", above = "loop";  // exact | round; loop | pivot | round
        bool operator==(const Corner&) const = default;
    } corner;
    struct Connect {                    // "connect.*"
        std::string style = "bounded";  // bounded | fair | spiro | bezier | straight
        double extra_length = 0.1;      // fair: share
        double min_length = 0.02;       // gaps shorter than this are joined directly
        bool operator==(const Connect&) const = default;
    } connect;
    struct Avoid {  // "avoid.*"
        bool finished = true;
        double clearance = -1;                     // metres; < 0: what the wheels reach
        double crossing_cost = 2, area_cost = 20;  // metres a crossing, metres a metre
        bool operator==(const Avoid&) const = default;
    } avoid;
    struct DriveField {                // "field.*": outlines_of() reads both
        std::string border, keep_out;  // empty border: the drawing's, or the canvas and its run-out
        bool operator==(const DriveField&) const = default;
    } field;
    struct Park {  // "park.*"
        bool parked = false;
        double x = 0, y = 0, heading = 0;
        std::string exit = "none";  // none | parked | outside | pose
        double exit_x = 0, exit_y = 0, exit_heading = 0;
        bool operator==(const Park&) const = default;
    } park;
    struct Samples {  // "trajectory.*"
        double step = 0.02;
        bool operator==(const Samples&) const = default;
    } trajectory;
    struct Where {  // "site.*"
        bool known = false;
        Site at;
        bool operator==(const Where&) const = default;
    } site;
    struct Mission {                                         // "mission.*": of ArduPilot and QGroundControl
        int items = 724, servo = 9, down = 1900, up = 1100;  // servo: microseconds
        double tolerance = 0.05;
        bool operator==(const Mission&) const = default;
    } mission;
    struct Gcode {  // "gcode.*": texts with {x} in them, \n between lines
        std::string begin = "G21\\nG90\\nG17\\n{up}", end = "{up}\\nG0 X0 Y0\\nM2";
        std::string down = "G1 Z0 F600", up = "G0 Z5", stop = "M0 ({why})";
        double feed = 0;  // mm/min; 0: the robot's speed
        bool operator==(const Gcode&) const = default;
    } gcode;
    struct Table {                     // "thr.*": of sand tables
        double radius = 0;             // 0: what holds everything drawn
        std::string ends = "nearest";  // nearest | rim | centre | drawn
        bool operator==(const Table&) const = default;
    } thr;
    struct Nav {  // "nav.*": of ROS
        std::string frame = "map", goals = "one", controller, goal_checker;
        bool operator==(const Nav&) const = default;
    } nav;
    bool operator==(const Options&) const = default;
};

/// One entry of the table of settings.
struct Setting {
    enum class Kind { length, angle, duration, number, integer, flag, choice, text };
    std::string key, meaning;
    Kind kind = Kind::number;
    double low = 0, high = 0;          ///< inclusive, in SI units, for numbers
    std::vector<std::string> choices;  ///< for choice
    std::string formerly;              ///< the option of 2014 that it follows, "" if none
    std::variant<double*, int*, bool*, std::string*> (*field)(Options&) = nullptr;
};
const std::vector<Setting>& settings();
/// "fill.spacing", "16cm" -> set. Error names the key, its range or choices; unknown keys get the nearest
/// known one.
Outcome<void> set(Options& options, const std::string& key, const std::string& value);
/// Text that set() reads back to the same value.
std::string get(const Options& options, const std::string& key);
std::string name_of(Setting::Kind kind);

// ---- hints and rules

/// Names that hints may have beside fill-* (any setting of the group fill): ink, pins, tool, order, start,
/// pause. Error: an unknown name, or a value that it cannot have.
Outcome<void> valid(const svg::Hint& hint);
/// A hint fill-*, and the setting of the group fill that it stands for. Error: as set() of the setting.
bool is_fill_hint(const svg::Hint& hint);
Outcome<void> set(Options& options, const svg::Hint& fill_hint);
/// "layer=Outline: pins=3; colour=#ff0000: tool=2, fill-style=zigzag". `*` in what is selected stands for any
/// letters. Error: what cannot be read, with the rule.
Outcome<std::vector<InkRule>> rules_of(const std::string& text);
/// "0,0 2,0 1,2; ..." -> outlines in metres on the canvas, three corners or more each. Error: which, and why.
Outcome<std::vector<Polygon>> outlines_of(const std::string& text, const std::string& place);
/// "a; b" -> the names.
std::vector<std::string> names_of(const std::string& text);

// ---- edits

/// A node of an element as a person names it: the element's id and the number of a node of its drawn path
/// (0 .. n-1; -1: the last).
struct NodeName {
    std::string element;
    int node = 0;
    bool operator==(const NodeName&) const = default;
};
struct LinkEdit {
    NodeName a, b;
    bool operator==(const LinkEdit&) const = default;
};
struct EntryEdit {
    NodeName at;
    bool operator==(const EntryEdit&) const = default;
};
struct DirectionEdit {
    std::string element, direction;  ///< forward | backward | ccw | cw
    bool operator==(const DirectionEdit&) const = default;
};
/// What a rule or an attribute of the file may ask (valid(svg::Hint)), for one element; later ones win, over
/// the file's too. "ink" = "off" takes the element out of the drawing, from under others it stays cut out.
struct HintEdit {
    std::string element, name, value;
    bool operator==(const HintEdit&) const = default;
};
/// Elements in the order in which they are driven; the others come where they fit. Goes before inner first.
struct OrderEdit {
    std::vector<std::string> elements;
    bool operator==(const OrderEdit&) const = default;
};
/// Lines drawn by hand on the canvas, metres. The first is the element of that id, the next are ID/2, ID/3
/// ...
struct DrawEdit {
    std::string element;
    std::vector<Path> paths;
    int pins = 1;
    double smooth = 0;  ///< metres: as smooth curves within this; 0: as they are
    bool operator==(const DrawEdit&) const = default;
};
/// What is driven from one element to the next is led through these poses of the robot's turning point, in
/// this order; through the same backwards where the second element comes first.
struct ThroughEdit {
    /// More than a hand puts in: each costs time with every plan.
    static constexpr std::size_t most_poses = 200;
    std::string from, to;
    std::vector<Pose> poses;
    /// Of the drives within one area (from and to are it): the one from here to there, places of the rake.
    std::optional<std::pair<Point, Point>> hop = {};
    bool operator==(const ThroughEdit&) const = default;
};
using Edit = std::variant<LinkEdit, EntryEdit, DirectionEdit, HintEdit, OrderEdit, DrawEdit, ThroughEdit>;

// ---- the plan

/// What is driven rake up from the end of strokes[from] to the start of strokes[to]; -1: from where the robot
/// was parked, or to the exit.
struct PlannedConnection {
    int from = -1, to = -1;                  ///< indices into Plan::strokes
    double turn_before = 0, turn_after = 0;  ///< turns on the spot, radians
    Curve curve;
    bool operator==(const PlannedConnection&) const = default;
};

/// Where the drive waits for a hand: another tool, or a layer whose name begins with "!".
struct Stop {
    std::string why;  ///< "tool 2", "pause !gold"
    int stroke = 0;   ///< index into Plan::strokes: the first one after the stop
    double time = 0;  ///< s, when the robot sets out for it
    bool operator==(const Stop&) const = default;
};

/// A place where something falls short.
struct Spot {
    std::string what;
    Point at;
    double amount = 0;  ///< metres, m^2 or a count, as `what` says
    bool operator==(const Spot&) const = default;
};

/// Figures the planner states. "rake" lengths are of the rake's centre Q, "robot" lengths of the turning
/// point P.
struct Figures {
    int elements = 0, lines = 0, regions = 0, strokes = 0;
    double drawn = 0;         ///< m of rake path, rake down
    double up_straight = 0;   ///< m, stroke end to stroke start, rake centre
    double up_dubins = 0;     ///< m, robot pose to robot pose, Dubins: the lower bound for this order
    double up_driven = 0;     ///< m driven by P between strokes (connections, leads), loops apart
    double loops_driven = 0;  ///< m driven in corner loops
    double in_driven = 0, out_driven = 0;  ///< m of up_driven before the first stroke, after the last
    double time = 0;                       ///< s
    double tightest_up = 0;                ///< largest |curvature| rake up on connections and loops, 1/m
    double tightest_drawn = 0;             ///< largest |curvature| of the robot path rake down, 1/m
    int corners_exact = 0, corners_rounded = 0, corners_looped = 0, corners_pivoted = 0;
    int direct = 0;     ///< gaps joined directly (under connect.min_length)
    int fallbacks = 0;  ///< anything done another way than asked; each has a warning
    bool tour_proven = false;
    int tour_parts = 0;      ///< neighbours finished together; 0: not asked for
    double tour_longer = 0;  ///< m, straight, that this took at first, before the driven search
    bool reproducible = true;
    double fill_area = 0, fill_swept = 0;  ///< m^2
    /// What the strokes of all areas leave when a bar goes along them exactly, shares of fill_area: raked,
    /// raked again, raked outside. What the robot makes of them is in the check's report.
    double fill_coverage = 0, fill_overdraw = 0, fill_spill = 0;
    int fill_hops = 0;         ///< rake-up moves over a width within areas
    int fill_drives_over = 0;  ///< times a path within an area enters finished sand of it
    bool operator==(const Figures&) const = default;
};

struct Plan {
    static constexpr int current_version = 1;
    int version = current_version;
    std::string program;  ///< "strandline 0.1.0"
    std::string title;    ///< name of the source
    Robot robot;
    Options options;
    std::vector<Edit> edits;
    std::vector<std::string> idle_edits;  ///< edits whose place is gone, as sentences
    Drawing drawing;
    std::vector<Stroke> strokes;  ///< in driving order
    std::vector<Entry> order;     ///< one per stroke, same order
    std::vector<PlannedConnection> connections;
    std::vector<Sample> samples;
    std::vector<Stop> stops;
    std::vector<Spot> undrivable;
    /// where rake up finished areas or lines are driven over, because no better way was found: metres, or
    /// crossings
    std::vector<Spot> blemishes;
    std::vector<Spot> bare;  ///< sand of areas that no stroke rakes: element, m^2; largest first
    Figures figures;
    Warnings warnings;
    bool operator==(const Plan&) const = default;
};

/// Where the robot's footprint must stay, and what it must not reach into.
struct DriveArea {
    Region border;
    std::vector<Region> keep_out;  ///< may overlap
};
/// border: of field.border, else the drawing's, both less the robot's setback, else the canvas grown by the
/// run-out. keep_out: those of field.keep_out and the drawing's. Texts that cannot be read hold nothing.
DriveArea drive_area_of(const Drawing& drawing, const Options& options, const Robot& robot);
DriveArea drive_area_of(const Plan& plan);
/// The border's box.
Box field_of(const Plan& plan);

}  // namespace strandline
